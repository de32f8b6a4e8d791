#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "collisions/claim.hpp"
#include "file/sealed_lines.hpp"

/// What `dumbbell join` puts together.
namespace dumbbell::cli {

struct PartFile {
    std::string name;
    std::size_t number = 0;  ///< among all
    std::string fault{};     ///< why it is not believed; empty: it is
    std::optional<collisions::Range>
        range{};         ///< of one that is not believed what it claims, if that can be read
    std::string kind{};  ///< all parts have one
    std::size_t pieces = 0, open = 0;
};

class Parts {
  public:
    /// Of so many certificates; `gap` is for the commands, by default the widest of them all.
    Parts(std::size_t files, std::optional<Rational> gap);

    /// Verifies the file, the i-th of all, on so many threads, and keeps what it says. By different threads
    /// at once for different files. Throws NoVerdict.
    [[nodiscard]] PartFile take(std::size_t i, const std::string& name, int jobs);
    /// All files that were taken. Precondition: of one claim; each begins where the one before ends.
    [[nodiscard]] SealedText join(const std::vector<PartFile>& files) const;

    /// `the mass ratios 1 to 100`.
    [[nodiscard]] std::string words(const collisions::Range& range) const;
    /// That makes a part of this range, but for where it writes; `like` another file, if there is one.
    [[nodiscard]] std::string command(const collisions::Range& range, const PartFile* like) const;

  private:
    void tell(PartFile& file, const collisions::Claim& claim);

    std::vector<collisions::Certificate> certificates_;
    std::vector<collisions::Claim> claims_;
    std::optional<Rational> gap_;
};

/// What --range says of parts like this file. Throws InputError.
[[nodiscard]] collisions::Range parse_range(const std::string& text, const std::string& part);

}  // namespace dumbbell::cli
