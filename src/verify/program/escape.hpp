// File names may hold any bytes: how they, and reasons, are written into lines and JSON.
#pragma once
#include <string>
#include <string_view>

namespace dumbbell_verify {

/// A file's name to begin a line with: on one line, and like no verdict and no summary.
std::string leading_name(std::string_view name);

/// On one line, for a terminal: control characters (C1, too) become `?`, bytes that are not UTF-8 U+FFFD.
std::string one_line(std::string_view text);
/// A JSON string with its quotes; bytes that are not UTF-8 become U+FFFD.
std::string json_string(std::string_view text);

}  // namespace dumbbell_verify
