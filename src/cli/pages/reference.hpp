#pragma once

#include <string>

#include "cli/pages/command_table.hpp"

namespace dumbbell::pages {

/// docs/reference/commands.md: every command with every option, in Markdown.
[[nodiscard]] std::string reference(const CommandEntry& program);

}  // namespace dumbbell::pages
