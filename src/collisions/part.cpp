#include "collisions/part.hpp"

namespace dumbbell::collisions {
namespace {

/// N steps about where `growth` sqrt q is a whole number: 0.8855951... is C of docs/10-law.md, by which N =
/// 2 + floor(C sqrt q - a little); the wedges step to n at cot^2(pi / (2 (n - 1))), which is about (2 (n - 1)
/// / pi)^2.
const Rational& growth(Scene scene) {
    static const Rational of_dumbbell = parse_rational("0.885595129452713911412021948915"),
                          of_wedges = parse_rational("1.570796326794896619231321691640");
    return scene == Scene::dumbbell ? of_dumbbell : of_wedges;
}

/// How many of 1/2, 3/2, 5/2, ... are at most growth sqrt q.
Integer halves_up_to(const Rational& q, Scene scene) {
    const Rational square = 4 * growth(scene) * growth(scene) * q;
    return (sqrt(numerator(square) / denominator(square)) + 1) / 2;
}

/// The mass ratio of the half number behind so many, rounded to 0.01; steps are 1 apart or more.
Rational between_steps(const Integer& halves, Scene scene) {
    const Rational root = Rational(2 * halves + 1) / (2 * growth(scene));
    const Rational hundredths = 100 * root * root;
    return {numerator(hundredths) / denominator(hundredths), 100};
}

}  // namespace

RatioPart part_of(const Part& part, Scene scene, const Rational& q_lo, const Rational& q_hi) {
    // Measured from 1 to 10^10 (--gap 1e-9): a step at growth sqrt q = x takes about 8 us (70 + x), at least
    // 0.6 and at most 1.6 times that. Its two pieces follow orbits of about x collisions.
    constexpr long fixed = 70;
    const auto [first, end] = steps_of(part, {halves_up_to(q_lo, scene), halves_up_to(q_hi, scene), fixed});
    return {part, q_lo, q_hi, part.number == 1 ? q_lo : between_steps(first, scene),
            part.number == part.of ? q_hi : between_steps(end, scene)};
}

}  // namespace dumbbell::collisions
