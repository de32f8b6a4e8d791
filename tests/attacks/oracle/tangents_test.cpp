// L78 to L84 and Theorem B of proofs/body.md against the simulation: any body, also with Q rho < 1 or Q < 1.
#include "tangents.hpp"

#include <array>
#include <cmath>

#include "catch.hpp"
#include "extremal.hpp"

using namespace dumbbell_oracle;

namespace {

// Random and symmetric ones, and ones beside the edge Q rho = 1 and beside ties of the corner.
Numbers any_body(Sampler& sampler, double greatest = 300) {
    const double shape = sampler.uniform(0, 1), q = sampler.log_uniform(0.3, greatest),
                 kind = sampler.uniform(0, 1);
    const double rho = shape > 0.9    ? 1
                       : shape > 0.45 ? sampler.log_uniform(0.01, 1)
                                      : sampler.uniform(0.1, 1);
    const double beside = 1 + (sampler.coin() ? 1 : -1) * sampler.log_uniform(1e-6, 1e-2);
    if (kind < 0.2) return {rho, beside / rho};
    if (kind > 0.4) return {rho, q};
    Numbers n{rho, 1 / rho};  // to where the corner goes into a half turn a whole number of times
    const double wanted = half_turn / std::round(sampler.uniform(3, 9));
    for (double lo = 0, hi = 1e4; hi - lo > 1e-12 * hi;) {
        n.q = (lo + hi) / 2;
        (n.corner() > wanted ? lo : hi) = n.q;
    }
    return {rho, n.q * beside};
}

// L84 (c): more than the wedge of the higher humps has, as random bodies do not.
Numbers rod_with_little_mass(Sampler& sampler) {
    return rod(sampler.uniform(4.6034, 5.82), sampler.log_uniform(1e-7, 1e-1));
}

// The steps of Theorem B are decided by 80 digits where long double finds another number or less than was
// seen.
std::size_t maximum_of(const Numbers& n, std::size_t seen) {
    const std::size_t most = TheoremB::of<long double>(n).maximum();
    return seen > most ? TheoremB::of<Digits80>(n).maximum() : most;
}

// Just above the tangent of the bridge at e, to the left.
Spot above_tangent(const Numbers& n, double e, double angle) {
    return {Mass::heavy, e, half_turn - std::atan(n.rho * std::sqrt(n.q) * std::cos(e)) - angle};
}

// On the bridge at e, along its tangent, to the left (-1) or to the right (1).
template <class S>
std::vector<Collision<S>> along_tangent(const Numbers& n, const S& e, int to) {
    using std::cos;
    using std::sin;
    const State<S> state{pi<S>() - e, S(to), S(n.rho) * sin(e), S(-to) * S(n.rho) * cos(e)};
    return simulate(n.body<S>(), state, Mass::heavy).collisions;
}

// Leaves the wall at a right angle.
Spot upright(const Numbers& n, Mass mass, double e) {
    const double tilt = std::atan((mass == Mass::heavy ? -n.rho : 1) * std::sqrt(n.q) * std::cos(e));
    return {mass, e, half_turn / 2 + tilt};
}

// The most collisions of starts beside the motions that Theorem B says are the longest.
std::size_t most_seen(const Numbers& n, const TheoremB& theorem) {
    std::size_t most = 0;
    const auto look = [&](const Spot& at) {
        if (most < theorem.maximum()) most = std::max(most, counted_at(n, at, theorem.maximum()));
    };
    for (std::size_t j = 1; j <= theorem.hits; ++j) {
        const auto orbit = along_tangent<long double>(n, theorem.e[j], 1);
        if (orbit.size() < j) continue;
        const double middle = std::abs(static_cast<double>(orbit[j - 1].after.phi - pi<long double>()));
        for (double part = 0.1; part > 1e-15; part /= 10)
            look(upright(n, orbit[j - 1].mass, middle * (1 - part)));
    }
    for (const double e : {theorem.e[0] * (1 - 1e-9), 1e-3, 1e-4, 1e-5, 1e-6, 1e-7})
        for (double angle = 0.3; angle > 1e-9; angle /= 2) look(above_tangent(n, e, angle));
    return most;
}

// Of a point on the floor: which of the intervals between tops and corners it is in.
long quarter_of(const State<long double>& state) {
    return std::lround(std::floor(static_cast<double>(state.phi) / (half_turn / 2)));
}

// The length of the valley passage; nothing if the motion is not as L78 says.
std::optional<std::size_t> passage_of(const std::vector<Collision<long double>>& motion) {
    std::vector<long> places;  // odd quarters are left of a corner
    for (const auto& collision : motion) places.push_back(quarter_of(collision.after));
    const auto is_heavy = [](const auto& collision) { return collision.mass == Mass::heavy; };
    const auto first = std::find_if(motion.begin(), motion.end(), is_heavy);
    if (first == motion.end()) return 0;
    const auto last = std::find_if(motion.rbegin(), motion.rend(), is_heavy).base() - 1;
    auto from = first - motion.begin(), to = last - motion.begin();
    const long bridge = places[static_cast<std::size_t>(from)], beside = bridge % 2 == 0 ? -1 : 1;
    const auto is_beside = [&](auto i) {
        const auto at = static_cast<std::size_t>(i);
        const long place = places[at];
        return motion[at].mass == Mass::light && (place == bridge + beside || place == bridge + 2 * beside);
    };
    if (from > 0 && is_beside(from - 1)) --from;
    if (to + 1 < std::ssize(motion) && is_beside(to + 1)) ++to;
    for (auto i = from; i <= to; ++i) {
        const bool heavy = is_heavy(motion[static_cast<std::size_t>(i)]);
        if (heavy ? places[static_cast<std::size_t>(i)] != bridge : !is_beside(i)) return std::nullopt;
        if (i > from && heavy == is_heavy(motion[static_cast<std::size_t>(i - 1)])) return std::nullopt;
    }
    return static_cast<std::size_t>(to - from + 1);
}

// A flight to the right, at the height c over the corner.
State<long double> over_corner(long double c, long double kappa) { return {pi<long double>(), 1, c, kappa}; }

}  // namespace

