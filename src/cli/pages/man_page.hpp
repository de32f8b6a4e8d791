#pragma once

#include <string>

#include "cli/options/option.hpp"

namespace dumbbell::cli::pages {

/// The page dumbbell(1), for man and groff: every command with every option.
[[nodiscard]] std::string man_page(const Command& program);

}  // namespace dumbbell::cli::pages
