#include "starts/cover/incoming.hpp"

namespace dumbbell::starts {
namespace {

constexpr int angle_bits = 256;

/// s sqrt(q/(1 - s^2)), 0 <= s < 1.
BigInterval spin(const Rational& s, const Rational& q) {
    return sqrt(enclose<BigInterval>(s * s * q / (Rational(1) - s * s)));
}

}  // namespace

Box incoming_box(const Rational& q, const std::optional<Rational>& rho) {
    const Rational beta2 = rho ? 1 / (1 + *rho) : q / (q + 1);
    const Rational y = beta2 * (Rational(1) + Rational(1, Integer(1) << 20U));
    return {{Rational(0), Rational(0), y, -beta2, q}, {Rational(2), Rational(1), y, -beta2, q}, rho};
}

bool is_unbounded(const Box& piece) { return piece.upper(Axis::phidot) >= 1; }

Box states_of_incoming(const Box& piece) {
    const PrecisionScope scope(angle_bits);
    Box box = piece;
    const auto half_turn = pi<BigInterval>();
    const auto angle = [&](const Rational& x) { return enclose<BigInterval>(x) * half_turn; };
    const Rational& q = piece.lower(Axis::ratio);
    const auto set = [&](Axis axis, const BigInterval& low, const BigInterval& high) {
        const auto i = static_cast<std::size_t>(axis);
        box.lo[i] = exact_lo(low);
        box.hi[i] = exact_hi(high);
    };
    set(Axis::phi, angle(piece.lower(Axis::phi)), angle(piece.upper(Axis::phi)));
    set(Axis::phidot, spin(piece.lower(Axis::phidot), q), spin(piece.upper(Axis::phidot), q));
    return box;
}

}  // namespace dumbbell::starts
