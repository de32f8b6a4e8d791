#pragma once

#include "base/observer.hpp"
#include "collisions/certificate.hpp"
#include "collisions/cover.hpp"

namespace dumbbell::collisions {

struct PieceOptions {
    System system = {};
    bool parallel = false;  ///< use the arena's threads inside one piece
    /// The precision escalates up to here: 53 (double), then 128, 256, ... The file allows the verifier twice
    /// as many, or next to critical ratios a few more, and the format no more than 4096.
    int max_bits = 2048;
    std::size_t max_nodes = CoverOptions{}.max_nodes;
    Interrupted interrupted = never;
    Observer* observer = &nobody;  ///< told of boxes that are judged
    bool describes = true;         ///< margin and width of the witness orbit, for people, are wanted
};

/// The limits with which a claim about this system is proved, wherever it is.
[[nodiscard]] PieceOptions piece_options(const System& system);

/// Why a piece is open: the last thing that failed, at the last precision that was tried.
enum class Obstacle {
    none,
    time,     ///< it was interrupted
    maximum,  ///< a single ratio is too near a critical one to tell which bounds to prove
    witness,  ///< no orbit was found with coordinates that the format can spell
    boxes,    ///< more of them than the options allow
};

/// A piece with what its witness orbit looks like over the whole piece, for people: nothing in the
/// certificate depends on it.
struct ProvedPiece {
    Piece piece;
    double margin = 0;  ///< certified lower bound of the least grazing angle (radians) of the witness's
                        ///< collisions; 0: none known
    double width = 0;   ///< the widest enclosure of the centre of mass's height at a collision (rod
                        ///< length 1)
    double seconds = 0;
    Obstacle obstacle = Obstacle::none;  ///< none: not open
};

/// What the piece's witness orbit looks like (margin, width), in the piece's precision.
void describe_witness(ProvedPiece& proved);

/// Decides one ratio: upper = lower = N*(q), at the first precision that suffices. If none does the piece is
/// left open, with the best lower bound found.
[[nodiscard]] ProvedPiece prove_single(const Rational& q, const PieceOptions& options);

/// Proves `upper` and `lower` for all ratios of [q_lo, q_hi]; left open (no upper bound) where that fails.
[[nodiscard]] ProvedPiece prove_piece(const Rational& q_lo, const Rational& q_hi, long upper, long lower,
                                      const PieceOptions& options);

/// Where the maximum steps up to n: `upper` = n - 1 proved at q_lo alone, and `lower` = n at q_hi alone; left
/// open where that fails.
[[nodiscard]] ProvedPiece prove_step(const Rational& q_lo, const Rational& q_hi, long n,
                                     const PieceOptions& options);

}  // namespace dumbbell::collisions