TEST_CASE("L78, L80, Theorem B: a motion has one passage on one side, and no more collisions than its case") {
    Sampler sampler(1, 7801);
    std::array<int, 3> kinds{};
    int tight = 0;
    for (int i = 0; i < scaled(40); ++i) {
        const Numbers n = any_body(sampler);
        const auto body = n.body<long double>();
        const auto theorem = TheoremB::of<long double>(n);
        for (int k = 0; k < 100; ++k) {
            const Spot at = k % 2 == 0
                                ? random_spot(sampler)
                                : above_tangent(n, theorem.e.back() * (1 - sampler.log_uniform(1e-5, 1)),
                                                sampler.log_uniform(1e-5, 1));
            const auto contact = standing(body, at.mass, at.e, at.angle);
            if (total_collisions(body, contact).care.doubtful()) continue;
            const auto motion = whole_trajectory(body, contact);
            const auto passage = passage_of(motion);
            const std::size_t most = passage ? theorem.most_of(*passage) : 0;
            if (motion.size() > most) FAIL(say("rho", n.rho, "Q", n.q, at.e, at.angle, motion.size(), most));
            tight += motion.size() == most ? 1 : 0;
            ++kinds[*passage == 0 ? 0 : 1 + *passage % 2];
        }
    }
    CHECK((tight > 100 && kinds[0] > 100 && kinds[1] > 100 && kinds[2] > 100));
}

