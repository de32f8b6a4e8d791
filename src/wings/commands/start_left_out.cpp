#include "cli/commands/start_in_the_air.hpp"

namespace dumbbell::cli {

StartInTheAir start_in_the_air(const collisions::Witness& /*witness*/, const Rational& /*q*/,
                               const Interrupted& /*interrupted*/) {
    return {{}, "this dumbbell was built without the wing starts"};
}

}  // namespace dumbbell::cli
