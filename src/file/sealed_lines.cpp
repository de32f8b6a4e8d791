#include "file/sealed_lines.hpp"

#include "base/error.hpp"
#include "file/lines.hpp"
#include "file/unpacked_text.hpp"

namespace dumbbell {

void SealedLines::head(const Generator& generator, std::string_view lemmas, std::string_view scene,
                       std::string_view section, std::string_view claim) {
    line("dumbbell-certificate 1");
    line("generator {} {}", generator.program, generator.version);
    line("lemmas {}", lemmas);
    line("scene {}", scene);
    line("section {}", section);
    line("claim {}", claim);
}

void SealedLines::lines(std::string_view text) {
    constexpr std::size_t part = 1 << 16;
    text_ += text;
    if (sink_ && text_.size() >= part) {
        hand_on();
    }
}

SealedText SealedLines::sealed() && {
    digest_.add(text_);
    std::string hash = digest_.hex();
    text_ += fmt::format("sha256 {}\n", hash);
    if (sink_) {
        hand_on();
    }
    return {std::move(text_), std::move(hash)};
}

void SealedLines::hand_on() {
    digest_.add(text_);
    sink_(text_);
    text_.clear();
}

std::string sealed_digest(const NamedFile& file) {
    constexpr std::string_view first_line = "dumbbell-certificate 1\n", seal = "sha256 ";
    UnpackedText text(file);
    if (text.next_line() != first_line) {
        throw InputError(fmt::format("'{}' is not a certificate: its first line is not '{}'", file.path,
                                     first_line.substr(0, first_line.size() - 1)));
    }
    Sha256 digest;
    digest.add(first_line);
    std::string_view line = text.next_line();
    for (; !line.empty() && !line.starts_with(seal); line = text.next_line()) {
        digest.add(line);
    }
    std::string right = digest.hex();
    if (line == fmt::format("{}{}\n", seal, right) && text.next_line().empty()) {
        return right;
    }
    is_damaged(file.path);
}

void is_damaged(const std::string& path) {
    throw InputError(fmt::format(
        "'{}' is damaged: its last line is not the checksum of its text (dumbbell verify says more)", path));
}

}  // namespace dumbbell
