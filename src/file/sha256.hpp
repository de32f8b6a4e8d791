#pragma once

#include <nettle/sha2.h>

#include <optional>
#include <string>
#include <string_view>

namespace dumbbell {

/// The SHA-256 of bytes that come in parts.
class Sha256 {
  public:
    Sha256();
    void add(std::string_view bytes);
    /// 64 lower-case hexadecimal digits, of all since the last call.
    [[nodiscard]] std::string hex();

  private:
    sha256_ctx context_{};
};

/// That of bytes that are all there.
[[nodiscard]] std::string sha256_hex(std::string_view bytes);

/// All lines of a text but its last one, which must be `sha256 HEX` of them; nothing if it is not.
[[nodiscard]] std::optional<std::string_view> sealed_lines(std::string_view text);

}  // namespace dumbbell
