#include "collisions/part.hpp"

#include "collisions/section.hpp"

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

/// The end of so many parts of equal width, rounded to a thousandth of that.
Rational even_cut(const Range& whole, long parts, long of) {
    const Rational width = (whole.hi - whole.lo) / of;
    Rational unit = 1;
    while (unit > width / 1000) {
        unit /= 10;
    }
    const Rational units = (whole.lo + parts * width) / unit;
    return numerator(units) / denominator(units) * unit;
}

}  // namespace

RatioPart part_of(const Part& part, const Claim& claim) {
    const Range& whole = claim.range;
    const SectionRow& row = staircase_of(claim.system);
    std::pair<Rational, Rational> ends;
    if (row.step) {
        // Measured from 1 to 10^10 (--gap 1e-9): a step at growth sqrt q = x takes about 8 us (70 + x), at
        // least 0.6 and at most 1.6 times that. Its two pieces follow orbits of about x collisions.
        constexpr long fixed = 70;
        const Rational growth = parse_rational(row.growth);
        const auto [first, end] =
            steps_of(part, {halves_up_to(whole.lo, growth), halves_up_to(whole.hi, growth), fixed});
        ends = {between_steps(first, growth), between_steps(end, growth)};
    } else {
        ends = {even_cut(whole, part.number - 1, part.of), even_cut(whole, part.number, part.of)};
    }
    return {part,
            whole,
            {part.number == 1 ? whole.lo : ends.first, part.number == part.of ? whole.hi : ends.second}};
}

}  // namespace dumbbell::collisions
