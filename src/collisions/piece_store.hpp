#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "base/observer.hpp"
#include "collisions/certificate.hpp"
#include "collisions/plan.hpp"
#include "file/folder_lock.hpp"

namespace dumbbell::collisions {

/// The finished pieces of a long run in a folder, so that a run that was killed goes on where it was. Each
/// piece is a file of its own, a complete certificate that `dumbbell-verify` accepts, with a name that
/// depends on nothing but what it claims. The folder belongs to one claim of one version of the program, and
/// to one run at a time. Throws InputError, and changes nothing, if the folder has pieces of another claim,
/// is none of these, or is in use; a damaged or lost claim is made again if the pieces are of this one, which
/// their names tell. May be used by several threads at once.
class PieceStore {
  public:
    /// Opens the folder, or makes it.
    PieceStore(std::string folder, const Claim& claim);
    ~PieceStore();
    PieceStore(const PieceStore&) = delete;
    PieceStore& operator=(const PieceStore&) = delete;

    /// For a run that keeps no pieces: throws InputError if there is such a folder.
    static void require_none(const std::string& folder);

    /// The piece with these bounds, if it was kept and its file is whole. A damaged file is as good as none:
    /// the observer is told its name. Throws InputError if its name is no file's.
    [[nodiscard]] std::optional<Piece> find(const PlannedPiece& planned, Observer& observer = nobody) const;

    /// The kept pieces, in ascending order. A damaged file is as good as none.
    [[nodiscard]] std::vector<Piece> kept() const;

    /// Those that tile a part of the claim from its lower end on, in ascending order, as far as
    /// behind a gap (or the whole claim): from there on a plan goes on as it would have.
    [[nodiscard]] std::vector<Piece> beginning() const;

    /// Keeps the piece, whatever happens to the program; of what a crash of the machine spoils, `find` finds
    /// nothing. Precondition: its bounds are the planned ones.
    void keep(const Piece& piece) const;

    /// How many pieces the folder has.
    [[nodiscard]] std::size_t size() const;

    /// Nothing is needed any more: removes the folder.
    void remove();

  private:
    [[nodiscard]] std::string file_of(const PlannedPiece& planned) const;
    /// What a piece's file holds: the piece if it is whole, decided, and of this store's system.
    struct Kept {
        bool damaged = false;  ///< the last line is not the checksum of the others
        std::optional<Piece> piece;
    };
    [[nodiscard]] Kept kept_in(const std::string& file) const;
    [[nodiscard]] bool has_no_others_pieces(const std::string& claim) const;

    std::string folder_;
    Claim claim_;
    std::string text_;  ///< of the claim

    FolderLock lock_;
};

}  // namespace dumbbell::collisions
