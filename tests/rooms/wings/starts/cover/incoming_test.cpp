// All incoming trajectories by the natural measure (lemma L61): pieces of the section as states, the file,
// the verifier, and the simulation.
#include "starts/cover/incoming.hpp"

#include <cmath>

#include "attacks/oracle/simulate.hpp"
#include "attacks/oracle/tangents.hpp"
#include "catch.hpp"
#include "rooms/verify/wings/starts/make_file.hpp"
#include "rooms/wings/starts/box.hpp"
#include "rooms/wings/starts/histogram.hpp"
#include "rooms/wings/starts/sample.hpp"
#include "rooms/wings/starts/written_file.hpp"
#include "starts/answer/reader.hpp"
#include "starts/answer/shares.hpp"
#include "starts/cover/leaf.hpp"
#include "verify/wings/starts/grammar.hpp"

using namespace dumbbell;
using namespace dumbbell::starts;
using namespace dumbbell_test;
using dumbbell_trace_test::checked;
using dumbbell_trace_test::for_each_leaf;
using dumbbell_trace_test::refusal;
using dumbbell_trace_test::uniform;
using make::mutated;

namespace {

using Number = dumbbell_oracle::Real;

SealedText sealed(const Rational& q, const Subdivision& parts) {
    return render({.box = incoming_box(q), .tree = parts.tree.nodes(), .incoming = true});
}

/// s sqrt(q/(1 - s^2)).
long double spin(long double s, long double q) { return s * std::sqrt(q / (1 - s * s)); }

}  // namespace

TEST_CASE("a piece of the section becomes the same states here and in the verifier, outward") {
    std::mt19937_64 engine(1);
    for (int i = 0; i < 300; ++i) {
        const double q = std::exp(uniform(engine, 0, 12)), s = uniform(engine, 0, 0.9),
                     x = uniform(engine, 0, 1.9);
        Box piece = incoming_box(exact(q));
        piece.lo[0] = exact(x);
        piece.hi[0] = piece.lo[0] + Rational(1, 1024);
        piece.lo[1] = exact(s);
        piece.hi[1] = piece.lo[1] + Rational(1, 1024);
        const Box states = states_of_incoming(piece);
        dumbbell_verify::starts::Box same;
        for (std::size_t axis = 0; axis < axis_count; ++axis) {
            same.lo[axis] = mpq_class(piece.lo[axis].raw());
            same.hi[axis] = mpq_class(piece.hi[axis].raw());
        }
        const dumbbell_verify::starts::Box checked = dumbbell_verify::starts::incoming_states(same);
        constexpr long double pi = 3.14159265358979323846264338327950288L;
        const auto below = [](long double a, long double b) { return a <= b * (1 + 1e-17L) + 1e-17L; };
        const auto tight = [](long double a, long double b) {
            return std::abs(a - b) <= 1e-17L * (1 + std::abs(b));
        };
        INFO("q " << q << " x " << x << " s " << s);
        const std::array<long double, 2> ends_of_phi{pi * x, pi * (x + 1.0L / 1024)};
        const std::array<long double, 2> ends_of_spin{spin(s, q), spin(s + 1.0L / 1024, q)};
        CHECK(below(states.lo[0].convert_to<long double>(), ends_of_phi[0]));
        CHECK(below(ends_of_spin[1], states.hi[1].convert_to<long double>()));
        CHECK(tight(states.hi[0].convert_to<long double>(), ends_of_phi[1]));
        CHECK(tight(states.lo[1].convert_to<long double>(), ends_of_spin[0]));
        for (std::size_t axis = 0; axis < axis_count; ++axis) {
            const Rational lo(checked.lo[axis].get_mpq_t()), hi(checked.hi[axis].get_mpq_t());
            CHECK(abs(lo - states.lo[axis]) < parse_rational("1e-45"));
            CHECK(abs(hi - states.hi[axis]) < parse_rational("1e-45"));
            CHECK(lo <= states.hi[axis]);
            CHECK(states.lo[axis] <= hi);
        }
    }
}

TEST_CASE("the verifier's bounds of pi and of the root contain them") {
    Box piece = incoming_box(2);  // s = 3/5: the root of 2 times 3/4
    dumbbell_verify::starts::Box same;
    for (std::size_t axis = 0; axis < axis_count; ++axis) {
        same.lo[axis] = same.hi[axis] = mpq_class(piece.lo[axis].raw());
    }
    same.lo[0] = same.hi[0] = 1;
    same.lo[1] = same.hi[1] = mpq_class(3, 5);
    const auto states = dumbbell_verify::starts::incoming_states(same);
    const PrecisionScope scope(300);
    const auto half_turn = pi<BigInterval>();
    CHECK(Rational(states.lo[0].get_mpq_t()) < exact_lo(half_turn));
    CHECK(exact_hi(half_turn) < Rational(states.hi[0].get_mpq_t()));
    CHECK((states.lo[1] * states.lo[1] < mpq_class(9, 8)));
    CHECK((states.hi[1] * states.hi[1] > mpq_class(9, 8)));
}

