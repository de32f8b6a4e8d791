#include "sampler.hpp"

#include <cmath>
#include <iomanip>
#include <sstream>

#include "scalar.hpp"

namespace dumbbell_oracle {
namespace {

constexpr double half_pi = 1.57079632679489661923;

// psi and yhat of a wall point, and the direction of the wall there as (1, slope).
template <class S>
struct WallPoint {
    S psi;
    S slope;
};

template <class S>
WallPoint<S> wall_point(const Dumbbell<S>& body, Mass mass, int side, const S& e) {
    using std::cos;
    const S w = cos(e);
    if (mass == Mass::light) return {S(side * (pi<S>() / 2 + e)), S(side * w)};
    return {S(side * (pi<S>() / 2 - e)), S(-side * w / body.ratio())};
}

template <class S>
State<S> state_of(const Dumbbell<S>& body, const S& psi, const S& yhat, const S& psidot, const S& yhatdot) {
    return {S(psi + pi<S>() / 2), psidot, S(yhat * body.beta2()), S(yhatdot * body.beta2())};
}

template <class S>
std::variant<State<S>, Contact<S>> realize_wall(const Dumbbell<S>& body, const WallState& wall) {
    using std::cos;
    using std::sin;
    using std::sqrt;
    const S e = wall.e;
    const WallPoint<S> at = wall_point(body, wall.mass, wall.side, e);
    // In (psi, sqrt(q) yhat) the kinetic metric is Euclidean: tangent (1, m) / norm, normal (-m, 1) / norm.
    const S root = sqrt(body.ratio());
    const S m = root * at.slope;
    const S norm = sqrt(1 + m * m);
    const S yhat = wall.mass == Mass::light ? S(sin(e)) : S(sin(e) / body.ratio());
    if (wall.clearance > 0) {
        const S way = wall.angle < half_pi ? 1 : -1;
        return state_of(body, at.psi, S(yhat + S(wall.clearance)), S(way), S(way * at.slope));
    }
    const S along = cos(S(wall.angle));
    const S across = sin(S(wall.angle));
    State<S> after =
        state_of(body, at.psi, yhat, S((along - across * m) / norm), S((along * m + across) / (norm * root)));
    after.y = -body.arm(wall.mass) * sin(after.phi);
    return Contact<S>{wall.mass, after};
}

}  // namespace

double Sampler::uniform(double lo, double hi) {
    // Not std::uniform_real_distribution: its results differ between libraries.
    return lo + (hi - lo) * (static_cast<double>(engine_() >> 11) * 0x1p-53);
}

double Sampler::log_uniform(double lo, double hi) { return std::exp(uniform(std::log(lo), std::log(hi))); }

double Sampler::near(double value, double width) {
    const double distance = log_uniform(width * 1e-9, width);
    return coin() ? value + distance : value - distance;
}

WallState Sampler::any_contact() {
    return {coin() ? Mass::light : Mass::heavy, coin() ? 1 : -1, uniform(1e-3, half_pi),
            uniform(0, 2 * half_pi), 0};
}

Start Sampler::next(Family family) {
    const double r = 1 / ratio_;
    WallState wall = any_contact();
    switch (family) {
        case Family::falling: {
            const double steep = std::tan(uniform(0, half_pi)) / std::sqrt(ratio_);
            return Falling{uniform(-2 * half_pi, 2 * half_pi), steep, coin() ? 1 : -1};
        }
        case Family::anywhere:
            return wall;
        case Family::near_tangent:
            wall.angle = log_uniform(1e-12, 1e-1);
            if (coin()) wall.clearance = log_uniform(1e-12, 1e-1);
            if (coin()) wall.angle = 2 * half_pi - wall.angle;
            return wall;
        case Family::near_corner:
            wall.e = log_uniform(1e-12, 1e-3);
            if (coin()) wall.angle = coin() ? log_uniform(1e-9, 1) : 2 * half_pi - log_uniform(1e-9, 1);
            return wall;
        case Family::near_horizontal: {
            const double e = half_pi - log_uniform(1e-9, 1);
            const double slope = log_uniform(1e-9, 1) * (half_pi - e);
            if (coin()) return LightState<double>{e, slope * ratio_};
            return BridgeState<double>{e, slope * (coin() ? 1 : ratio_)};
        }
        case Family::low_slopes:
            if (coin()) return BridgeState<double>{uniform(1e-3, half_pi), log_uniform(1e-6, 30)};
            return LightState<double>{coin() ? uniform(1e-3, half_pi) : log_uniform(1e-3 * r, half_pi),
                                      log_uniform(1e-3, 30)};
        case Family::top_orbit:
            return BridgeState<double>{half_pi - log_uniform(1e-7, 0.5), log_uniform(1e-12, 0.1)};
        case Family::corner_orbit: {
            // The rays of the extremal orbit need c ~ e^3 and eta ~ e^2 small at once.
            const double e = log_uniform(2e-4, 0.5);
            return BridgeState<double>{e, e * e * log_uniform(1e-6, 10)};
        }
    }
    return wall;
}

template <class S>
std::variant<State<S>, Contact<S>> realize(const Dumbbell<S>& body, const Start& start) {
    if (const auto* falling = std::get_if<Falling>(&start)) {
        const S psidot = falling->side;
        return state_of(body, S(falling->psi), S(2), psidot, S(-S(falling->steepness)));
    }
    if (const auto* wall = std::get_if<WallState>(&start)) return realize_wall(body, *wall);
    if (const auto* bridge = std::get_if<BridgeState<double>>(&start)) {
        return contact_of(body, BridgeState<S>{S(bridge->e), S(bridge->eta)});
    }
    const auto& light = std::get<LightState<double>>(start);
    return contact_of(body, LightState<S>{S(light.e), S(light.lambda)});
}

template <class S>
Total<S> total_collisions(const Dumbbell<S>& body, const Start& start) {
    return std::visit([&body](const auto& real) { return total_collisions(body, real); },
                      realize(body, start));
}

std::size_t careful_total(double ratio, const Start& start) {
    const auto quick = total_collisions(Dumbbell<long double>(static_cast<long double>(ratio)), start);
    if (!quick.care.doubtful()) return quick.collisions;
    return total_collisions(Dumbbell<Digits80>(Digits80(ratio)), start).collisions;
}

std::string describe(const Start& start) {
    std::ostringstream out;
    out << std::setprecision(17);
    if (const auto* falling = std::get_if<Falling>(&start)) {
        out << "falling psi=" << falling->psi << " steepness=" << falling->steepness
            << " side=" << falling->side;
    } else if (const auto* wall = std::get_if<WallState>(&start)) {
        out << "wall " << (wall->mass == Mass::light ? "light" : "heavy") << " side=" << wall->side
            << " e=" << wall->e << " angle=" << wall->angle << " clearance=" << wall->clearance;
    } else if (const auto* bridge = std::get_if<BridgeState<double>>(&start)) {
        out << "bridge e=" << bridge->e << " eta=" << bridge->eta;
    } else {
        const auto& light = std::get<LightState<double>>(start);
        out << "light e=" << light.e << " lambda=" << light.lambda;
    }
    return out.str();
}

template std::variant<State<long double>, Contact<long double>> realize(const Dumbbell<long double>&,
                                                                        const Start&);
template std::variant<State<Digits80>, Contact<Digits80>> realize(const Dumbbell<Digits80>&, const Start&);
template Total<long double> total_collisions(const Dumbbell<long double>&, const Start&);
template Total<Digits80> total_collisions(const Dumbbell<Digits80>&, const Start&);

}  // namespace dumbbell_oracle
