#pragma once

#include <string>
#include <vector>

#include "flight/count.hpp"
#include "rooms/flight/hard_orbits.hpp"

/// One orbit, bounded by its lowest and its highest ray (L5), in any arithmetic: the very same templates of
/// src/flight with the intervals of other libraries show what a user would have got by picking one of them.
/// Each peer has the names of src/number in its own namespace, and a file of its own. The guesses of
/// Newton's iteration are this project's for all of them, and every bound is rigorous.
namespace dumbbell_bench {

using dumbbell_test::HardOrbit;

struct Bounds {
    long least, most;  ///< collisions; both stop at the cap
};
struct Arithmetic {
    std::string name;
    /// What is timed: the counts that proofs take.
    Bounds (*count)(const HardOrbit& orbit, long cap);
    /// The width of x at the last departure that is certain.
    double (*width)(const HardOrbit& orbit);
};

template <class I>
dumbbell_test::WallState<I> last_departure(const HardOrbit& orbit) {
    auto state = dumbbell_test::point<I>(orbit);
    dumbbell_test::End end{};
    while (const auto next = dumbbell_test::monotone_step(state, I(orbit.r), end)) {
        state = *next;
    }
    return state;
}

/// `Scope` is what the arithmetic wants around it.
template <class I, class Scope>
Arithmetic arithmetic(const std::string& name) {
    const auto count = [](const HardOrbit& orbit, long cap) {
        [[maybe_unused]] const Scope scope;
        const I x(orbit.x);
        const I kappa(orbit.kappa);
        const dumbbell::flight::Ray<I> ray{sin_cos(x).sin + kappa * (x + dumbbell::pi<I>()), kappa,
                                           I(orbit.r)};
        return Bounds{dumbbell::as_long(dumbbell::flight::count_at_least(ray, cap)),
                      dumbbell::as_long(dumbbell::flight::count_at_most(ray, cap))};
    };
    const auto width = [](const HardOrbit& orbit) {
        [[maybe_unused]] const Scope scope;
        const I x = last_departure<I>(orbit).x;
        return approximate(high_end(x) - low_end(x));
    };
    return {name, count, width};
}
struct NoScope {};

/// The guess in plain double, or at higher precision, for any type with `as_big(x)`.
template <class I>
dumbbell::flight::ContactGuess<I> guess_for(const I& c, const I& kappa, double start) {
    using namespace dumbbell;
    if constexpr (requires { as_big(c); }) {
        if (PrecisionScope::current() > double_bits) {
            const auto guess = flight::guess_contact(as_big(c), as_big(kappa), start);
            return {I(guess.z), guess.hits};
        }
    }
    const auto guess = flight::guess_contact(Interval(approximate(c)), Interval(approximate(kappa)), start);
    return {I(guess.z.lo()), guess.hits};
}

/// CGAL's and Boost's intervals of doubles. They have no sine: a user has to bring one, here this project's.
std::vector<Arithmetic> cgal_and_boost();
/// At PrecisionScope::current() bits, as BigInterval is.
Arithmetic mpfi();
Arithmetic arb();

}  // namespace dumbbell_bench
