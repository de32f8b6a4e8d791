// Whatever dumbbell-verify certifies of a box of initial conditions holds for the simulated orbits of its
// points (tests/attacks/oracle: another program, other formulas), no matter who makes the claim.
#include "attacks/oracle/simulate.hpp"
#include "attacks/oracle/trial.hpp"
#include "catch.hpp"
#include "rooms/wings/starts/box.hpp"
#include "rooms/wings/starts/written_file.hpp"
#include "verify/wings/starts/grammar.hpp"

namespace {

using dumbbell::starts::Box;
using dumbbell_oracle::Dumbbell;
using dumbbell_oracle::Real;
using dumbbell_oracle::State;
using dumbbell_trace_test::for_each_leaf;
using dumbbell_trace_test::random_sides;
using dumbbell_trace_test::refusal;
using dumbbell_trace_test::Sides;
using dumbbell_trace_test::uniform;
using dumbbell_trace_test::written;

/// A point of a box, often one of its corners.
struct Point {
    State<Real> start;
    Real q;
};
Point random_point(std::mt19937_64& engine, const std::array<double, 5>& lo,
                   const std::array<double, 5>& hi) {
    const auto side = [&](std::size_t i) {
        const auto pick = engine() % 4;
        return pick == 0 ? lo.at(i) : pick == 1 ? hi.at(i) : uniform(engine, lo.at(i), hi.at(i));
    };
    const auto phi = side(0), phidot = side(1), y = side(2), ydot = side(3), q = side(4);
    return {{phi, phidot, y, ydot}, q};
}

std::string describe(const Point& p) {
    return dumbbell_oracle::say("q", p.q, "phi", p.start.phi, "phidot", p.start.phidot, "y", p.start.y,
                                "ydot", p.start.ydot);
}

/// The point's orbit does what the leaf says; or it is too close to a corner or a tangency to tell.
template <class Run, class Leaf>
bool agrees(const Run& run, const Leaf& leaf, std::uint64_t least, std::optional<std::uint64_t> most,
            Real from, Real until) {
    if (run.care.doubtful()) {
        return true;
    }
    const std::uint64_t count = run.collisions.size();
    if (count < least || (most && count > *most)) {
        return false;
    }
    if (!leaf.first) {
        return true;
    }
    const auto& first = run.collisions.front();
    const Real tolerance = 1e-12L * (1 + first.time);
    return leaf.first->heavy == (first.mass == dumbbell_oracle::Mass::heavy) &&
           from - tolerance <= first.time && first.time <= until + tolerance;
}

mpq_class exact_mpq(double x) { return mpq_class(x); }

}  // namespace

TEST_CASE("The leaves of verified files hold for the simulated orbits of their points") {
    constexpr double ratios[] = {1, 1.5, 3, 10, 100, 10000};
    std::mt19937_64 engine(4242);
    const long files = scaled(200);
    long checked = 0;
    for (int i = 0; i < files; ++i) {
        const Sides sides = random_sides(engine, ratios[i % 6], std::pow(10.0, -uniform(engine, 0, 3)));
        Box box = sides.box();
        if (i % 3 == 0) {
            box.hi[4] = box.lo[4] * dumbbell::exact(1 + 0.125 * uniform(engine, 0, 1));
        }
        const auto parts = dumbbell::starts::subdivide(box, {.max_boxes = 16});
        REQUIRE(refusal(written(box, parts)) == "");
        for_each_leaf(parts.tree, box, [&](const Box& here, const dumbbell::starts::Leaf& leaf) {
            std::array<double, 5> lo{}, hi{};
            for (std::size_t k = 0; k < 5; ++k) {
                lo.at(k) = here.lo[k].convert_to<double>();
                hi.at(k) = here.hi[k].convert_to<double>();
            }
            for (int n = 0; n < 8; ++n) {
                const Point p = random_point(engine, lo, hi);
                const auto run = dumbbell_oracle::simulate(Dumbbell<Real>(p.q), p.start);
                checked += run.care.doubtful() ? 0 : 1;
                INFO(describe(p) << "simulated " << run.collisions.size() << ", leaf " << leaf.least << " to "
                                 << leaf.most.value_or(-1));
                REQUIRE(
                    agrees(run, leaf, static_cast<std::uint64_t>(leaf.least),
                           leaf.most ? std::optional(static_cast<std::uint64_t>(*leaf.most)) : std::nullopt,
                           leaf.first ? leaf.first->from.convert_to<Real>() : 0,
                           leaf.first ? leaf.first->until.convert_to<Real>() : 0));
            }
        });
    }
    CHECK(checked > 80 * files / 3);
}

