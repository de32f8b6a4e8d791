// When does one mass come down to the floor next? Root isolation for y + ydot t + arm sin(phi + phidot t).
#pragma once

#include <optional>

#include "body.hpp"

namespace dumbbell_oracle {

template <class S>
struct NextContact {
    std::optional<S> time;  // least t > 0 at which the mass reaches the floor moving downwards
    S clearance;  // least height of the mass, in units of its arm, at a minimum that stays above the floor; 1
                  // if none
};

// `touching`: the mass stands on the floor at t = 0 and leaves it (that root is not counted again).
template <class S>
[[nodiscard]] NextContact<S> next_contact(const Dumbbell<S>& body, Mass mass, const State<S>& state,
                                          bool touching);

}  // namespace dumbbell_oracle
