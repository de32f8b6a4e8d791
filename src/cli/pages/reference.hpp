#pragma once

#include <string>

#include "cli/options/option.hpp"

namespace dumbbell::cli::pages {

/// docs/reference/commands.md: every command with every option, in Markdown.
[[nodiscard]] std::string reference(const Command& program);

}  // namespace dumbbell::cli::pages
