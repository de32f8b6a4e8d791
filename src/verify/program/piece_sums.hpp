// What any consecutive pieces of a file say together, in few steps for each question.
#pragma once
#include <vector>

#include "verify/format/claim.hpp"

namespace dumbbell_verify {

/// As in a verdict, of some pieces.
struct Bounds {
    std::optional<mpz_class> upper;  ///< the largest; none if a piece has none
    mpz_class lower;
    std::uint64_t gaps = 0, open = 0;
};

/// Of n pieces, in memory O(n); an answer takes O(log n).
class PieceSums {
  public:
    /// Of the pieces that the claim has kept.
    explicit PieceSums(const Collisions& claim);
    /// All of them must have been kept, and there must be one.
    [[nodiscard]] Bounds of(const Pieces& pieces) const;

  private:
    std::uint64_t first_, count_;
    std::vector<Bounds>
        nodes_;  ///< a segment tree: node i is about nodes 2i and 2i + 1, the pieces are leaves
};

}  // namespace dumbbell_verify
