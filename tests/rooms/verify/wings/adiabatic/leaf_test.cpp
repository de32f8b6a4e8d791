// Leaves of the trees of the adiabatic claims: whatever box is accepted, simulated orbits of the physical
// dumbbell and the drift of L34 in long double find nothing in it that breaks what the leaf says.

#include "attacks/oracle/ray_count.hpp"
#include "catch.hpp"
#include "make_file.hpp"
#include "orbit.hpp"
#include "scale.hpp"

namespace adiabatic = dumbbell_verify::adiabatic;

using namespace make;

namespace {

struct Plain {
    Real beta2, r;
    explicit Plain(Real delta) : beta2(1 - delta * delta), r(delta * delta / beta2) {}
    [[nodiscard]] Real h(Real x, Real kappa) const {
        const Real w = std::cos(x);
        return (pi_real / 2 + std::asin(beta2 * std::sin(x))) * w * (w - kappa) / (w * w + r);
    }
};
Real integral(const std::vector<std::pair<mpq_class, mpq_class>>& cells, Real u) {
    Real top = 11 / 7.0L, sum = 0;
    for (const auto& [low, v] : cells) {
        const Real end = std::max(u, static_cast<Real>(low.get_d()));
        if (top > end) sum += v.get_d() * (top - end);
        top = low.get_d();
    }
    return sum;
}

/// A box of the root box [0, 2] x ... around a point, of this relative size.
void narrow(adiabatic::Leaf& leaf, std::size_t axis, double lo, double hi, double at, double width) {
    const double from = std::max(lo, at - width * uniform(0, 1)), until = std::min(hi, from + width);
    leaf.box.lo.at(axis) = mpq_class(from);
    leaf.box.hi.at(axis) = mpq_class(std::max(from, until));
}
Real within(const adiabatic::Leaf& leaf, std::size_t axis) {
    return make::within(leaf.box.lo.at(axis), leaf.box.hi.at(axis));
}
bool holds(const adiabatic::Leaf& leaf, std::size_t axis, Real x) {
    return leaf.box.lo.at(axis).get_d() <= x && x <= leaf.box.hi.at(axis).get_d();
}
double power_of_two(double lo, double hi) { return std::exp2(uniform(lo, hi)); }

}  // namespace

TEST_CASE("adiabatic: no accepted leaf of a class holds a flight that drifts more, or backwards") {
    const long trials = scaled(250);
    long bounds = 0, outsides = 0, flights = 0, refuted = 0;
    for (long i = 0; i < trials; ++i) {
        Adiabatics file;
        adiabatic::Claim& claim = file.terms.claim;
        claim.kind = adiabatic::Claim::run;
        const double delta = power_of_two(-9, -1.2), u = power_of_two(-4, 0.5), sigma = uniform(0, 4);
        claim.delta_lo = claim.delta_hi = mpq_class(delta);
        claim.margin = mpq_class(std::min(1.0, uniform(0.3, 1.2) * u));
        const double J = uniform(0.8, 2.5), factor = power_of_two(-2, 3);
        file.add_class(mpq_class(J), cells_down_to(mpq_class(1, 32), 60, factor, factor / 2));
        adiabatic::Leaf leaf = file.root(adiabatic::Leaf::class_tree, 0);
        const double size = power_of_two(-14, -2);
        narrow(leaf, adiabatic::axis_u, 0, 2, u, u * size);
        narrow(leaf, adiabatic::axis_sigma, 0, 8, sigma, engine()() % 4 == 0 ? 0 : size);
        narrow(leaf, adiabatic::axis_delta, 0, 0.5, delta, engine()() % 2 == 0 ? 0 : delta * size);
        leaf.outside = engine()() % 3 == 0;
        const bool accepted = adiabatic::check_leaf(leaf, nullptr) == nullptr;
        (leaf.outside ? outsides : bounds) += accepted;
        for (int j = 0; j < 10; ++j) {
            const Real d = within(leaf, adiabatic::axis_delta), top = within(leaf, adiabatic::axis_u),
                       steep = within(leaf, adiabatic::axis_sigma);
            const Plain plain(d);
            const Real x2 = pi_real / 2 - top, k = steep * std::sqrt(plain.r);
            if (x2 < 0 || top < claim.margin.get_d() || k > std::cos(x2)) continue;
            const auto x1 = hit_place(dumbbell_oracle::Ray<Real>{std::sin(x2) - k * (pi_real + x2), -k});
            if (!x1 || std::sin(x2) < k * (pi_real + x2)) continue;
            const Real scale = std::sqrt(1 + steep * steep), low = plain.h(*x1, -k), high = plain.h(x2, k);
            if (low < J * scale * (1 + 1e-12L)) continue;
            const Real drift = (low - high) / scale,
                       most = plain.r *
                              (integral(file.cells[0], top) - integral(file.cells[0], pi_real / 2 - *x1));
            const bool breaks = leaf.outside || drift < -1e-13L || drift > most + 1e-13L;
            INFO("J " << J << " u " << top << " sigma " << steep << " delta " << d << " drift " << drift
                      << " " << most);
            if (accepted) REQUIRE_FALSE(breaks);
            ++(breaks ? refuted : flights);
        }
    }
    CHECK(bounds > trials * 3 / 80);
    CHECK(outsides > trials / 40);
    CHECK(flights > trials * 3 / 8);
    CHECK(refuted > trials * 3 / 8);
}

