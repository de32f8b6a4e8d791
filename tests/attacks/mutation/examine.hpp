// The verifier on a text, in this process: what `dumbbell-verify` would say.
#pragma once
#include <cstdint>
#include <optional>
#include <string>

#include "temporary_folder.hpp"
#include "verify/program/summary.hpp"

namespace dumbbell_mutation {

struct Outcome {
    dumbbell_verify::Verdict verdict = dumbbell_verify::Verdict::verified;
    std::uint64_t line = 0;
    std::string code, text;                          ///< why not; empty if verified
    std::optional<dumbbell_verify::Verified> proof;  ///< if verified

    [[nodiscard]] bool accepted() const { return verdict == dumbbell_verify::Verdict::verified; }
};

using dumbbell_test::write_file;

/// A file of this process for one text after the other, removed at the end. The last text stays readable in
/// it if the process ends by a signal.
class Scratch {
  public:
    Scratch();
    Scratch(const Scratch&) = delete;
    Scratch& operator=(const Scratch&) = delete;
    ~Scratch();
    [[nodiscard]] const std::string& path() const { return path_; }
    void write(const std::string& text) const;

  private:
    std::string path_;
};

[[nodiscard]] Outcome examine(const std::string& path, const dumbbell_verify::Request& settings);

/// What an accepted file proves, in one line: `upper=4 lower=4 gaps=0 open=0` and the like.
[[nodiscard]] std::string claim_without_scene(const dumbbell_verify::Verified& proof);

}  // namespace dumbbell_mutation
