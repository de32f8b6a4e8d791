#pragma once

#include <fmt/core.h>

#include <string>
#include <string_view>
#include <utility>

#include "file/atomic_file.hpp"
#include "file/file_contents.hpp"
#include "file/sha256.hpp"

namespace dumbbell {

struct Generator;

/// A text whose last line is `sha256 HEX` of all before it.
struct SealedText {
    std::string text;
    std::string sha256;
};

/// Writes such a text: keeps it, or hands it to a sink, part after part.
class SealedLines {
  public:
    explicit SealedLines(Sink sink = nullptr) : sink_(std::move(sink)) {}

    template <class... Args>
    void line(fmt::format_string<Args...> format, Args&&... args) {
        lines(fmt::format(format, std::forward<Args>(args)...) + '\n');
    }
    void head(const Generator& generator, std::string_view lemmas, std::string_view scene,
              std::string_view section, std::string_view claim);
    /// Lines as they are, each with its end.
    void lines(std::string_view text);

    /// No text if a sink has it.
    [[nodiscard]] SealedText sealed() &&;

  private:
    /// What is kept, to the sink.
    void hand_on();

    Sink sink_;
    Sha256 digest_;     ///< of what the sink has
    std::string text_;  ///< the rest
};

/// The SHA-256 in the last line of a certificate, if it is the one of the text before it. Throws InputError
/// if it is not, or if there is none: the file is damaged, incomplete or no certificate. (It proves nothing:
/// whoever forges a file can compute one.)
[[nodiscard]] std::string sealed_digest(const NamedFile& file);

/// Throws InputError: the last line of the file is not the checksum of the others.
[[noreturn]] void is_damaged(const std::string& path);

}  // namespace dumbbell
