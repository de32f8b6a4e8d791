// False claims about initial conditions, spelt correctly and with a fitting trailer, are refused.
#include "catch.hpp"
#include "make_file.hpp"
#include "verify/wings/starts/grammar.hpp"

using make::closed;
using make::falling;
using make::initial_header;
using make::mutated;
using make::outcome;

namespace {

/// About all incoming trajectories.
std::string incoming(const std::string& tree, const std::string& bounds, const std::string& ratio) {
    return closed(
        "dumbbell-certificate 1\ngenerator test 1.0\nlemmas 1\nscene dumbbell\n"
        "section none\nclaim incoming\nratio " +
        ratio + "\nbits 53\nbetween " + bounds + "\n" + tree);
}

}  // namespace

TEST_CASE("`exactly 0` is for starts that leave") {
    const auto zero = [](const std::string& phidot, const std::string& y, const std::string& ydot) {
        return outcome(
            closed(initial_header("10/1 10/1", "1/1 2/1", phidot, y, ydot) + "between 0 0\nexactly 0\n"));
    };
    CHECK(zero("-1/1 1/1", "1/1 1/1", "1/1 2/1") == "verified");  // steep (the slope is ydot (1 + r))
    CHECK(zero("-9/10 1/2", "1/5 1/5", "9/10 1/1") == "verified");
    CHECK(zero("2/1 2/1", "1/5 1/5", "1/2 1/1") == "exactly");    // flat and low
    CHECK(zero("2/1 2/1", "1/1 1/1", "0/1 1/1") == "verified");   // above all walls
    CHECK(zero("2/1 2/1", "9/10 1/1", "0/1 1/1") == "exactly");   // a part of the box is above
    CHECK(zero("2/1 2/1", "9/10 9/10", "0/1 1/1") == "exactly");  // height 0.99
    CHECK(zero("2/1 2/1", "1/1 1/1", "-1/1000000 1/1") == "exactly");
    CHECK(zero("-1/1 -1/1", "9/10 9/10", "1/10 1/10") == "verified");  // over the peak of the light wall
    CHECK(zero("-1/1 -1/1", "1/2 1/2", "1/10 1/10") == "exactly");     // into that wall
}

TEST_CASE("a piece of the section of incoming trajectories stands for states that hold all of its own") {
    const mpz_class digits("314159265358979323846264338327950288419716939937510582097494459"),
        units("1" + std::string(62, '0'));
    const mpq_class pi_low(digits, units), pi_high(digits + 1, units);
    const mpq_class close(1, mpz_class("1" + std::string(45, '0'))), closer(1, mpz_class(1) << 500);
    for (const mpq_class& q : {mpq_class(1), mpq_class(2), mpq_class(461, 100), mpq_class(1'000'000)})
        for (const mpq_class& s : {mpq_class(0), mpq_class(1, 3), mpq_class(3, 5), mpq_class(1023, 1024)}) {
            dumbbell_verify::starts::Box piece;
            piece.lo = {1, s, 0, 0, q};
            piece.hi = {mpq_class(3, 2), s + mpq_class(1, 4096), 0, 0, q};
            const dumbbell_verify::starts::Box states = dumbbell_verify::starts::incoming_states(piece);
            const auto squared = [&](const mpq_class& x) { return mpq_class(x * x * q / (1 - x * x)); };
            const mpq_class least = states.lo[1], most = states.hi[1], to = piece.hi[1];
            CAPTURE(q.get_d(), s.get_d());
            CHECK((pi_low - close < states.lo[0] && states.lo[0] <= pi_low));
            CHECK((pi_high * 3 / 2 <= states.hi[0] && states.hi[0] < pi_low * 3 / 2 + close));
            CHECK((least >= 0 && least * least <= squared(s) && squared(to) <= most * most));
            CHECK(((least + closer) * (least + closer) > squared(s)));
            CHECK(((most - closer) * (most - closer) < squared(to)));
            CHECK(
                (states.lo[2] == states.hi[2] && states.lo[2] == q / (q + 1) * mpq_class(1048577, 1048576)));
            CHECK((states.lo[3] == states.hi[3] && states.lo[3] == -q / (q + 1)));
            CHECK((states.lo[4] == q && states.hi[4] == q));
        }
}

