// Tables of files and what a verifier must say of them: tests/attacks/false_claims/manifest.tsv, and the
// folders that
// --dump writes.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "examine.hpp"

namespace dumbbell_mutation {

/// One line: file, options, exit code, line, code, reason, why, with a tab between. The reason is a part of
/// the text after the code. For a verified file the line is 0, the code `-` and the reason the whole claim
/// of the verdict line from `ratio=` (or `claim=`) up to the checksum.
struct Entry {
    std::string file;  ///< relative to the table's folder
    std::string
        options;  ///< of dumbbell-verify: --ratio, --max, --min, --exactly, --scene, --claim; may be empty
    int exit = 0;
    std::uint64_t line = 0;
    std::string code, reason;
    std::string why;  ///< for people
};

/// Lines that begin with `#` say something to people. Throws std::runtime_error for a line that is none of
/// these.
[[nodiscard]] std::vector<Entry> read_manifest(const std::string& path);
[[nodiscard]] std::string manifest_text(const std::vector<Entry>& entries);

/// What the options ask for. Ratios are P/Q or LO:HI of these. Throws std::runtime_error for others.
[[nodiscard]] dumbbell_verify::Request settings_of(const std::string& options);

/// What the verifier says, as an entry without options and why.
[[nodiscard]] Entry entry_of(const Outcome& outcome);

/// Checks every file of the table; with a program by running it, else in this process. Returns one line for
/// each that is judged otherwise.
[[nodiscard]] std::string replay(const std::string& manifest, const std::string& program);

}  // namespace dumbbell_mutation
