#pragma once

#include <string>

#include "cli/pages/command_table.hpp"

namespace dumbbell::pages {

/// The page dumbbell(1), for man and groff: every command with every option.
[[nodiscard]] std::string man_page(const CommandEntry& program);

}  // namespace dumbbell::pages
