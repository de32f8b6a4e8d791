#include "start_truth.hpp"

#include <cmath>
#include <sstream>
#include <stdexcept>

#include "target.hpp"

namespace dumbbell_fuzz {

std::optional<Run> simulated(const Start& start) {
    using dumbbell_oracle::Mass;
    constexpr Real least = 1e-6L;
    const auto& [phi, phidot, y, ydot, q] = start;
    const dumbbell_oracle::Dumbbell<Real> body(q);
    const dumbbell_oracle::State<Real> state{phi, phidot, y, ydot};
    const bool in_the_air =
        body.height(Mass::light, state) > least && body.height(Mass::heavy, state) > least;
    if (!in_the_air || (std::abs(phidot) < least && std::abs(ydot) < least)) return std::nullopt;
    constexpr std::size_t limit = 100'000;
    try {
        Run run = dumbbell_oracle::simulate(body, state, Mass::none, limit);
        return run.care.doubtful() ? std::nullopt : std::optional(std::move(run));
    } catch (const std::runtime_error&) {  // in a corner long double may bounce for ever
        return std::nullopt;
    }
}

void must_be_between(const Run& run, std::uint64_t least, const std::optional<std::uint64_t>& most,
                     const Start& start) {
    const std::size_t count = run.collisions.size();
    if (least <= count && (!most || count <= *most)) return;
    std::ostringstream text;
    text.precision(21);
    text << "accepted, but false: at least " << least << ", at most "
         << (most ? std::to_string(*most) : "none") << "; simulated " << count << " from";
    for (const Real& x : start) text << ' ' << x;
    trap(text.str());
}

}  // namespace dumbbell_fuzz
