#pragma once

#include <string>

/// What the program says on stderr. None of these fails: where it cannot be written (a log on a full disk),
/// the exit code alone says what happened.
namespace dumbbell::cli {

/// The text as it is.
void say(const std::string& text);

/// One line, with the program's name before it: what went wrong, and what to do. On a terminal the name is
/// red, unless the environment variable NO_COLOR is set and not empty (no-color.org), or TERM is dumb or not
/// set.
void complain(const std::string& text);

/// The same way: what is good to know.
void remark(const std::string& text);

/// Is stderr a terminal that understands escape codes? Not if TERM is dumb or not set.
[[nodiscard]] bool stderr_is_terminal();

/// Whether all that was printed on the standard output has arrived. What a stream cannot write it forgets, so
/// this is asked once, at the end, for all commands.
[[nodiscard]] bool is_printed();
inline constexpr const char* not_printed = "cannot write the output: is the disk full, or the reader gone?";

}  // namespace dumbbell::cli
