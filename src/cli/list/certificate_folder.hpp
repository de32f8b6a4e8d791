#pragma once

#include <fstream>
#include <string>

namespace dumbbell::cli {

/// Where the certificates of a list are kept: `000012.dbc` is that of line 12, and `claims.tsv` names those
/// that are there, each with the claim that it proves, for `dumbbell-verify --claims`.
class CertificateFolder {
  public:
    /// Makes the folder; an empty name: none is wanted. Throws InputError for one that has files.
    explicit CertificateFolder(std::string folder);

    /// The name of a line's certificate; empty if none is wanted.
    [[nodiscard]] std::string file(long line) const;

    /// Throws InputError if it cannot be written. Without a claim `claims.tsv` does not name it.
    void keep(long line, const std::string& certificate, const std::string& claim);

  private:
    std::string folder_;
    std::ofstream claims_;
};

}  // namespace dumbbell::cli
