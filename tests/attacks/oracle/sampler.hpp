// Seeded trajectories: random ones and ones chosen to be hard. All seeds are doubles, so the same trajectory
// can be run in long double and again with 80 digits. Same seed, same samples, on every platform up to libm.
#pragma once

#include <cstdint>
#include <random>
#include <string>
#include <variant>

#include "chart.hpp"

namespace dumbbell_oracle {

// Comes down from above: at height yhat = 2 (out of reach of the floor) with angle psi and slope -steepness.
struct Falling {
    double psi;
    double steepness;
    int side;  // sign of psidot
};

// Contact at corner distance e; the outgoing ray makes `angle` (in (0, pi), in the metric of the kinetic
// energy) with the wall's direction of growing psi. With clearance > 0 it is instead a flight along the
// wall's tangent (towards growing psi if angle < pi/2) that passes it at that height: a near miss.
struct WallState {
    Mass mass;
    int side;  // sign of psi
    double e;
    double angle;
    double clearance;
};

using Start = std::variant<Falling, WallState, BridgeState<double>, LightState<double>>;

enum class Family {
    falling,          // uniform over directions (in the kinetic metric) of approach from above
    anywhere,         // contacts uniform in position and direction
    near_tangent,     // contacts at grazing angles 1e-12..1e-1, and misses by 1e-12..1e-1
    near_corner,      // corner distance 1e-12..1e-3; long double miscounts here
    near_horizontal,  // close to the peaks, almost horizontal
    low_slopes,       // slopes of the order of 1/q, where the long trajectories are
    top_orbit,        // bridge contacts near its top, almost tangent (the extremal orbit of odd maxima)
    corner_orbit      // bridge contacts near the corner, almost tangent (the extremal orbit of even maxima)
};
inline constexpr Family all_families[] = {Family::falling,     Family::anywhere,        Family::near_tangent,
                                          Family::near_corner, Family::near_horizontal, Family::low_slopes,
                                          Family::top_orbit,   Family::corner_orbit};

class Sampler {
  public:
    Sampler(double ratio, std::uint64_t seed) : ratio_(ratio), engine_(seed) {}

    [[nodiscard]] Start next(Family family);

    [[nodiscard]] double uniform(double lo, double hi);
    [[nodiscard]] double log_uniform(double lo, double hi);  // 0 < lo < hi
    [[nodiscard]] bool coin() { return uniform(0, 1) < 0.5; }

  private:
    [[nodiscard]] WallState any_contact();
    [[nodiscard]] double near(double value, double width);  // value -+ a log-uniform distance up to width

    double ratio_;
    std::mt19937_64 engine_;
};

// The physical trajectory and its whole count, in the given arithmetic.
template <class S>
[[nodiscard]] std::variant<State<S>, Contact<S>> realize(const Dumbbell<S>& body, const Start& start);
template <class S>
[[nodiscard]] Total<S> total_collisions(const Dumbbell<S>& body, const Start& start);

// Long double, and again with 80 digits where the first count is doubtful (near a corner or a tangency).
[[nodiscard]] std::size_t careful_total(double ratio, const Start& start);

[[nodiscard]] std::string describe(const Start& start);  // with all digits, for failure messages

}  // namespace dumbbell_oracle
