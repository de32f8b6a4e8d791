#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace dumbbell {

/// 64 lower-case hexadecimal digits.
[[nodiscard]] std::string sha256_hex(std::string_view bytes);

/// All lines of a text but its last one, which must be `sha256 HEX` of them; nothing if it is not.
[[nodiscard]] std::optional<std::string_view> sealed_lines(std::string_view text);

}  // namespace dumbbell