TEST_CASE("L79: a lower and steeper flight into the valley stays lower and hits earlier") {
    Sampler sampler(1, 7901);
    int turns = 0;
    for (int i = 0; i < scaled(5'000); ++i) {
        const Numbers n = any_body(sampler),
                      upper{n.rho, n.q * (sampler.coin() ? 1 : sampler.uniform(0.3, 1))};
        const double c = sampler.log_uniform(1e-4, 0.9), kappa = sampler.uniform(-1.5 * n.rho, 0.5);
        const auto high = simulate(upper.body<long double>(), over_corner(c, kappa)).collisions,
                   low = simulate(n.body<long double>(), over_corner(c * sampler.uniform(0, 1),
                                                                     kappa - sampler.log_uniform(1e-6, 1)))
                             .collisions;
        for (std::size_t k = 0; k < high.size(); ++k) {
            const auto place = [](const auto& collision) {
                return std::abs(collision.after.phi - pi<long double>());
            };
            const auto slope = [](const auto& collision) {
                return collision.after.ydot / std::abs(collision.after.phidot);
            };
            const Mass expected = k % 2 == 0 ? Mass::light : Mass::heavy;
            if (high[k].mass != expected || place(high[k]) > half_turn / 2) break;
            if (k >= low.size()) FAIL(say("rho", n.rho, n.q, upper.q, c, kappa, k));
            CHECK((low[k].mass == expected && place(low[k]) < place(high[k])));
            if (high[k].after.phidot * high[k].before.phidot >= 0) break;
            CHECK((low[k].after.phidot * low[k].before.phidot < 0 && slope(low[k]) < slope(high[k])));
            CHECK(low[k].after.y + place(low[k]) * slope(low[k]) <
                  high[k].after.y + place(high[k]) * slope(high[k]));
            ++turns;
        }
    }
    CHECK(turns > 2'000);
}

TEST_CASE("L81: f grows, b falls, and the tangent at e_j is its own reverse") {
    Sampler sampler(1, 8101);
    int reversed_ones = 0;
    for (int i = 0; i < scaled(30); ++i) {
        const Numbers n = any_body(sampler), more{n.rho, n.q * sampler.uniform(1, 2)};
        const TwoTangents<long double> tangents(n), of_more(more);
        const auto theorem = TheoremB::of<long double>(n);
        double at[2] = {sampler.log_uniform(1e-3, half_turn / 2), sampler.uniform(1e-3, half_turn / 2)};
        std::sort(at, at + 2);
        CHECK((tangents.f(at[0]) >= theorem.k1 && tangents.f(at[1]) >= tangents.f(at[0])));
        CHECK((tangents.b(at[0]) <= theorem.hits && tangents.b(at[1]) <= tangents.b(at[0])));
        CHECK((of_more.f(at[0]) >= tangents.f(at[0]) && of_more.b(at[0]) >= tangents.b(at[0])));
        const auto right = along_tangent<long double>(n, at[0], 1);
        CHECK(tangents.b(at[0]) ==
              static_cast<std::size_t>(std::count_if(right.begin(), right.end(), [](const auto& collision) {
                  return collision.mass == Mass::heavy;
              })));
        CHECK(tangents.f(at[0]) == along_tangent<long double>(n, at[0], -1).size());
        CHECK(tangents.b(1e-7L) == theorem.hits);
        for (std::size_t j = 1; j <= std::min<std::size_t>(theorem.hits, 2); ++j) {
            if (theorem.e[j] < 1e-4) continue;
            const auto orbit = along_tangent(n, TwoTangents<Digits80>(n).place(j), 1);
            REQUIRE(orbit.size() >= 2 * j);
            const auto &middle = orbit[j - 1], &again = orbit[2 * j - 1];
            CHECK(std::abs(static_cast<double>(middle.before.phidot + middle.after.phidot)) < 1e-9);
            CHECK(std::abs(static_cast<double>(again.after.phi - pi<Digits80>()) + theorem.e[j]) < 1e-9);
            ++reversed_ones;
        }
    }
    CHECK(reversed_ones > 20);
}

TEST_CASE(
    "Theorem B: of bodies beside the edge and ties, and random ones, no motion has more and one has as "
    "many") {
    Sampler sampler(1, 8201);
    for (int i = 0; i < scaled(20); ++i) {
        const Numbers n =
            i % 5 == 1 ? rod_with_little_mass(sampler) : any_body(sampler, i % 20 == 0 ? 2000 : 100);
        const auto theorem = TheoremB::of<Digits80>(n);
        std::size_t seen = most_seen(n, theorem);
        const bool as_many = seen >= theorem.maximum();
        for (int k = 0; k < 200; ++k) seen = std::max(seen, counted_at(n, random_spot(sampler), seen));
        if (!as_many || seen > theorem.maximum()) FAIL(say("rho", n.rho, "Q", n.q, seen, theorem.maximum()));
    }
}

TEST_CASE("Theorem B: beside a step in Q there is one motion more above it, and none below") {
    Sampler sampler(1, 8202);
    int steps = 0;
    for (int i = 0; i < scaled(6); ++i) {
        Numbers below = any_body(sampler, 100), above{below.rho, below.q * 1.5};
        const std::size_t from = maximum_of(below, 0);
        if (maximum_of(above, 0) == from) continue;
        while (above.q - below.q > 1e-6 * above.q) {
            const Numbers middle{below.rho, (below.q + above.q) / 2};
            (maximum_of(middle, 0) > from ? above : below) = middle;
        }
        above.q *= 1 + 1e-5;
        const auto beyond = TheoremB::of<Digits80>(above);
        const std::size_t seen = most_seen(above, beyond), still = most_seen(below, beyond);
        if (seen != beyond.maximum() || still > from) FAIL(say("rho", above.rho, above.q, seen, still, from));
        ++steps;
    }
    CHECK(steps > 0);
}

TEST_CASE("L72, L73, L83, L84: more Q, the bounds by wedge and corner, runs back, rods with little mass") {
    Sampler sampler(1, 8301);
    int beyond = 0;
    for (int i = 0; i < scaled(100); ++i) {
        const Numbers n = i % 10 == 0 ? rod_with_little_mass(sampler) : any_body(sampler),
                      more{n.rho, n.q * (1 + sampler.log_uniform(1e-3, 1))};
        const auto theorem = TheoremB::of<long double>(n);
        const std::size_t most = theorem.maximum();
        CAPTURE(n.rho, n.q, most);
        CHECK(maximum_of(more, most) >= most);
        const std::size_t wedge = whole_from(half_turn / n.wedge());
        if (n.q >= 1) CHECK(most <= wedge + 2);
        if (n.rho == 1) CHECK(most == wedge);
        CHECK(most >= theorem.in_corner);
        beyond += most > wedge ? 1 : 0;
        if (n.q * n.rho > 1 + 1e-9 && theorem.hits > 0)
            CHECK((theorem.f[0] <= theorem.f[1] + 1 && theorem.f[1] <= theorem.f[0]));
    }
    CHECK(beyond > 0);
    for (const double q : {4.0, 5.5, 9.0, 25.0, 100.0})
        CHECK(maximum_of(rod(q, 1e-9), 0) == 3 + 2 * theorem(Digits80(q)).k1);
}
