#pragma once

#include <cstddef>
#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>

/// Names and texts from elsewhere may hold anything, also what moves a terminal's cursor.
namespace dumbbell {

/// A text from elsewhere as one line for people: what is no printable ASCII is `?`, and of a text that is
/// longer than `most` characters the first ones, then `...`.
[[nodiscard]] std::string printable(std::string_view text, std::size_t most);

/// A name as one line: control characters (C0, DEL, and C1 as UTF-8 spells them) and bytes that are not UTF-8
/// are `?`; letters of any alphabet stay.
[[nodiscard]] std::string one_line(std::string_view name);

/// The name of a file as an argument of a command of ours, as a shell takes it: quoted where it must be, and
/// no option though it begins with a dash (a lone dash is the standard input). What `one_line` would hide is
/// spelled as bash and zsh read it, $'...', so that the word stays one line, too.
[[nodiscard]] std::string shell_file(const std::string& name);

/// The text with some of its characters spelled as another language wants them.
[[nodiscard]] std::string respelled(std::string_view text,
                                    std::initializer_list<std::pair<char, std::string_view>> spellings);

}  // namespace dumbbell
