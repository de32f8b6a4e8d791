#pragma once

#include <optional>
#include <vector>

#include "collisions/piece.hpp"
#include "collisions/piece_store.hpp"

/// Ranges of which nothing is known where the maximum steps.
namespace dumbbell::collisions {

/// Plans pieces of one value where both ends of a part seem to have it; parts with different ends, and those
/// whose proof fails, are halved, and the narrowest are gaps or open. Where the maximum grows with the ratio
/// there is one piece from gap to gap.
class Halving {
  public:
    /// Both outlive this; `store` may be nullptr.
    Halving(const Claim& claim, const PieceStore* store, Interrupted interrupted);

    /// The pieces to be proved next, none at the end. `proved`: the last ones, of which those that are halved
    /// are taken out.
    [[nodiscard]] std::vector<PlannedPiece> next(std::vector<ProvedPiece>& proved);

  private:
    using Maximum = std::optional<Count>;
    struct Part {
        Range range;
        Maximum at_lo, at_hi;  ///< what seems to be the maximum there
    };

    [[nodiscard]] std::vector<Maximum> maxima_at(const std::vector<Rational>& ratios, int bits) const;
    [[nodiscard]] bool is_narrow(const Part& part) const;
    [[nodiscard]] bool is_to_be_proved(const Part& part) const;
    [[nodiscard]] std::vector<Part> halves_of(const std::vector<Part>& parts) const;
    void merge_equal();

    const Claim& claim_;
    Interrupted interrupted_;
    std::vector<Range> kept_;  ///< by an earlier run
    std::vector<Part> tried_;  ///< those whose pieces were planned last
    bool begun_ = false;
};

}  // namespace dumbbell::collisions
