// L86 of proofs/plane.md against the simulation: motions that leave a wall of the valley at a right angle.
#include <cmath>

#include "catch.hpp"
#include "tangents.hpp"

using namespace dumbbell_oracle;

namespace {

// Y_j(p), if it exists: at the corner, whether it hits the bridge in the valley, and G.
struct Outward {
    long double c, kappa;
    bool hits;
    std::size_t beyond;
};

std::optional<Outward> outward(const Numbers& n, std::size_t j, double p) {
    const auto mass_of = [](std::size_t number) { return number % 2 == 0 ? Mass::heavy : Mass::light; };
    const auto body = n.body<long double>();
    const Mass first = mass_of(j);
    const double height = first == Mass::heavy ? n.rho : 1, e = std::asin(p / height),
                 tilt = std::atan((first == Mass::heavy ? -n.rho : 1) * std::sqrt(n.q) * std::cos(e));
    const auto start = standing(body, first, e, half_turn / 2 + tilt);
    const auto motion = simulate(body, start.after, first).collisions;
    const auto place = [](const State<long double>& at) { return std::abs(at.phi - pi<long double>()); };
    const auto is_in_valley = [&](std::size_t i) {  // the collision with the number j + 1 + i
        return i < motion.size() && motion[i].mass == mass_of(j + 1 + i) &&
               place(motion[i].after) < half_turn / 2;
    };
    for (std::size_t i = 0; i + 1 < j; ++i)
        if (!is_in_valley(i) || motion[i].after.phidot * motion[i].before.phidot >= 0) return std::nullopt;
    const State<long double> last = j == 1 ? start.after : motion[j - 2].after;
    const long double kappa = last.ydot / std::abs(last.phidot), c = last.y + place(last) * kappa;
    const std::size_t beyond =
        ray_count(Ray<long double>{c + pi<long double>() * kappa, kappa}, 1 / static_cast<long double>(n.q));
    const bool hits = is_in_valley(j - 1);
    if (!hits && motion.size() - (j - 1) != beyond)
        FAIL(say("beyond", n.rho, n.q, j, p, motion.size(), beyond));
    return Outward{c, kappa, hits, beyond};
}

Numbers plane_body(Sampler& sampler) { return {sampler.log_uniform(0.05, 1), sampler.log_uniform(0.5, 200)}; }

}  // namespace

TEST_CASE("L86: an orbit from a right angle falls with rho and Q, and rises with its height") {
    Sampler sampler(1, 8601);
    int compared = 0, hits = 0;
    for (int i = 0; i < scaled(20'000); ++i) {
        const Numbers upper = plane_body(sampler), n{std::min(1.0, upper.rho * sampler.uniform(1, 1.5)),
                                                     upper.q * sampler.uniform(1, 1.5)};
        const auto j = static_cast<std::size_t>(sampler.uniform(1, 6));
        const double high = sampler.log_uniform(1e-4, 0.999) * upper.rho,
                     low = high * (sampler.coin() ? 1 : sampler.uniform(0.5, 1));
        const auto above = outward(upper, j, high), below = outward(n, j, low);
        if (!above) continue;
        INFO(say(upper.rho, upper.q, n.rho, n.q, j, high, low));
        REQUIRE(below);
        CHECK((below->c <= above->c + 1e-15L && below->kappa <= above->kappa + 1e-15L));
        CHECK((below->hits || !above->hits));
        CHECK(below->beyond >= above->beyond);
        ++compared;
        hits += above->hits;
    }
    CHECK((compared > 3'000 && hits > 300));
}

TEST_CASE("L86: what hits the bridge bounds f(e_j) from above, what passes it from below") {
    Sampler sampler(1, 8602);
    int tight = 0, wedges = 0;
    for (int i = 0; i < scaled(1'000); ++i) {
        const Numbers n = plane_body(sampler);
        const TheoremB theorem = TheoremB::of<long double>(n);
        for (std::size_t j = 1; j <= theorem.hits + 1; ++j) {
            for (const double p : {1e-9, sampler.log_uniform(1e-3, 1), sampler.uniform(0, 1)}) {
                const auto found = outward(n, j, p * n.rho);
                INFO(say(n.rho, n.q, j, p * n.rho));
                if (p == 1e-9 && j <= theorem.hits) REQUIRE(found);
                if (!found) continue;
                if (j > theorem.hits) {
                    CHECK(!found->hits);
                    if (p == 1e-9 && theorem.even > 0) CHECK(theorem.even <= found->beyond);
                    wedges += p == 1e-9 && theorem.even > 0;
                    continue;
                }
                CHECK((found->hits ? theorem.f[j] <= found->beyond : theorem.f[j] >= found->beyond));
                tight += theorem.f[j] == found->beyond && found->beyond > 0;
            }
        }
    }
    CHECK((tight > 500 && wedges > 10));
}