TEST_CASE("What the verifier accepts of claims made up at random is true") {
    constexpr double ratios[] = {1, 1.5, 3, 10, 100, 10000};
    std::mt19937_64 engine(31);
    const long claims = scaled(1'000);
    long accepted = 0, refused = 0, exact_ones = 0;
    for (int i = 0; i < claims; ++i) {
        const double q = ratios[i % 6];
        Sides sides = random_sides(engine, q, std::pow(10.0, -uniform(engine, 0.5, 6)));
        if (i % 4 == 0) {  // low starts that fall or rise slowly
            sides.y_lo = uniform(engine, 0.1, 1);
            sides.y_hi = sides.y_lo;
            sides.ydot_lo = uniform(engine, -0.2, 0.3);
            sides.ydot_hi = sides.ydot_lo + (sides.phi_hi - sides.phi_lo);
        }
        const double q_hi = i % 5 == 0 ? q * (1 + (sides.phi_hi - sides.phi_lo)) : q;
        const std::array lo{sides.phi_lo, sides.phidot_lo, sides.y_lo, sides.ydot_lo, q};
        const std::array hi{sides.phi_hi, sides.phidot_hi, sides.y_hi, sides.ydot_hi, q_hi};
        dumbbell_verify::starts::Leaf leaf;
        for (std::size_t k = 0; k < 5; ++k) {
            leaf.box.lo.at(k) = exact_mpq(lo.at(k));
            leaf.box.hi.at(k) = exact_mpq(hi.at(k));
        }
        if (!dumbbell_verify::starts::starts_in_the_air(leaf.box, 53)) {
            continue;
        }
        // Of one point or near it: its number of collisions, its first contact.
        const Point guide = random_point(engine, lo, hi);
        if (guide.start.phidot == 0 && guide.start.ydot == 0) {
            continue;
        }
        const auto guiding = dumbbell_oracle::simulate(Dumbbell<Real>(guide.q), guide.start);
        const auto k = static_cast<long>(guiding.collisions.size()) + static_cast<long>(engine() % 3) - 1;
        const long more = engine() % 3 == 0 ? static_cast<long>(engine() % 3) : 0;
        leaf.least = static_cast<std::uint64_t>(std::max(0L, k));
        leaf.most = leaf.least + static_cast<std::uint64_t>(more);
        Real from = 0, until = 0;
        if (!guiding.collisions.empty() && leaf.least > 0) {
            const Real time = guiding.collisions.front().time;
            const Real width = time * std::pow(10.0L, -static_cast<Real>(uniform(engine, 0, 7)));
            from = static_cast<double>(time - width * static_cast<Real>(uniform(engine, -0.1, 1)));
            until = static_cast<double>(time + width * static_cast<Real>(uniform(engine, -0.1, 1)));
            if (from > 0 && from < until) {
                const bool heavy =
                    (guiding.collisions.front().mass == dumbbell_oracle::Mass::heavy) != (engine() % 20 == 0);
                leaf.first = {heavy, exact_mpq(static_cast<double>(from)),
                              exact_mpq(static_cast<double>(until))};
            }
        }
        leaf.multiple = i % 50 == 0;
        leaf.bits = leaf.multiple ? 90 : 53;
        if (dumbbell_verify::starts::check_leaf(leaf, nullptr) != nullptr) {
            ++refused;
            continue;
        }
        ++accepted;
        exact_ones += leaf.least == leaf.most ? 1 : 0;
        for (int j = 0; j < 20; ++j) {
            const Point p = random_point(engine, lo, hi);
            const auto run = dumbbell_oracle::simulate(Dumbbell<Real>(p.q), p.start);
            INFO(describe(p) << "simulated " << run.collisions.size() << ", accepted " << leaf.least << " to "
                             << leaf.most << " window " << from << " " << until);
            REQUIRE(agrees(run, leaf, leaf.least, leaf.most, from, until));
        }
    }
    INFO("accepted " << accepted << ", exactly " << exact_ones << ", refused " << refused);
    CHECK(exact_ones > claims / 15);
    CHECK(refused > claims / 15);
}
