#pragma once

#include <fmt/core.h>

#include <string>
#include <string_view>
#include <utility>

#include "file/sha256.hpp"

namespace dumbbell {

struct Generator;

/// A text whose last line is `sha256 HEX` of all before it.
struct SealedText {
    std::string text;
    std::string sha256;
};

/// Writes such a text.
class SealedLines {
  public:
    template <class... Args>
    void line(fmt::format_string<Args...> format, Args&&... args) {
        text_ += fmt::format(format, std::forward<Args>(args)...);
        text_ += '\n';
    }
    void head(const Generator& generator, std::string_view lemmas, std::string_view scene,
              std::string_view section, std::string_view claim);
    /// Lines as they are, each with its end.
    void lines(std::string_view text) { text_ += text; }

    [[nodiscard]] SealedText sealed() && {
        std::string hash = sha256_hex(text_);
        line("sha256 {}", hash);
        return {std::move(text_), std::move(hash)};
    }

  private:
    std::string text_;
};

/// The SHA-256 in the last line of a certificate, if it is the one of the text before it. Throws InputError
/// if it is not, or if there is none: the file is damaged, incomplete or no certificate. (It proves nothing:
/// whoever forges a file can compute one.)
[[nodiscard]] std::string sealed_digest(const std::string& path);

}  // namespace dumbbell
