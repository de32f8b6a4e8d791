#include "adiabatic/printed.hpp"

#include <algorithm>
#include <cmath>

#include "adiabatic/bounce_leaf.hpp"
#include "number/parallel.hpp"

namespace dumbbell::adiabatic {
namespace {

constexpr std::size_t velocities = 1024;
constexpr double least_s = 0.5;  ///< |ydot| of the order of delta, as the proof of Theorem 3.5 takes it
constexpr std::size_t most_angles = 24;
constexpr double angle_step = 1.0 / 16;  ///< relative to the least angle
constexpr std::size_t most_kept = 16;
constexpr std::size_t fewest_kept = 2;
constexpr int refinements = 24;  ///< not to where it stops exactly, which no enclosure tells from going on

bool greater(const AdiabaticSample& a, const AdiabaticSample& b) { return a.error > b.error; }

/// The best of the neighbours, nearer and nearer: the change is greatest where the last collision just stops
/// the rod.
AdiabaticSample refined(const AdiabaticSearch& search, AdiabaticSample best, double least) {
    double du = least * angle_step;
    double ds = (1 - least_s) / velocities;
    for (int i = 0; i < refinements; ++i) {
        const AdiabaticSample centre = best;
        for (const double u : {centre.u, std::max(least, centre.u - du), centre.u + du}) {
            for (const double s : {centre.s, centre.s - ds, centre.s + ds}) {
                const auto other = simulated(search, u, std::clamp(s, least_s, 1.0), centre.share);
                best = greater(other, best) ? other : best;
            }
        }
        du /= 1.5;
        ds /= 1.5;
    }
    return best;
}

}  // namespace

std::vector<AdiabaticSample> search_printed(const AdiabaticSearch& search) {
    const double lo = search.of.delta.first.convert_to<double>();
    const double hi = search.of.delta.second.convert_to<double>();
    const double share = lo == hi ? 0 : 0.5;
    // An orbit has about 1/delta collisions, so that small ones allow fewer orbits.
    const double delta = lo + (hi - lo) * share;
    const double part = std::min(1.0, most_collisions_in_all * delta / (most_angles * velocities));
    const std::size_t angles = std::max<std::size_t>(1, static_cast<std::size_t>(most_angles * part));
    const std::size_t kept = std::max(fewest_kept, static_cast<std::size_t>(most_kept * part));
    // As near the vertical as is allowed I_0 is greatest.
    const double least = search.of.margin.convert_to<double>() * std::sqrt(delta) * (1 + 1e-6);
    std::vector<AdiabaticSample> samples(angles * (velocities + 1));
    run_with_threads(search.jobs, Threads::shared, [&] {
        in_parallel(samples.size(), [&](std::size_t i) {
            const double u = least * (1 + angle_step * static_cast<double>(i % angles));
            const std::size_t row = i / angles;
            const double s = least_s + (1 - least_s) * static_cast<double>(row) / velocities;
            samples[i] = search.interrupted() ? AdiabaticSample{} : simulated(search, u, s, share);
        });
    });
    std::stable_sort(samples.begin(), samples.end(), greater);
    samples.resize(kept);
    for (AdiabaticSample& best : samples) {
        best = refined(search, best, least);
    }
    std::stable_sort(samples.begin(), samples.end(), greater);
    return samples;
}

double printed_branch_error(const AdiabaticState& state) {
    const auto in = [](const Rational& x) { return enclose<Interval>(x); };
    const AdiabaticBounce<Interval> bounce(in(state.u), in(state.s),
                                           AdiabaticMasses<Interval>(in(state.delta)));
    const Interval& beta2 = bounce.masses.beta2;
    const Interval error =
        Interval(4) * bounce.s / (beta2 * bounce.rho()) - bounce.speed_error() / bounce.masses.delta;
    return std::max(0.0, error.lo());
}

}  // namespace dumbbell::adiabatic
