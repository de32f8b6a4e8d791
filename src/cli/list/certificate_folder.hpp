#pragma once

#include <string>

#include "file/folder_lock.hpp"

namespace dumbbell::cli {

/// Where the certificates of a list are kept: `000012.dbc` is that of line 12, and `claims.tsv` names those
/// that are there, each with the claim that it proves, for `dumbbell-verify --claims`. Until every line has
/// its certificate, whatever happens to the program, `claims.tsv` begins with a line that no reader takes for
/// a claim, so that it is refused as a whole.
class CertificateFolder {
  public:
    /// Makes the folder; an empty name: none is wanted. `claims_of`: on what the certificates depend besides
    /// their lines; empty: no claims are listed. Throws InputError for a folder that has files, unless an
    /// earlier run has left it, of the same and not complete.
    CertificateFolder(std::string folder, const std::string& claims_of);

    /// The name of a line's certificate; empty if none is wanted. If the file is there, an earlier run has
    /// made it.
    [[nodiscard]] std::string file(long line) const;

    /// Throws InputError if it cannot be written. Without a claim `claims.tsv` does not name it.
    void keep(long line, const std::string& certificate, const std::string& claim);

    /// Writes `claims.tsv`.
    void finish(bool is_complete) const;

  private:
    std::string folder_;
    std::string claims_file_;  ///< empty: none
    std::string not_complete_, claims_{};
    FolderLock lock_{};
};

}  // namespace dumbbell::cli
