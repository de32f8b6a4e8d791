#include "cli/commands/start_in_the_air.hpp"

#include <fmt/core.h>

#include "starts/answer/witness_start.hpp"

namespace dumbbell::cli {

StartInTheAir start_in_the_air(const collisions::Witness& witness, const Rational& q,
                               const Interrupted& interrupted) {
    if (const auto start = starts::witness_start(witness, q, interrupted)) {
        return {start, ""};
    }
    return {{},
            witness.total() > starts::longest_witness
                ? fmt::format("it is looked for only along orbits of up to {} collisions",
                              starts::longest_witness)
                : "none near this orbit was proved to have as many collisions"};
}

}  // namespace dumbbell::cli
