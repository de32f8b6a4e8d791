#pragma once

#include <fmt/core.h>

#include <cstddef>
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
    /// The head of a certificate.
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

/// Reads such a text. Throws InputError, which says `what` it should have been, if the checksum is not there
/// or not right, or a line is not as expected.
class SealedReader {
  public:
    SealedReader(std::string_view text, std::string_view what);

    /// The next line as it is.
    std::string_view line();
    /// The rest of the next line, which begins with `keyword` and a blank.
    std::string_view value(std::string_view keyword);
    /// The same, a number below 10^15.
    std::size_t number(std::string_view keyword);
    /// The next line, but stays before it; empty at the end.
    [[nodiscard]] std::string_view ahead() const;
    void end() const;

    [[noreturn]] void fail() const;

  private:
    std::string_view rest_;
    std::string_view what_;
};

/// A decimal number below 10^15 and nothing else; throws InputError.
[[nodiscard]] std::size_t parse_size(std::string_view word);

}  // namespace dumbbell
