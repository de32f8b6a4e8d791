#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace dumbbell {

/// Two lower-case digits for each byte.
[[nodiscard]] inline std::string hexadecimal(const unsigned char* bytes, std::size_t size) {
    constexpr std::string_view digits = "0123456789abcdef";
    std::string text;
    text.reserve(2 * size);
    for (std::size_t i = 0; i < size; ++i) {
        text += digits[bytes[i] >> 4U];
        text += digits[bytes[i] & 15U];
    }
    return text;
}

}  // namespace dumbbell
