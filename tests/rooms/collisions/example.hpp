// Certificates made by hand for the tests of this folder, and of tests/rooms/wings/pictures.
#pragma once

#include "collisions/certificate.hpp"

namespace dumbbell_test {

using namespace dumbbell;
using namespace dumbbell::collisions;

inline Node count(long forward, long backward) { return {std::nullopt, {Reason::count, forward, backward}}; }
inline Node leaf(Reason reason) { return {std::nullopt, {reason}}; }
inline Node split(Axis axis) { return {axis, {}}; }

inline Cover cover_of(Tree bridge, Tree light) {
    Cover cover;
    cover.charts = {{Chart::bridge, std::move(bridge)}, {Chart::light, std::move(light)}};
    return cover;
}

inline Piece piece(const Rational& lo, const Rational& hi, long upper, long lower) {
    Piece result;
    result.q_lo = lo;
    result.q_hi = hi;
    result.upper = upper;
    result.cover = cover_of({count(1, 2)}, {count(1, 1)});
    result.lower = lower;
    result.witness = Witness{Rational(1, 2), Rational(1, 2), 1, lower - 2};
    return result;
}

inline Piece open_piece(const Rational& lo, const Rational& hi) {
    Piece result;
    result.q_lo = lo;
    result.q_hi = hi;
    return result;
}

inline Piece equal_masses() {
    Piece result = piece(1, 1, 2, 2);
    result.cover = Cover();
    result.cover.equal_masses = true;
    return result;
}

inline Certificate certificate_of(std::vector<Piece> pieces) {
    return {{"dumbbell", "0.1.0"}, std::move(pieces)};
}

// Every kind of line: an equal-masses piece, a gap with all leaf reasons and all axes, an open piece.
inline Certificate every_kind_of_line() {
    Piece gap = piece(1, Rational(9, 2), 4, 3);
    gap.bits = 128;
    gap.cover =
        cover_of({split(Axis::position), count(1, 2), split(Axis::slope), count(0, 3), leaf(Reason::outside)},
                 {split(Axis::slope), split(Axis::ratio), leaf(Reason::meets), leaf(Reason::meets_reversed),
                  count(3, 0)});
    gap.witness = Witness{Rational(3, 8), Rational(1, 1024), 1, 1};
    return certificate_of({equal_masses(), gap, open_piece(Rational(9, 2), Rational(14, 3))});
}

}  // namespace dumbbell_test