TEST_CASE("adiabatic: no accepted leaf of one bounce holds a state with greater errors") {
    const long trials = scaled(1'600);
    long bounds = 0, outsides = 0, states = 0, refuted = 0;
    for (long i = 0; i < trials; ++i) {
        Adiabatics file;
        adiabatic::Claim& claim = file.terms.claim;
        claim.kind = adiabatic::Claim::bounce;
        const double delta = power_of_two(-7, -1.2);
        claim.exponent = engine()() % 17;
        claim.margin = mpq_class(power_of_two(-2, 0));
        const double k = static_cast<double>(claim.exponent) / 16,
                     least = claim.margin.get_d() * std::pow(delta, k);
        const double u = std::min(1.6, least * power_of_two(-0.5, 3)), s = uniform(0, 1);
        claim.y_lo = mpq_class(uniform(0, 0.5));
        claim.y_hi = mpq_class(uniform(0.9, 1));
        claim.delta_lo = mpq_class(delta / 2);
        claim.delta_hi = mpq_class(delta);
        // Near the values of this very state, so that many boxes are true by little or false by little.
        const AdiabaticOrbit typical(std::min<Real>(u, 1.55L), s, delta);
        const Real e1 =
            std::abs(typical.spin_after(0) - 1 - 2 * delta * s / std::sqrt(1 - typical.y(0) * typical.y(0)));
        const Real e2 =
            typical.size() > 1 ? std::abs(typical.y(1) - typical.y(0) + 2 * typical.f(0) * delta * s) : 1;
        const auto near = [&](Real e, double power) {
            return mpq_class(static_cast<double>(e) / std::pow(delta, power) * uniform(0.7, 2));
        };
        claim.bounds = {near(e1, 2 - 2 * k), near(e2 / 2, 2 - k)};
        adiabatic::Leaf leaf = file.root(adiabatic::Leaf::claim_tree, 0);
        const double size = power_of_two(-14, -2);
        narrow(leaf, adiabatic::axis_u, 0, 2, u, u * size);
        narrow(leaf, adiabatic::axis_s, 0, 1, s, engine()() % 4 == 0 ? 0 : size);
        narrow(leaf, adiabatic::axis_delta, 0, 0.5, delta, engine()() % 2 == 0 ? 0 : delta * size);
        leaf.outside = engine()() % 3 == 0;
        const bool accepted = adiabatic::check_leaf(leaf, nullptr) == nullptr;
        (leaf.outside ? outsides : bounds) += accepted;
        for (int j = 0; j < 4; ++j) {
            const Real d = within(leaf, adiabatic::axis_delta), angle = within(leaf, adiabatic::axis_u),
                       climb = within(leaf, adiabatic::axis_s);
            if (angle >= pi_real / 2 || angle < claim.margin.get_d() * std::pow(d, static_cast<Real>(k)))
                continue;
            const AdiabaticOrbit orbit(angle, climb, d, engine()() % 2 == 0);
            const Real y = orbit.y(0);
            if (y < claim.y_lo.get_d() || y > claim.y_hi.get_d() || orbit.size() < 2 || !orbit.light(1))
                continue;
            const Real error1 = std::abs(orbit.spin_after(0) - 1 - 2 * d * climb / std::sqrt(1 - y * y)),
                       error2 = std::abs(orbit.y(1) - y + 2 * orbit.f(0) * d * climb);
            const Real slack = 1e-13L;
            const bool breaks =
                leaf.outside ||
                error1 > claim.bounds[0].get_d() * std::pow(d, static_cast<Real>(2 - 2 * k)) + slack ||
                error2 > 2 * claim.bounds[1].get_d() * std::pow(d, static_cast<Real>(2 - k)) + slack;
            INFO("u " << angle << " s " << climb << " delta " << d << " k " << k << " E1 " << error1 << " E2 "
                      << error2);
            if (accepted) REQUIRE_FALSE(breaks);
            ++(breaks ? refuted : states);
        }
    }
    CHECK(bounds > trials * 3 / 80);
    CHECK(outsides > trials / 40);
    CHECK(states > trials / 4);
    CHECK(refuted > trials / 4);
}

TEST_CASE("adiabatic: where D changes its sign in a leaf of a bounce, the states with D > 0 count") {
    Adiabatics file;
    adiabatic::Claim& claim = file.terms.claim;
    claim.kind = adiabatic::Claim::bounce;
    claim.exponent = 16;
    claim.margin = 1;
    claim.y_lo = 0;
    claim.y_hi = 1;
    claim.delta_lo = claim.delta_hi = mpq_class(1, 100);
    claim.bounds = {mpq_class(1, 1000), mpq_class(1, 1000)};
    adiabatic::Leaf leaf = file.root(adiabatic::Leaf::claim_tree, 0);
    leaf.box.lo.at(adiabatic::axis_u) = mpq_class(1, 100);
    leaf.box.hi.at(adiabatic::axis_u) = mpq_class(4, 100);
    leaf.box.lo.at(adiabatic::axis_s) = 0;  // D < 0 here at u = 1/100
    leaf.box.hi.at(adiabatic::axis_s) = 1;
    leaf.outside = false;
    const AdiabaticOrbit inside(0.03L, 1, 0.01L);
    REQUIRE(inside.size() > 1);
    REQUIRE(inside.light(1));
    CHECK(adiabatic::check_leaf(leaf, nullptr) != nullptr);
    leaf.outside = true;
    CHECK(adiabatic::check_leaf(leaf, nullptr) != nullptr);
}

TEST_CASE("adiabatic: a leaf of a bounce needs no bounds where the light mass does not collide next") {
    Adiabatics file;
    adiabatic::Claim& claim = file.terms.claim;
    claim.kind = adiabatic::Claim::bounce;
    claim.margin = mpq_class(1, 2);
    claim.y_hi = 1;
    claim.delta_lo = claim.delta_hi = mpq_class(1, 5);
    claim.bounds = {0, 0};
    adiabatic::Leaf leaf = file.root(adiabatic::Leaf::claim_tree, 0);
    leaf.box.lo.at(adiabatic::axis_u) = mpq_class(3, 2);  // low on the wall
    leaf.box.hi.at(adiabatic::axis_u) = mpq_class(31, 20);
    leaf.box.lo.at(adiabatic::axis_s) = mpq_class(9, 10);
    const AdiabaticOrbit inside(1.52L, 0.95L, 0.2L);
    REQUIRE(inside.size() > 1);
    CHECK_FALSE(inside.light(1));
    CHECK(adiabatic::check_leaf(leaf, nullptr) == nullptr);
    leaf.box.lo.at(adiabatic::axis_u) = 1;
    CHECK(adiabatic::check_leaf(leaf, nullptr) != nullptr);
}

namespace {

/// Leaves are checked with a class whose own tree is not: one like those of adiabatic_claims_test, whose
/// trees are.
std::array<long, 4> try_run_leaf(adiabatic::Claim::Kind kind, long trials) {
    std::array<long, 4> seen{};
    auto& [bounds, outsides, states, refuted] = seen;
    for (long i = 0; i < trials; ++i) {
        Adiabatics file;
        adiabatic::Claim& claim = file.terms.claim;
        claim.kind = kind;
        const bool whole = kind == adiabatic::Claim::scattering;
        const double delta = whole ? power_of_two(-11, -9) : power_of_two(-7, -4);
        claim.exponent = whole ? 8 : 0;
        claim.margin = whole ? mpq_class(uniform(0.8, 1)) : mpq_class(uniform(0.4, 0.8));
        const double least = claim.margin.get_d() * (whole ? std::sqrt(delta) : 1);
        claim.y_lo = mpq_class(uniform(0.3, 0.6));
        claim.y_hi = mpq_class(uniform(0.8, 1));
        claim.delta_lo = claim.delta_hi = mpq_class(delta);
        if (whole)
            file.add_class(mpq_class(19, 10), cells_down_to(mpq_class(1, 128), 150, 1.3, 4));
        else
            file.add_class(mpq_class(13, 10), cells_down_to(mpq_class(1, 4), 60, 1.3, 2));
        double u = 0, s = 0;
        std::optional<AdiabaticOrbit> typical;
        do {  // a whole scattering begins high and fast
            u = least * (whole ? uniform(0.95, 1.6) : uniform(0.9, 2));
            s = whole ? 1 - power_of_two(-12, 0) : uniform(0, 1);
            if (u < 1.5) typical.emplace(u, s, delta);
        } while (u >= 1.5 || (whole && engine()() % 8 != 0 && !typical->is_whole()));
        const std::size_t n = whole ? typical->size() - 1 : engine()() % typical->size();
        const Real change =
            std::abs((whole ? typical->I_after(n) : typical->I_before(n)) - typical->I_before(0));
        claim.bounds = {mpq_class(static_cast<double>(change) / std::pow(delta, whole ? 0.5 : 1) *
                                  power_of_two(-0.5, whole ? 5 : 3))};
        adiabatic::Leaf leaf = file.root(adiabatic::Leaf::claim_tree, 0);
        const double size = power_of_two(whole ? -16 : -12, whole ? -9 : -3),
                     v = static_cast<double>(typical->u(n));
        narrow(leaf, adiabatic::axis_u, 0, 2, u, u * size);
        narrow(leaf, adiabatic::axis_v, 0, 2, v, v * size);
        narrow(leaf, adiabatic::axis_s, 0, 1, s, size);
        leaf.outside = engine()() % 3 == 0;
        const bool accepted = adiabatic::check_leaf(leaf, nullptr) == nullptr;
        (leaf.outside ? outsides : bounds) += accepted;
        const Real C =
            claim.bounds[0].get_d() * (whole ? std::sqrt(static_cast<Real>(delta)) : delta) + 1e-12L;
        for (int j = 0; j < 3; ++j) {
            const Real angle = j == 0 ? u : within(leaf, adiabatic::axis_u),
                       climb = j == 0 ? s : within(leaf, adiabatic::axis_s);
            if (angle < least || angle >= pi_real / 2) continue;
            if (!holds(leaf, adiabatic::axis_u, angle) || !holds(leaf, adiabatic::axis_s, climb)) continue;
            const AdiabaticOrbit orbit(angle, climb, delta, engine()() % 2 == 0);
            if (whole ? !orbit.is_whole()
                      : orbit.y(0) < claim.y_lo.get_d() || orbit.y(0) > claim.y_hi.get_d())
                continue;
            for (std::size_t m = whole ? orbit.size() - 1 : 0; m < orbit.size(); ++m) {
                if (!orbit.light(m) || orbit.u(m) < least) break;
                if (!holds(leaf, adiabatic::axis_v, orbit.u(m))) continue;
                const Real I = whole ? orbit.I_after(m) : orbit.I_before(m);
                const bool breaks = leaf.outside || std::abs(I - orbit.I_before(0)) > C;
                INFO("u " << angle << " s " << climb << " delta " << delta << " collision " << m << " at "
                          << orbit.u(m));
                if (accepted) REQUIRE_FALSE(breaks);
                ++(breaks ? refuted : states);
            }
        }
    }
    return seen;
}

}  // namespace

TEST_CASE("adiabatic: of a run the last collision may be so near to the vertical that w^2 < r") {
    Adiabatics file;
    adiabatic::Claim& claim = file.terms.claim;
    claim.kind = adiabatic::Claim::run;
    claim.margin = mpq_class(1, 64);
    claim.y_hi = 1;
    claim.delta_lo = claim.delta_hi = mpq_class(1, 3);
    claim.bounds = {20};
    file.add_class(mpq_class(4, 5), {{mpq_class(1, 64), mpq_class(0)}});
    adiabatic::Leaf leaf = file.root(adiabatic::Leaf::claim_tree, 0);
    leaf.box.lo.at(adiabatic::axis_u) = leaf.box.hi.at(adiabatic::axis_u) = mpq_class(5, 4);
    leaf.box.lo.at(adiabatic::axis_s) = 1;
    leaf.box.lo.at(adiabatic::axis_v) = leaf.box.hi.at(adiabatic::axis_v) = mpq_class(9, 32);
    CHECK(adiabatic::check_leaf(leaf, nullptr) == nullptr);
    claim.bounds = {1};
    CHECK(std::string(adiabatic::check_leaf(leaf, nullptr)) == "|I_n - I_0|/delta <= C");
}

namespace {

/// Of `of` trials there are more than so many bounds, leaves outside, states, and claims refused.
void check_run_leaves(adiabatic::Claim::Kind kind, long trials, const std::array<long, 4>& least, long of) {
    const auto seen = try_run_leaf(kind, trials);
    for (std::size_t i = 0; i < least.size(); ++i) {
        INFO(i << ": " << seen.at(i) << " of " << trials);
        CHECK(seen.at(i) * of > least.at(i) * trials);
    }
}

}  // namespace

TEST_CASE("adiabatic: no accepted leaf of a run holds an orbit whose invariant changes more") {
    check_run_leaves(adiabatic::Claim::run, scaled(600), {200, 100, 1000, 1000}, 2500);
}

TEST_CASE("adiabatic: no accepted leaf of a scattering holds one whose invariant changes more") {
    check_run_leaves(adiabatic::Claim::scattering, scaled(60), {30, 5, 100, 100}, 400);
}
