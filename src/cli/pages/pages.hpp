#pragma once

#include <string>
#include <string_view>

#include "cli/options/option.hpp"

/// What is made from the table of commands and options.
namespace dumbbell::cli::pages {

/// The --help of a command: its options in the words of the man page, in lines of at most 120 columns. Of one
/// that is nothing but its commands: each of these in a line, on one screen; the whole of its description
/// stands in the manual. `topic`: which of the command's, so that this alone is printed; empty: none.
[[nodiscard]] std::string help(const Command& program, const Command& command, std::string_view topic);

/// The page dumbbell(1), for man and groff: every command with every option.
[[nodiscard]] std::string man_page(const Command& program);

/// docs/reference/commands.md: every command with every option, in Markdown.
[[nodiscard]] std::string reference(const Command& program);

}  // namespace dumbbell::cli::pages
