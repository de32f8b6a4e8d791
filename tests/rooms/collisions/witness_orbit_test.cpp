#include "collisions/witness_orbit.hpp"

#include "attacks/oracle/simulate.hpp"
#include "catch.hpp"
#include "collisions/piece.hpp"
#include "reference.hpp"

using namespace dumbbell;
using namespace dumbbell::collisions;
using namespace dumbbell_test;

namespace {

std::vector<dumbbell_oracle::Collision<Real>> simulated(const Witness& w, const Rational& q) {
    const dumbbell_oracle::Dumbbell<Real> body(real(q));
    const dumbbell_oracle::BridgeState<Real> state{real(w.e), real(w.eta)};
    return whole_trajectory(body, contact_of(body, state));
}

bool holds(const Interval& x, const Real& value) { return Real(x.lo()) <= value && value <= Real(x.hi()); }

}  // namespace

TEST_CASE("the simulated orbit of a witness stays in its enclosures: mass, time, angle, height, velocities") {
    for (const char* text : {"1", "1.1", "4.61", "10", "12", "100"}) {
        CAPTURE(text);
        const Rational q = parse_rational(text);
        const ProvedPiece proved = prove_single(q, {});
        REQUIRE(proved.piece.witness.has_value());
        const auto orbit = witness_orbit(*proved.piece.witness, q, proved.piece.bits);
        const auto real_orbit = simulated(*proved.piece.witness, q);
        REQUIRE(static_cast<long>(orbit.size()) == proved.piece.lower);
        REQUIRE(real_orbit.size() == orbit.size());

        // The unit of time: phidot^2 + q (ydot / beta2)^2 = 1.
        const dumbbell_oracle::Dumbbell<Real> body(real(q));
        const auto& first = real_orbit.front().before;
        const Real climb = first.ydot / body.beta2();
        const Real speed = sqrt(first.phidot * first.phidot + real(q) * climb * climb);
        for (std::size_t i = 0; i < orbit.size(); ++i) {
            CAPTURE(i);
            const auto& enclosed = orbit[i];
            const auto& collision = real_orbit[i];
            CHECK(enclosed.heavy == (collision.mass == dumbbell_oracle::Mass::heavy));
            CHECK(holds(enclosed.time, (collision.time - real_orbit.front().time) * speed));
            CHECK(holds(enclosed.phi, collision.before.phi));
            CHECK(holds(enclosed.y, collision.before.y));
            CHECK(holds(enclosed.phidot_before, collision.before.phidot / speed));
            CHECK(holds(enclosed.phidot_after, collision.after.phidot / speed));
            CHECK(holds(enclosed.ydot_before, collision.before.ydot / speed));
            CHECK(holds(enclosed.ydot_after, collision.after.ydot / speed));
            CHECK(holds(enclosed.grazing_sine, body.grazing_sine(collision.mass, collision.before)));
        }
    }
}

TEST_CASE("exactly one collision is the heavy mass's, time runs, and every contact is transversal") {
    const Rational q = 1000;
    const ProvedPiece proved = prove_single(q, {});
    const auto orbit = witness_orbit(*proved.piece.witness, q, 53);
    REQUIRE(orbit.size() == 29);
    int heavy = 0;
    for (std::size_t i = 0; i < orbit.size(); ++i) {
        heavy += orbit[i].heavy ? 1 : 0;
        CHECK(orbit[i].grazing_sine.lo() > 0);
        CHECK((i == 0 || orbit[i].time.lo() > orbit[i - 1].time.hi()));
    }
    CHECK(heavy == 1);
    CHECK(orbit.front().time.lo() == 0);
    CHECK(orbit.front().time.hi() == 0);
}

TEST_CASE("more bits give an orbit at least as narrow, inside the same values") {
    const Rational q = 100;
    const Witness w = *prove_single(q, {}).piece.witness;
    const auto coarse = witness_orbit(w, q, 53);
    const auto fine = witness_orbit(w, q, 256);
    REQUIRE(coarse.size() == fine.size());
    for (std::size_t i = 0; i < coarse.size(); ++i) {
        CHECK(fine[i].y.lo() >= coarse[i].y.lo());
        CHECK(fine[i].y.hi() <= coarse[i].y.hi());
        CHECK(width(fine[i].phi) < 1e-14);
    }
}

TEST_CASE("counts that the contact does not have give no orbit") {
    Witness w = *prove_single(10, {}).piece.witness;
    w.forward += 1;
    CHECK(witness_orbit(w, 10, 53).empty());
}
