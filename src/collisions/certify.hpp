#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <vector>

#include "base/observer.hpp"
#include "collisions/piece.hpp"
#include "collisions/piece_store.hpp"

namespace dumbbell::collisions {

struct CertifyRequest {
    Rational q_lo;  ///< >= 1
    Rational q_hi;  ///< >= q_lo; a single ratio if equal
    Scene scene = Scene::dumbbell;
    Section section = Section::turning;
    std::optional<Heights> heights = {};  ///< of the scene body, whose ratio is Q
    Rational gap = Rational(1, 1'000'000);
    int jobs = 1;
    std::optional<std::chrono::duration<double>> budget;
    bool describes = true;              ///< as in PieceOptions
    const PieceStore* store = nullptr;  ///< ranges: where finished pieces are kept, and found again
    /// Told of the boxes that are judged for a single ratio; for a range of the critical ratios that are
    /// placed, then in a phase of its own of the pieces that are finished, with the maximum that was looked
    /// for.
    Observer* observer = &nobody;
};

/// Proves the request piece by piece. Pieces that cannot be decided, or not within the budget, are left open.
/// The result does not depend on the number of jobs. Throws BrokenInvariant if the arithmetic of a thread is
/// not sound.
[[nodiscard]] std::vector<ProvedPiece> certify(const CertifyRequest& request);

/// Whether a line of a certificate has room for these two numbers.
[[nodiscard]] bool fit_a_line(const Rational& x, const Rational& y);

/// Why nothing is tried of the mass ratios, in a line for the user; nothing if they fit a line of a
/// certificate and are within reach: a single ratio of the dumbbell (turning section) up to 10^100, where one
/// orbit has about 10^50 collisions; others up to 10^36, where a count has 64 bits.
[[nodiscard]] std::optional<std::string> out_of_reach(const Rational& q_lo, const Rational& q_hi,
                                                      Scene scene = Scene::dumbbell,
                                                      Section section = Section::turning);

/// The share of [q_lo, q_hi] whose pieces are gaps or open, exactly; 0 for a single decided ratio, else 1.
[[nodiscard]] Rational undecided_share(const std::vector<ProvedPiece>& pieces);

}  // namespace dumbbell::collisions