TEST_CASE("certificates about incoming trajectories are verified, with the same shares, and read again") {
    for (const char* q : {"1", "4.61", "10", "100", "1000"}) {
        INFO("q = " << q);
        const Rational ratio = parse_rational(q);
        const auto parts = subdivide(incoming_box(ratio), {.max_boxes = 300, .jobs = 2, .incoming = true});
        CHECK(parts.least == 1);
        const SealedText written = sealed(ratio, parts);
        CHECK(written.text.find("claim incoming\nratio ") != std::string::npos);
        const auto proof = checked(written.text);
        CHECK(proof.paragraph().ends_with("\n" + share_lines(share_bounds(parts.tree))));
        CHECK(proof.text().starts_with("claim=incoming ratio="));
        CHECK(render(read_certificate(make::File(written.text).path())).sha256 == written.sha256);
    }
}

TEST_CASE("up to s = 1 nothing is certified but that all states fall") {
    const std::string text =
        sealed(10, subdivide(incoming_box(10), {.max_boxes = 200, .incoming = true})).text;
    CHECK(refusal(text).empty());
    const std::string root = make::closed(
        "dumbbell-certificate 1\ngenerator dumbbell 0.1.0\nlemmas 1\nscene dumbbell\nsection none\n"
        "claim incoming\nratio 10/1 10/1\nbits 53\nbetween 1 4\nbetween 1 4\n");
    CHECK(refusal(root).empty());
    const std::string bounds = "between 1 4\nbetween 1 4\n";
    const auto with = [&](const std::string& changed) { return refusal(mutated(root, bounds, changed)); };
    CHECK_THAT(with("between 2 4\nbetween 2 4\n"), Contains("not certified"));
    CHECK_THAT(with("between 1 3\nbetween 1 3\n"), Contains("not certified"));
    CHECK_THAT(with("between 1 4\nbetween 1 4 light 1b0 1b1\n"), Contains("up to s = 1"));
    CHECK_THAT(with("between 0 0\nexactly 0\n"), Contains("up to s = 1"));
    CHECK_THAT(refusal(mutated(root, "ratio 10/1 10/1", "ratio 10/1 11/1")), Contains("LO = HI"));
    CHECK_THAT(refusal(mutated(text, "split s", "split phidot")), Contains("not an axis"));
    CHECK_FALSE(refusal(mutated(text, "split s", "split phi")).empty());
    CHECK_FALSE(refusal(mutated(text, "ratio 10/1 10/1", "ratio 100/1 100/1")).empty());
}

TEST_CASE("the maximum over all trajectories is known beyond the counts that a leaf may bound") {
    for (const auto& [ratio, n] : std::vector<std::pair<const char*, long>>{
             {"10", 4}, {"1e12", 885597}, {"1e14", 8855953}, {"1e20", 8855951296}}) {
        CAPTURE(ratio);
        CHECK(most_of_all(incoming_box(parse_rational(ratio))) == n);
    }
    CHECK_FALSE(judge_falling(incoming_box(parse_rational("1e14"))).most);
    CHECK_FALSE(most_of_all(incoming_box(parse_rational("1e40"))));  // more than doubles count
}

TEST_CASE("L72, L84: what is said of all motions of a body is no less than its maximum by Theorem B") {
    using dumbbell_oracle::Numbers;
    const std::pair<Numbers, long> known[] = {{{1, 4}, 4},        {{1, 3}, 3},
                                              {{0.5, 9}, 7},      {{0.5, 0.5}, 4},
                                              {{0.28, 1e4}, 160}, {dumbbell_oracle::rod(5, 1e-3), 6}};
    for (const auto& [n, most] : known) {
        CAPTURE(n.rho, n.q);
        CHECK(most_of_all(incoming_box(exact(n.q), exact(n.rho))) == most);
        CHECK(static_cast<long>(dumbbell_oracle::TheoremB::of<long double>(n).maximum()) <= most);
    }
}

