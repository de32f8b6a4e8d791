#include "collisions/part.hpp"

#include "collisions/scene.hpp"

namespace dumbbell::collisions {
namespace {

/// How many of 1/2, 3/2, 5/2, ... are at most growth sqrt q.
Integer halves_up_to(const Rational& q, const Rational& growth) {
    const Rational square = 4 * growth * growth * q;
    return (sqrt(numerator(square) / denominator(square)) + 1) / 2;
}

/// The mass ratio of the half number behind so many, rounded to 0.01; steps are 1 apart or more.
Rational between_steps(const Integer& halves, const Rational& growth) {
    const Rational root = Rational(2 * halves + 1) / (2 * growth);
    const Rational hundredths = 100 * root * root;
    return {numerator(hundredths) / denominator(hundredths), 100};
}

}  // namespace

RatioPart part_of(const Part& part, Scene scene, const Rational& q_lo, const Rational& q_hi) {
    // Measured from 1 to 10^10 (--gap 1e-9): a step at growth sqrt q = x takes about 8 us (70 + x), at least
    // 0.6 and at most 1.6 times that. Its two pieces follow orbits of about x collisions.
    constexpr long fixed = 70;
    const Rational growth = parse_rational(row_of(scene).growth);
    const auto [first, end] = steps_of(part, {halves_up_to(q_lo, growth), halves_up_to(q_hi, growth), fixed});
    return {part, q_lo, q_hi, part.number == 1 ? q_lo : between_steps(first, growth),
            part.number == part.of ? q_hi : between_steps(end, growth)};
}

}  // namespace dumbbell::collisions
