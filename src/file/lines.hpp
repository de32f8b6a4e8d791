#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "file/sha256.hpp"
#include "file/unpacked_text.hpp"
#include "number/count.hpp"
#include "number/rational.hpp"

namespace dumbbell {

/// What wrote a certificate: this program, unless it was read.
struct Generator {
    std::string program = "dumbbell";
    std::string version = DUMBBELL_VERSION;
};

/// The first lines of every certificate.
struct Head {
    Generator generator;
    std::string lemmas, scene, section, claim;
};

/// The lines of a certificate file (plain or gzip), split into fields, for the readers of the prover's side.
/// Every failure is an InputError that names the file and the line.
class Lines {
  public:
    explicit Lines(const NamedFile& file);

    /// The next line's fields; valid until the next call.
    const std::vector<std::string>& next();

    /// The next line's fields; the first must be `keyword` and there must be `count` in all.
    const std::vector<std::string>& expect(std::string_view keyword, std::size_t count);

    /// From the format, which must be 1, to the claim.
    Head expect_head();

    /// Reads on to the line `sha256 HEX`: HEX, if it is that of all lines before, and no bytes follow; else
    /// nothing, for the verifier to say what is wrong. The verdict of the verifier names it, too.
    std::string digest();

    /// "... is not a certificate that this program can read (line ...)".
    [[noreturn]] void fail() const;

    /// The lexical classes of format.md, section 1, and `signed` of format-initial.md.
    [[nodiscard]] long number(const std::string& text) const;
    [[nodiscard]] Count count(const std::string& text) const;
    [[nodiscard]] Rational ratio(const std::string& text) const;
    [[nodiscard]] Rational signed_ratio(const std::string& text) const;
    [[nodiscard]] Rational dyadic(const std::string& text) const;

  private:
    /// With its end. False at the end of the file.
    bool read(std::string& line);

    std::string path_;
    UnpackedText text_;
    std::vector<std::string> fields_;
    long number_ = 0;
    Sha256 digest_;  // of the lines that `next` read
};

}  // namespace dumbbell