TEST_CASE("a file about incoming trajectories is one of the section's square, at one mass ratio") {
    const auto code = [](const std::string& tree, const std::string& bounds = "0 none",
                         const std::string& ratio = "2/1 2/1") {
        return outcome(incoming(tree, bounds, ratio));
    };
    CHECK(code("open\n") == "verified");
    CHECK(code("split phi\nopen\nsplit s\nopen\nopen\n") == "verified");
    CHECK(code("split q\nopen\nopen\n") == "syntax");
    CHECK(code("split phidot\nopen\nopen\n") == "syntax");
    CHECK(code("open\n", "0 none", "2/1 3/1") == "number");
    CHECK(code("open\n", "0 none", "1/2 1/2") == "number");
    // All come down, and have at least one collision; up to s = 1 nothing else is known.
    CHECK(code("between 1 9\n", "1 9") == "verified");
    CHECK(code("between 2 9\n", "2 9") == "between");
    CHECK(code("between 1 2\n", "1 2") == "between");
    CHECK(code("exactly 0\n", "0 0") == "section");
    CHECK(code("between 1 9 heavy 1b-3 1b3\n", "1 9") == "section");
    CHECK(code("split s\nbetween 1 9\nbetween 1 9\n", "1 9") == "verified");
    CHECK(code("split s\nexactly 0\nbetween 1 9\n", "0 9") == "exactly");
    const make::File whole(incoming("open\n", "0 none", "2/1 2/1"));
    const auto proof = dumbbell_verify::verify(whole.path(), {});
    const auto box = dynamic_cast<const dumbbell_verify::starts::Claim&>(*proof.other).box;
    CHECK((box.lo == std::array<mpq_class, 5>{0, 0, 0, 0, 2}));
    CHECK((box.hi == std::array<mpq_class, 5>{2, 1, 0, 0, 2}));
}

TEST_CASE("a leaf about incoming trajectories is about all of its piece, however fast they turn") {
    // Upright ones, the heavy mass below, touch the floor after half a unit of time if they do not turn.
    const auto code = [](int halved, const std::string& upright) {
        std::string tree = upright + " heavy 7b-4 17b-5\n";
        for (int i = 0; i < halved; ++i) tree = "split s\n" + tree + "open\n";
        for (int i = 0; i < 7; ++i) tree = "split phi\n" + tree + "open\n";
        return outcome(incoming("split phi\nsplit phi\nopen\n" + tree + "open\n", "0 none", "2/1 2/1"));
    };
    CHECK(code(7, "between 1 9") == "verified");
    CHECK(code(1, "between 1 9") == "between");
}

TEST_CASE("numbers beyond all bounds are refused without harm") {
    const std::string huge(2000, '9'), tiny = "1/" + huge;
    for (const auto& [from, to] : {std::pair{std::string("ratio 10/1 10/1"), "ratio 10/1 " + huge + "/1"},
                                   {"ratio 10/1 10/1", "ratio " + huge + "/1 " + huge + "/1"},
                                   {"phi -1/1 1/1", "phi " + huge + "/1 " + huge + "/1"},
                                   {"phi -1/1 1/1", "phi -" + huge + "/1 -" + huge + "/1"},
                                   {"phidot 1/100 1/100", "phidot -" + huge + "/1 " + huge + "/1"},
                                   {"y 3/2 3/2", "y 3/2 " + huge + "/1"},
                                   {"ydot -1/1 -1/1", "ydot -" + huge + "/1 -1/1"},
                                   {"ydot -1/1 -1/1", "ydot -" + huge + "/1 -" + huge + "/1"},
                                   {"ydot -1/1 -1/1", "ydot -" + tiny + " -" + tiny},
                                   {"exactly 1 heavy", "exactly 999999999999999999 heavy"},
                                   {"between 1 2 heavy", "between 1 999999999999999999 heavy"},
                                   {"91b-6 373b-8", "91b-400 373b-8"},
                                   {"91b-6 373b-8", "91b-6 373b400"}}) {
        for (const unsigned precision : {0U, 100U}) {
            dumbbell_verify::Request settings;
            settings.precision = precision;
            // The clearance falls from the beginning on: an early t0 is no lie.
            const bool true_claim = to.starts_with("between 1 9999") || to.starts_with("91b-400");
            std::string text = mutated(falling(), from, to);
            if (to.find("99999999999 heavy") != std::string::npos)
                text = mutated(text, "between 1 5\n", "between 1 999999999999999999\n");
            INFO(to.substr(0, 60));
            CHECK((outcome(text, settings) == "verified") == true_claim);
        }
    }
}

TEST_CASE("initial conditions: the sentence says how often, and for how many starts that is known") {
    const auto said = [](bool incoming, std::uint64_t least, std::optional<std::uint64_t> most,
                         int quarters) {
        dumbbell_verify::starts::Claim claim;
        claim.incoming = incoming;
        claim.asked = {least, most, mpq_class(quarters) / 4};
        return claim.sentence();
    };
    const std::string proved = "Proved: for every start in the box the dumbbell hits the floor ";
    CHECK(said(false, 2, 5, 1) ==
          proved + "from 2 to 5 times; the number is known for at least a share " + "0.250000000000 of all");
    CHECK(said(false, 0, 1, 0) == proved + "from 0 to 1 time; the number is known for none");
    CHECK(said(false, 3, {}, 0) == proved + "at least 3 times; the number is known for none");
    CHECK(said(false, 3, 3, 4) == proved + "3 times");
    CHECK(said(false, 1, 2, 4) == proved + "from 1 to 2 times; the number is known for each");
    CHECK(said(true, 0, {}, 0) == "No bound is proved that holds for every trajectory that comes in");
}
