#include "file/sha256.hpp"

#include <fmt/core.h>
#include <openssl/evp.h>

#include <algorithm>
#include <array>

#include "base/error.hpp"
#include "base/hexadecimal.hpp"

namespace dumbbell {

std::string sha256_hex(std::string_view bytes) {
    std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
    unsigned int size = 0;
    require(EVP_Digest(bytes.data(), bytes.size(), digest.data(), &size, EVP_sha256(), nullptr) == 1 &&
                size == 32,
            "SHA-256 failed");
    return hexadecimal(digest.data(), size);
}

std::optional<std::string_view> sealed_lines(std::string_view text) {
    constexpr std::size_t seal = 72;  // `sha256 `, 64 digits, the line's end
    const std::string_view lines = text.substr(0, text.size() - std::min(text.size(), seal));
    const bool is_sealed = text.substr(lines.size()) == fmt::format("sha256 {}\n", sha256_hex(lines));
    return is_sealed ? std::optional(lines) : std::nullopt;
}

}  // namespace dumbbell
