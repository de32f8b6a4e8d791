// A report made by hand: an exact piece, a gap, an exact piece, and, if asked for, an open one.
#pragma once

#include "collisions/proof_report.hpp"
#include "example.hpp"

namespace dumbbell_test {

struct SampleReport {
    std::vector<dumbbell::collisions::Piece> pieces;
    dumbbell::collisions::ProofReport report{};

    explicit SampleReport(std::vector<dumbbell::collisions::Piece> of) : pieces(std::move(of)) {
        report.claim.range = {pieces.front().q_lo, pieces.back().q_hi};
        report.jobs = 2;
        report.seconds = 1.25;
        report.undecided = Rational(1, 4);
        for (const dumbbell::collisions::Piece& p : pieces) {
            report.rows.push_back({&p, 0.125, 1e-9, 0.5, {}});
        }
    }
    SampleReport(const SampleReport&) = delete;
    SampleReport& operator=(const SampleReport&) = delete;
};

inline std::vector<dumbbell::collisions::Piece> three_pieces() {
    const Rational left(46033367, 10000000);
    const Rational right(4603341, 1000000);
    return {piece(4, left, 3, 3), piece(left, right, 4, 3), piece(right, 5, 4, 4)};
}

inline std::vector<dumbbell::collisions::Piece> four_pieces() {
    auto pieces = three_pieces();
    pieces.push_back(open_piece(5, 12));
    return pieces;
}

// A collision with the given time and angle, and otherwise harmless numbers.
inline dumbbell::flight::Collision<Interval> collision(bool heavy, const Interval& time,
                                                       const Interval& phi) {
    return {heavy,           time,         phi, Interval(0.25), Interval(-0.5), Interval(0.5), Interval(-1),
            Interval(-0.75), Interval(0.5)};
}

}  // namespace dumbbell_test
