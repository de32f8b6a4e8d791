#include "law/steps.hpp"

#include <atomic>
#include <cmath>

#include "collisions/piece.hpp"
#include "collisions/step_guess.hpp"
#include "law/certificate.hpp"
#include "number/parallel.hpp"

namespace dumbbell::law {
namespace {

constexpr int bits = 128;

/// The fraction of least denominator in [lo, hi], 0 < lo < hi, by continued fractions.
Rational simplest_between(const Rational& lo, const Rational& hi) {
    const Integer whole = numerator(lo) / denominator(lo);
    if (Rational(whole) == lo) {
        return lo;
    }
    if (Rational(whole + 1) <= hi) {
        return whole + 1;
    }
    return whole + 1 / simplest_between(1 / (hi - whole), 1 / (lo - whole));
}

/// ((n - 2 + delta)/C)^2 in plain doubles: the ratio at which C sqrt q - (n - 2) is delta.
double ratio_of(long n, double delta, double C) {
    const double root = (static_cast<double>(n - 2) + delta) / C;
    return root * root;
}

}  // namespace

StepEnds step_ends(long n, const Constants& constants) {
    const double q = collisions::guess_step(n);
    const double C = approximate(constants.C), strip = approximate(constants.c0) / std::sqrt(std::sqrt(q));
    const double least = ratio_of(n, n < 9 ? -0.115 : 0, C);
    const double greatest = ratio_of(n, n < 9 ? 0.02 : std::min(0.02, strip), C);
    // From a quarter to a half of the room on each side.
    const auto between = [](double x, double y) { return simplest_between(exact(x), exact(y)); };
    return {n == 3 ? Rational(1) : between(q - (q - least) / 2, q - (q - least) / 4),
            between(q + (greatest - q) / 4, q + (greatest - q) / 2)};
}

bool shows_the_law(long n, const StepEnds& ends, const Constants& constants) {
    const auto delta = [&](const Rational& q) {
        return constants.C * sqrt(enclose<BigInterval>(q)) - enclose<BigInterval>(Rational(n - 2));
    };
    const BigInterval least = delta(ends.below), greatest = delta(ends.above);
    const auto thousandths = [](long k) { return enclose<BigInterval>(Rational(Integer(k), Integer(1000))); };
    if (!certainly_at_most(thousandths(-115), least) || !certainly_at_most(greatest, thousandths(20))) {
        return false;
    }
    const BigInterval most = constants.c0 / sqrt(sqrt(enclose<BigInterval>(ends.above)));
    return n < 9 || (certainly_positive(least) && certainly_less(greatest, most));
}

std::optional<std::vector<collisions::Piece>> prove_steps(const Interrupted& interrupted,
                                                          Observer& observer) {
    const PrecisionScope scope(bits);
    const Constants constants;
    collisions::PieceOptions options = collisions::piece_options({});
    options.describes = false;
    options.interrupted = interrupted;
    std::vector<collisions::Piece> steps(last_step - first_step + 1);
    std::atomic<std::size_t> done = 0;
    std::atomic<bool> all = true;
    in_parallel(steps.size(), [&](std::size_t i) {
        const long n = first_step + static_cast<long>(i);
        if (!all || interrupted()) {
            all = false;
            return;
        }
        const StepEnds ends = step_ends(n, constants);
        steps[i] = collisions::prove_step(ends.below, ends.above, n, options).piece;
        if (!steps[i].upper || !steps[i].witness || !shows_the_law(n, ends, constants)) {
            all = false;
            return;
        }
        observer.update(++done, steps.size(), n);
    });
    return all ? std::optional(std::move(steps)) : std::nullopt;
}

}  // namespace dumbbell::law
