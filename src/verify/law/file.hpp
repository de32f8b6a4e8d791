// The file of the law on which files of the kind `collisions-by-law` rest.
#pragma once
#include <mutex>
#include <optional>
#include <string>

#include "verify/format/proof.hpp"
#include "verify/format/text.hpp"
#include "verify/law/claim.hpp"

namespace dumbbell_verify {

/// Verified when it is first asked for, and once for all files that rest on it.
class LawFile {
  public:
    explicit LawFile(std::string path) : path_(std::move(path)) {}
    /// What it proves, with the SHA-256 that is asked for. Throws the Failure of this file, which names it,
    /// or says that it is another one. Work on it has a budget of its own. May be called by several threads.
    const Law& verified(const std::string& digest, const Settings& settings);

  private:
    void verify(const Settings& settings);

    const std::string path_;
    std::once_flag once_;
    Law law_;
    std::string digest_;
    std::optional<Failure> why_;
};

}  // namespace dumbbell_verify
