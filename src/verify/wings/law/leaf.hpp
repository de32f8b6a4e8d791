// What a file of the claim kind `law` has to be checked, one thing after the other, and by which rule.
#pragma once
#include <array>
#include <string>

#include "verify/core/section.hpp"
#include "verify/wings/law/constants.hpp"

namespace dumbbell_verify::law {

/// A part of one of the three covers. The box: U and rho in the layer, the angle th in the bulk, d at the
/// end.
struct Box {
    std::array<mpq_class, 2> lo, hi;
};
/// What a rule knows of the steps; a test may know more, to see the rule alone.
struct States {
    mpq_class drift = J_drift, rise = J_rise;
    // In the bulk; in the layer and at the end these follow.
    mpq_class least_eps = 0, most_eps = law::most_eps;
    mpq_class least_Q = bulk_least_Q, most_Q = bulk_most_Q;  ///< less pi/2
    int parts = 12;                                          ///< of an integral in the layer
};
/// Made when it is first used: before main() nobody could say that there is no memory.
inline const States& known_states() {
    static const States states;
    return states;
}

struct Leaf {
    enum Rule { step, slope, beyond, bulk, end };
    static constexpr std::array<std::string_view, 5> names{"", "slope", "beyond", "bulk", "end"};

    Rule rule = step;
    std::size_t range = 0;  ///< of the bulk: 0, 1, 2
    std::uint64_t line = 0;
    unsigned bits = 53;
    bool multiple = false;
    const States* states = &known_states();
    Box box;
    dumbbell_verify::Leaf at_step;  ///< instead of the box, if it is a part of a step
};

/// nullptr if the rule of format-law.md certifies the leaf, else what is missing; a log gets lines for every
/// inequality. So do the other checks.
const char* check_layer(const Leaf& leaf, Log* log);
const char* check_bulk(const Leaf& leaf, Log* log);
const char* check_end(const Leaf& leaf, Log* log);

/// Certified for the whole bulk: |A| <= 2e-5 for all J in pi/2 + [-1e-5, eps^2/4], and no angle beyond its
/// ranges.
const char* check_bulk_window(unsigned bits, bool multiple, Log* log);
/// Certified for this arithmetic: the comparison function's constant k0 is the one that makes D/D0(T) = 1 at
/// U = 0.
const char* check_constant(unsigned bits, bool multiple, Log* log);

}  // namespace dumbbell_verify::law
