#pragma once

#include <string>
#include <vector>

#include "cli/options/given.hpp"

/// What is wrong with a command line, in the user's own words, and what may help. `words`: those after the
/// program's name.
namespace dumbbell::cli {

/// What may help after a command line that was not understood: the command or option that was meant, if one
/// is spelled nearly so, and whose --help to read.
[[nodiscard]] std::string hint(const Command& program, const std::vector<std::string>& words);

/// Where a command should stand: what stands there instead, or which there are. A call for help needs none;
/// empty: nothing is wrong.
[[nodiscard]] std::string wrong_command(const Command& program, const std::vector<std::string>& words,
                                        bool asks_help);

/// The words that nothing expected, in the order given.
[[nodiscard]] std::string unexpected(const std::vector<std::string>& words);

/// An option that is given twice, or else the last word of the line, which lacks its value.
[[nodiscard]] std::string mismatch(const Given& given, const std::string& last_word);

/// Options that exclude each other, or that lack the one that they need; empty if there are none.
[[nodiscard]] std::string contradiction(const Given& given);

}  // namespace dumbbell::cli
