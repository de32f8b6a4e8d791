// What `subdivide` leaves undecided lies along borders between counts: open sets of starts are decided, and
// the share that is left shrinks with the number of boxes.
#include <cmath>

#include "attacks/oracle/simulate.hpp"
#include "attacks/oracle/trial.hpp"
#include "catch.hpp"
#include "rooms/wings/starts/box.hpp"
#include "rooms/wings/starts/written_file.hpp"
#include "starts/answer/trace.hpp"

using namespace dumbbell;
using namespace dumbbell::starts;
using dumbbell_oracle::Dumbbell;
using dumbbell_oracle::Real;
using dumbbell_trace_test::refusal;
using dumbbell_trace_test::uniform;
using dumbbell_trace_test::written;

namespace {

/// The box [phi, phi + width] x [phidot, phidot + width] of starts at height y that fall with speed ydot.
Box small_box(double phi, double phidot, double y, double ydot, double q, double width) {
    Box box;
    const std::array lo{phi, phidot, y, ydot, q};
    for (std::size_t i = 0; i < axis_count; ++i) {
        box.lo.at(i) = dumbbell::exact(lo.at(i));
        box.hi.at(i) = dumbbell::exact(i < 2 ? lo.at(i) + width : lo.at(i));
    }
    return box;
}

}  // namespace

TEST_CASE("L60: a contact with the far half of the bridge between two of the light mass is decided") {
    const Box box = small_box(3.1, 1, 2, -1.705, 10, 0x1p-7);
    const Subdivision parts = subdivide(box, {.max_boxes = 64});
    CHECK(parts.undecided.boxes == 0);
    CHECK(parts.least == 3);
    CHECK(parts.most == 3);
    CHECK(refusal(written(box, parts)) == "");
}

TEST_CASE("L60: random starts in the plane of the pictures are decided, and as simulated") {
    std::mt19937_64 engine(606);
    for (const double q : {1.0, 4.7, 10.0, 100.0, 1000.0}) {
        int undecided = 0;
        const long boxes = scaled(200);
        for (int i = 0; i < boxes; ++i) {
            const double phi = uniform(engine, 0, 6.28);
            const double phidot = uniform(engine, -3, 3);
            const Box box = small_box(phi, phidot, 1.5, -1, q, 0x1p-24);
            const Subdivision parts = subdivide(box, {.max_boxes = 1});
            REQUIRE(refusal(written(box, parts)) == "");
            const auto run = dumbbell_oracle::simulate<Real>(Dumbbell<Real>(q), {phi, phidot, 1.5, -1});
            INFO("q " << q << " phi " << phi << " phidot " << phidot);
            undecided += parts.undecided.boxes > 0 ? 1 : 0;
            if (!run.care.doubtful() && parts.undecided.boxes == 0) {
                REQUIRE(parts.least == static_cast<long>(run.collisions.size()));
            }
        }
        INFO("q " << q << ": " << undecided << " of " << boxes);
        CHECK(undecided * 200 <= boxes);
    }
}

TEST_CASE("The undecided share of the pictures' plane shrinks with the number of boxes") {
    Box box;
    box.lo = {0, -3, Rational(3, 2), -1, 10};
    box.hi = {Rational(62832, 10000), 3, Rational(3, 2), -1, 10};
    double before = 1;
    for (const std::size_t boxes : {1024U, 4096U, 16384U}) {
        if (boxes > 4096 && scaled(1) < 20) {
            break;
        }
        const double share =
            subdivide(box, {.max_boxes = boxes, .jobs = 2}).undecided.share.convert_to<double>();
        INFO(boxes << " boxes: " << share << ", exponent " << std::log2(share / before) / 2);
        CHECK(share < before * (boxes == 1024 ? 0.7 : 0.55));
        before = share;
    }
}

TEST_CASE(
    "a start that just misses a corner is decided: the mass that touches first is not the one near it") {
    for (const auto& [beyond, digits] : std::vector<std::pair<const char*, int>>{
             {"8e-10", 0}, {"8e-10", 40}, {"1e-20", 40}, {"1e-30", 60}}) {
        INFO("y = 1 + " << beyond << ", " << digits << " digits");
        Box box;
        box.lo = box.hi = {Rational(-1, 2), Rational(1, 2), 1 + parse_rational(beyond), -1, 10};
        const Trace found = trace(box, digits);
        CHECK(found.exact() == (digits > 0 || std::string(beyond) == "8e-10"));
        REQUIRE_FALSE(found.collisions.empty());
        CHECK(found.collisions.front().heavy);
        CHECK(found.least == 2);
    }
}
