// L88 of proofs/space.md: a thin disc in space, followed as a rigid body, and its path in a cone; and a rod
// in space.
#include <array>

#include "catch.hpp"
#include "trial.hpp"

using namespace dumbbell_oracle;

namespace {

using Vector = std::array<Real, 3>;

Vector sum(const Vector& a, Real factor, const Vector& b) {
    return {a[0] + factor * b[0], a[1] + factor * b[1], a[2] + factor * b[2]};
}
Real dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Vector cross(const Vector& a, const Vector& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

// Mass 1, without spin about its axis n. A disc of radius 1, or a rod of length 2 along n.
struct Top {
    bool is_rod;
    Real k, y, speed;    // gyration across the axis; height of the centre, and its change
    Vector n, momentum;  // the latter is orthogonal to n

    [[nodiscard]] Vector turning() const { return sum({}, 1 / (k * k), momentum); }
    [[nodiscard]] Real energy() const { return (speed * speed + dot(momentum, turning())) / 2; }
    [[nodiscard]] Vector lowest() const {  // from the centre
        const Vector down = is_rod ? sum({}, -n[2], n) : sum({0, 0, -dot(n, n)}, n[2], n);
        return sum({}, 1 / std::sqrt(dot(down, down)), down);
    }
    void fly(Real time) {
        const Vector axis = turning();
        const Real rate = std::sqrt(dot(axis, axis));
        n = sum(sum({}, std::cos(rate * time), n), std::sin(rate * time) / rate, cross(axis, n));
        y += speed * time;
    }
    void bounce() {  // the vertical push at the lowest point that turns its vertical speed over
        const Vector arm = cross(lowest(), {0, 0, 1});
        const Real push = -2 * (speed + dot(turning(), arm)) / (1 + dot(arm, arm) / (k * k));
        speed += push;
        momentum = sum(momentum, push, arm);
    }
    // y^2 less the square of the depth of the lowest point is 0 at a contact. Each step is too short to pass
    // a zero, by a bound of the second derivative.
    [[nodiscard]] bool fly_to_contact() {
        const Vector axis = turning();
        const Real bend = 2 * (speed * speed + dot(axis, axis));
        for (bool begins = true;; begins = false) {
            const Real level = n[0] * n[0] + n[1] * n[1], change = n[2] * cross(axis, n)[2];
            const Real above = begins ? 0 : y * y - (is_rod ? n[2] * n[2] : level);
            if (!begins && above <= 1e-16L * y * y) return true;
            if (speed >= 0 && y > 1) return false;
            const Real growth = 2 * (y * speed + (is_rod ? -change : change));
            fly((growth + std::sqrt(growth * growth + 2 * bend * above)) / bend);
        }
    }
    // How many collisions follow. Energy and the momentum about the vertical are kept.
    [[nodiscard]] int later() const {
        Top top = *this;
        int count = 0;
        for (; top.fly_to_contact(); ++count) top.bounce();
        CHECK(close(top.energy(), energy(), 1e-14L * energy()));
        CHECK(close(top.momentum[2], momentum[2], 1e-14L * std::sqrt(energy())));
        return count;
    }
};

// In contact at this tilt. Seen from the tip of the cone it goes at the angle eps to the edge, and is at this
// arc from the place that is nearest to the tip.
Top disc(Real k, Real tilt, Real eps, Real arc) {
    const Real slant = std::sqrt(1 + k * k), out = std::tan(arc), in = std::sin(eps);
    const Real upright = std::sqrt(1 - tilt * tilt), x = (k * out - in) / (k * slant);
    const Vector normal{tilt, 0, upright}, change{x, std::cos(eps) / k, -tilt * x / upright};
    return {false, k, tilt, (out + k * in) / slant, normal, sum({}, k * k, cross(normal, change))};
}

}  // namespace

TEST_CASE("L88: at little tilt a disc has the collisions of its path in the cone, by the length of a chord") {
    CHECK(disc(0.5L, 0.01L, 0.01L, 0).later() == 148);
    CHECK(disc(0.5L, 1e-9L, 0.01L, 0).later() == 157);
    CHECK(disc(0.5L, 1e-9L, pi<Real>() / 2, 0.01L - pi<Real>() / 2).later() == 3);  // in a plane: L72
    Sampler sampler(1, 8801);
    for (int i = 0; i < scaled(250); ++i) {
        const Real k = sampler.uniform(0.2, 0.8), eps = sampler.log_uniform(0.01, 1.5), end = pi<Real>() / 2,
                   arc = (end - 0.02L) * sampler.uniform(-1, 1);
        const Real chords = (end - arc) / (2 * std::atan(k * std::sin(eps)));
        if (std::abs(chords - std::round(chords)) < 1e-3L) continue;
        const int later = disc(k, 1e-9L, eps, arc).later();
        if (later != std::floor(chords)) FAIL(say("k", k, "eps", eps, "arc", arc, later, chords));
    }
}

TEST_CASE("proofs/space.md: of random uniform rods in space none hits the floor more than three times") {
    Sampler sampler(1, 8802);
    int most = 0;
    for (int i = 0; i < scaled(2'000); ++i) {
        const Real z = sampler.log_uniform(1e-4, 0.99), level = std::sqrt(1 - z * z);
        const auto any = [&] { return (sampler.coin() ? 1 : -1) * Real(sampler.log_uniform(1e-4, 10)); };
        const Real turn = any();
        const Vector normal{level, 0, -z}, change{z * turn, any(), level * turn};
        Top rod{true, 1 / std::sqrt(Real(3)), z, any(), normal, sum({}, Real(1) / 3, cross(normal, change))};
        if (rod.speed + change[2] < 0) rod.bounce();  // now it leaves the floor
        Top before = rod;
        before.bounce();
        before.speed *= -1;
        before.momentum = sum({}, -1, before.momentum);
        most = std::max(most, before.later() + 1 + rod.later());
    }
    CHECK(most == 3);
}