TEST_CASE("no leaf says more than the maximum over all trajectories, and less than that is refused") {
    for (const auto& [q, n] : std::vector<std::pair<const char*, long>>{{"1", 2},
                                                                        {"1.0000001", 3},
                                                                        {"4.6", 3},
                                                                        {"4.603338848", 3},
                                                                        {"4.603338849", 4},
                                                                        {"4.61", 4},
                                                                        {"10", 4},
                                                                        {"12", 5},
                                                                        {"100", 10},
                                                                        {"1000", 29},
                                                                        {"1e6", 887},
                                                                        {"1e9", 28006}}) {
        INFO("q = " << q);
        const Rational ratio = parse_rational(q);
        CHECK(judge_falling(incoming_box(ratio)).most == n);
        const auto root = [&](long most) {
            const std::string bounds = "between 1 " + std::to_string(most) + "\n";
            return make::closed(
                "dumbbell-certificate 1\ngenerator dumbbell 0.1.0\nlemmas 1\nscene dumbbell\nsection none\n"
                "claim incoming\nratio " +
                to_fraction(ratio) + " " + to_fraction(ratio) + "\nbits 53\n" + bounds + bounds);
        };
        CHECK(refusal(root(n)).empty());
        CHECK(refusal(root(n + 1)).empty());
        if (n > 2) {
            CHECK_THAT(refusal(root(n - 1)), Contains("M <= most"));
        }
    }
}

TEST_CASE("what each leaf says holds for a simulated trajectory of its piece, and for its mirror image") {
    std::mt19937_64 engine(8);
    for (const char* q : {"1", "4.61", "10", "100", "1000"}) {
        const Rational ratio = parse_rational(q);
        const dumbbell_oracle::Dumbbell<Number> body(ratio.convert_to<double>());
        const auto parts = subdivide(incoming_box(ratio), {.max_boxes = 4000, .jobs = 2, .incoming = true});
        int decided = 0, simulated = 0;
        for_each_leaf(parts.tree, incoming_box(ratio), [&](const Box& piece, const Leaf& leaf) {
            const auto within = [&](Axis axis) {
                const double u = uniform(engine, 0, 1);
                const Rational lo = piece.lower(axis), hi = piece.upper(axis);
                return Number((lo + exact(u) * (hi - lo)).convert_to<double>());
            };
            const Number phi = within(Axis::phi) * dumbbell_oracle::pi<Number>();
            const Number s = std::min<Number>(within(Axis::phidot), 1 - 1e-6L);
            const bool mirrored = uniform(engine, 0, 1) < 0.5;
            // At yhat = 2, where each has turned back by what it turns on the way down (L61).
            const Number turn = s * std::sqrt(body.ratio() / (1 - s * s)), back = phi - turn * (1 - 0x1p-20L);
            const auto run = simulate(body, dumbbell_oracle::State<Number>{
                                                mirrored ? dumbbell_oracle::pi<Number>() - back : back,
                                                mirrored ? -turn : turn, 2 * body.beta2(), -body.beta2()});
            if (run.care.doubtful()) {
                return;
            }
            const auto found = static_cast<long>(run.collisions.size());
            INFO("q " << q << " phi " << phi << " s " << s << ": " << found << " collisions");
            REQUIRE(leaf.least <= found);
            REQUIRE(leaf.most);
            REQUIRE(found <= *leaf.most);
            ++simulated;
            decided += leaf.least == *leaf.most ? 1 : 0;
        });
        CHECK(simulated > 3000);
        CHECK(decided > 200);
    }
}

TEST_CASE(
    "L77: random incoming motions have each number of collisions as often as is proved, of bodies too") {
    std::mt19937_64 engine(7);
    const auto boxes = static_cast<std::size_t>(std::min(scaled(500), 3000L));
    for (const auto& [q, rho] : std::vector<std::pair<const char*, double>>{
             {"1", 0}, {"4.61", 0}, {"10", 0}, {"100", 0}, {"1000", 0}, {"4", 1}, {"3", 0.5}}) {
        INFO("q " << q << " rho " << rho);
        const Rational ratio = parse_rational(q);
        const auto number = ratio.convert_to<Number>();
        const Number far = 1 / (1 + (rho > 0 ? Number(rho) : 1 / number)), near = 1 - far;
        const dumbbell_oracle::Dumbbell<Number> body(far, near, far * far / number);
        dumbbell_trace_test::Histogram found;
        for (int i = 0; i < scaled(2'500); ++i) {
            const Number phi = uniform(engine, 0, 6.283185307179586), s = uniform(engine, -1, 1);
            // From twice the height of the highest wall; only the direction matters.
            found.add(simulate(body, dumbbell_oracle::State<Number>{phi, s * std::sqrt(number), 2 * far,
                                                                    -std::sqrt(1 - s * s) * far}));
        }
        const Box all = incoming_box(ratio, rho > 0 ? std::optional(exact(rho)) : std::nullopt);
        found.check(share_bounds(subdivide(all, {.max_boxes = boxes, .jobs = 2, .incoming = true}).tree));
    }
}
