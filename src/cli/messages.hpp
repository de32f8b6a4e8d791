#pragma once

#include <string>

/// What the program says on stderr: one line each, with its name before it.
namespace dumbbell {

/// What went wrong, and what to do. On a terminal the name is red, unless the environment variable NO_COLOR
/// is set and not empty (no-color.org) or TERM is dumb.
void complain(const std::string& text);

/// What is good to know.
void remark(const std::string& text);

}  // namespace dumbbell
