#include "file/sha256.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cstdint>

namespace dumbbell {

Sha256::Sha256() { sha256_init(&context_); }

void Sha256::add(std::string_view bytes) {
    sha256_update(&context_, bytes.size(), reinterpret_cast<const std::uint8_t*>(bytes.data()));
}

std::string Sha256::hex() {
    std::array<std::uint8_t, SHA256_DIGEST_SIZE> digest{};
    sha256_digest(&context_, digest.size(), digest.data());
    std::string text;
    for (const std::uint8_t byte : digest) {
        text += fmt::format("{:02x}", byte);
    }
    return text;
}

std::string sha256_hex(std::string_view bytes) {
    Sha256 digest;
    digest.add(bytes);
    return digest.hex();
}

std::optional<std::string_view> sealed_lines(std::string_view text) {
    constexpr std::size_t seal = 72;  // `sha256 `, 64 digits, the line's end
    const std::string_view lines = text.substr(0, text.size() - std::min(text.size(), seal));
    const bool is_sealed = text.substr(lines.size()) == fmt::format("sha256 {}\n", sha256_hex(lines));
    return is_sealed ? std::optional(lines) : std::nullopt;
}

}  // namespace dumbbell
