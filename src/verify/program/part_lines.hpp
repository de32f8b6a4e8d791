// The file of --combine: lines `s PART` that runs with --shards have printed, among others that they printed.
#pragma once
#include <array>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "verify/program/part.hpp"

namespace dumbbell_verify {

/// A line `s PART`. Of its fields only those that say what was checked are read: whether the others are right
/// is known when the file says what they must be.
struct PartLine {
    std::string_view text;  ///< after `s PART `
    Pieces pieces;
    unsigned precision = 0;
    std::array<std::string_view, std::tuple_size_v<Fields>> values;  ///< as in fields()
};

/// Lines that do not begin with `s ` are skipped. Any other one that is not `s PART` with its fields, or is
/// by another version of the verifier, is thrown as a Failure that names it. Memory does not grow with the
/// file, and one without end is a Failure, too.
class PartLines {
  public:
    /// Throws Failure if the file cannot be read.
    explicit PartLines(std::string path);
    /// The next line `s PART`, valid until the next call; nullptr: there is none.
    const PartLine* next();
    /// FILE:LINE of the present one.
    [[nodiscard]] std::string where() const { return path_ + ":" + std::to_string(number_); }

  private:
    bool next_line();
    bool parse();
    void require_this_version() const;

    std::string path_;
    std::unique_ptr<std::FILE, int (*)(std::FILE*)> file_;
    std::vector<char> block_ = std::vector<char>(1 << 16);
    std::string_view rest_;  ///< of the block
    std::uint64_t number_ = 0, bytes_ = 0;
    std::string line_;  ///< without its line feed
    PartLine part_;
};

}  // namespace dumbbell_verify
