// Whole files about the adiabatic invariant: true claims are verified, false ones, spelt correctly and with a
// fitting trailer, are refused.
#include "catch.hpp"
#include "make_file.hpp"
#include "scale.hpp"

namespace adiabatic = dumbbell_verify::adiabatic;

using namespace make;

namespace {

/// The text with the tree's lines from number `at` (a split) and below replaced by one leaf.
std::string lifted(const std::string& text, std::size_t at, const std::string& leaf) {
    std::vector<std::string> lines;
    std::istringstream in(text.substr(0, text.find("total split")));
    for (std::string line; std::getline(in, line);) lines.push_back(line);
    std::size_t end = at;
    for (int open = 1; open > 0; ++end) open += lines.at(end).starts_with("split") ? 1 : -1;
    std::string result;
    for (std::size_t i = 0; i < lines.size(); ++i)
        if (i < at || i >= end)
            result += lines[i] + "\n";
        else if (i == at)
            result += leaf + "\n";
    return closed(result);
}

/// A whole scattering of five collisions, the last of which is near the vertical.
Adiabatics short_scattering() {
    Adiabatics file = small_claim(adiabatic::Claim::scattering);
    adiabatic::Claim& claim = file.terms.claim;
    claim.margin = mpq_class(1, 1000);
    claim.attained = {{mpq_class(1217, 5000), mpq_class(851, 1000), mpq_class(1, 20), 4, mpq_class(12)}};
    return file;
}

/// What is said of the first attained state by itself.
std::string said_of_state(const Adiabatics& file, unsigned bits = 256) {
    adiabatic::Leaf leaf = file.root(adiabatic::Leaf::attained, 0);
    leaf.bits = bits;
    const char* missing = dumbbell_verify::adiabatic::check_leaf(leaf, nullptr);
    return missing ? missing : "certified";
}

}  // namespace

TEST_CASE("adiabatic: true claims are verified, in double and in multiple precision") {
    dumbbell_verify::Request precise;
    precise.precision = 100;
    for (const std::string* text : {&bounce(), &run_file(), &scattering()}) {
        INFO(text->substr(0, 200));
        CHECK(outcome(*text) == "verified");
        if (text != &scattering()) CHECK(outcome(*text, precise) == "verified");
    }
    CHECK(outcome(gzipped(run_file())) == "verified");
    // Uniformly in delta, down to 0.
    Adiabatics range = small_bounce();
    range.terms.claim.delta_lo = mpq_class(1, 25);
    range.terms.claim.bounds = {3, 11};
    CHECK(outcome(range.file()) == "verified");
    Adiabatics low = small_run();
    low.terms.claim.delta_lo = 0;
    if (scaled(1) < 20) {  // of the lowest contacts only, and one at which nothing has changed yet
        low.terms.claim.margin = mpq_class(9, 10);
        low.terms.claim.attained[0] = {mpq_class(91, 100), mpq_class(97, 100), mpq_class(1, 20), 0, 0};
    }
    low.terms.claim.bounds = {40};
    const std::string from_0 = low.file();
    CHECK(outcome(from_0) == "verified");
    CHECK(mutant(from_0, "97/100 1/20 ", "97/100 0/1 ") == "number");
}

TEST_CASE("adiabatic: bounds below what some state attains are refused") {
    CHECK(mutant(bounce(), "bound 5/2 10/1", "bound 194/100 10/1") == "number");  // not in lowest terms
    CHECK(mutant(bounce(), "bound 5/2 10/1", "bound 97/50 10/1") == "bound");
    CHECK(mutant(bounce(), "bound 5/2 10/1", "bound 5/2 857/100") == "bound");
    CHECK(mutant(bounce(), "bound 5/2 10/1", "bound 0/1 10/1") == "bound");
    CHECK(mutant(run_file(), "bound 20/1", "bound 93/10") == "bound");
    CHECK(mutant(scattering(), "bound 60/1", "bound 69/20") == "bound");
}

TEST_CASE("adiabatic: attained values above the true ones are refused, and those below are not") {
    CHECK(mutant(bounce(), "1 97/50\n", "1 391/200\n") == "attained");  // 1.946 is true
    CHECK(mutant(bounce(), "1 97/50\n", "1 1/50\n") == "verified");
    CHECK(mutant(bounce(), "1 857/100\n", "1 859/100\n") == "attained");
    CHECK(mutant(bounce(), "1 857/100\n", "1 0/1\n") == "verified");
    CHECK(mutant(run_file(), " 10 93/10\n", " 10 467/50\n") == "attained");
    CHECK(mutant(run_file(), " 10 93/10\n", " 10 932/100\n") == "number");
    CHECK(mutant(run_file(), " 10 93/10\n", " 10 233/25\n") == "verified");
    CHECK(mutant(scattering(), " 4431 69/20\n", " 4431 7/2\n") == "attained");
    // 12.8811867742437 is true, and more than doubles show.
    Adiabatics file = short_scattering();
    file.terms.claim.attained[0].value = mpq_class("12881186774243/1000000000000");
    CHECK(said_of_state(file) == "certified");
    file.terms.claim.attained[0].value = mpq_class("3220296693561/250000000000");
    CHECK(said_of_state(file) == "the value is attained");
}

TEST_CASE("adiabatic: at a large delta values are taken up to their sixth digit, and not beyond") {
    Adiabatics file = small_bounce();
    adiabatic::Claim& errors = file.terms.claim;
    errors.delta_lo = errors.delta_hi = mpq_class(1, 3);
    errors.y_lo = 0;
    errors.bounds = {2, 7};
    for (auto& state : errors.attained) {
        state.u = mpq_class(188553, 250000);
        state.delta = mpq_class(1, 3);
    }
    errors.attained[0].value = mpq_class(647029, 500000);  // 1.2940580968 is true
    errors.attained[1].value = mpq_class(228231, 50000);   // 4.5646271305
    const std::string text = file.file();
    CHECK(outcome(text) == "verified");
    CHECK(mutant(text, "1 647029/500000\n", "1 1294059/1000000\n") == "attained");
    CHECK(mutant(text, "1 228231/50000\n", "1 456463/100000\n") == "attained");

    file = short_scattering();
    adiabatic::Claim& change = file.terms.claim;
    change.delta_lo = change.delta_hi = mpq_class(3, 10);
    change.attained = {
        {mpq_class(1797, 2500), mpq_class(377, 400), mpq_class(3, 10), 1, mpq_class(21171, 5000)}};
    CHECK(said_of_state(file) == "certified");  // 4.2342080454
    change.attained[0].value = mpq_class(423421, 100000);
    CHECK(said_of_state(file) == "the value is attained");
}

TEST_CASE("adiabatic: an attained state must satisfy the hypotheses") {
    // Too near to the vertical, at the first contact (exactly) or at a later one.
    CHECK(mutant(bounce(), "attained 1119/5000 1/1", "attained 559/2500 1/1") == "attained");  // 0.2236
    CHECK(mutant(run_file(), "attained 63/125", "attained 499/1000") == "attained");
    CHECK(mutant(run_file(), " 10 93/10\n", " 60 1/1\n") == "attained");
    for (const auto& [u, found] : {std::pair{"1/2", "verified"}, {"499999/1000000", "attained"}})
        CHECK(mutant(run_file(), "attained 63/125 97/100 1/20 10 93/10",
                     "attained " + std::string(u) + " 97/100 1/20 0 0/1") == found);
    // A height that is not asked for.
    CHECK(mutant(bounce(), "heights 3/5 1/1", "heights 3/5 24/25") == "attained");
    CHECK(mutant(run_file(), "heights 3/5 9/10", "heights 3/5 87/100") == "attained");
    // Not the first, not the last, or beyond the last collision.
    Adiabatics other = short_scattering();
    other.terms.claim.attained[0].s = mpq_class(1, 100);
    CHECK(said_of_state(other) == "no collision before the first");
    other = short_scattering();
    other.terms.claim.attained[0].value = 0;
    other.terms.claim.attained[0].collisions = 3;
    CHECK(said_of_state(other) == "no collision after the last");
    other.terms.claim.attained[0].collisions = 5;
    CHECK(said_of_state(other) == "the next collision");
    // The last contact is far nearer to the vertical than the first.
    Adiabatics same = short_scattering();
    CHECK(said_of_state(same) == "certified");
    same.terms.claim.margin = 1;
    CHECK(said_of_state(same) == "u >= margin");
    // A rod that may be level: at the double just below pi/2, and at a number above it, doubles cannot tell.
    const mpq_class quarter_below("884279719003555/562949953421312");
    for (const mpq_class& more : {mpq_class(0), mpq_class(mpq_class(1) / (mpz_class(1) << 53))}) {
        same.terms.claim.attained[0].u = quarter_below + more;
        CHECK(said_of_state(same, 53) == "the rod is not vertical, nor level or beyond");
    }
    // Fields.
    for (const char* state : {"0/1 1/1 1/20", "-1/2 1/1 1/20", "63/125 -1/10 1/20", "63/125 11/10 1/20",
                              "63/125 1/1 1/21", "63/125 1/1 0/1", "63/125 1/1 -1/20"})
        CHECK(mutant(run_file(), "attained 63/125 97/100 1/20", std::string("attained ") + state) ==
              "number");
    CHECK(mutant(run_file(), "attained 63/125", "attained 16/10") == "number");
    CHECK(mutant(run_file(), "attained 63/125", "attained 8/5") == "attained");  // beyond pi/2
    CHECK(mutant(bounce(), "1/20 1 97/50", "1/20 2 97/50") == "number");
}

TEST_CASE("adiabatic: an orbit that meets the heavy mass attains nothing") {
    // At delta = 2/5 and below the height of the bridge the second collision is one of the heavy mass.
    Adiabatics file = small_claim(adiabatic::Claim::run);
    adiabatic::Claim& claim = file.terms.claim;
    claim.delta_lo = claim.delta_hi = mpq_class(2, 5);
    claim.y_lo = 0;
    claim.margin = mpq_class(1, 100);
    for (const int n : {1, 2, 3}) {
        claim.attained = {{mpq_class(29, 20), 1, mpq_class(2, 5), static_cast<std::uint64_t>(n), 0}};
        CHECK(said_of_state(file) == "passes the bridge");
    }
    // Before this contact, low on the wall, comes one of the heavy mass, though the flight would miss the
    // wall.
    claim.kind = adiabatic::Claim::scattering;
    claim.attained = {{mpq_class(31, 20), mpq_class(7, 20), mpq_class(49, 100), 0, 0}};
    CHECK(said_of_state(file) == "passes the bridge");
}

TEST_CASE("adiabatic: of a flight that grazes the wall doubles do not tell whether it collides") {
    Adiabatics file = small_claim(adiabatic::Claim::run);
    adiabatic::Claim& claim = file.terms.claim;
    claim.delta_lo = claim.delta_hi = mpq_class(1, 5);
    claim.y_lo = 0;
    claim.margin = mpq_class(1, 100);
    const mpq_class s("58252928894643/70368744177664");
    claim.attained = {{mpq_class(1, 2), s, mpq_class(1, 5), 1, 0}};
    CHECK(said_of_state(file, 53) == "the next collision");
    CHECK(said_of_state(file) == "certified");
    claim.attained[0].s += mpq_class(1, 1000000);
    CHECK(said_of_state(file) == "certified");
    claim.attained[0].s -= mpq_class(2, 1000000);
    CHECK(said_of_state(file) != "certified");
}

TEST_CASE("adiabatic: a class must hold for all its flights") {
    // Half of every density.
    std::string halved = run_file();
    for (std::size_t at = halved.find("\ncell "); at != std::string::npos;
         at = halved.find("\ncell ", at + 1)) {
        const std::size_t value = halved.find(' ', at + 6) + 1, end = halved.find('\n', value);
        halved.replace(value, end - value, level(mpq_class(halved.substr(value, end - value)) / 2));
    }
    CHECK(outcome(closed(halved.substr(0, halved.find("total split")))) == "bound");
    // A threshold below which the flights are others, or below all.
    CHECK(mutant(run_file(), "class 13/10 40", "class 1/1 40") != "verified");
    CHECK(mutant(run_file(), "class 13/10 40", "class 3/4 40") == "class");
    // Nothing is said of flights nearer to the vertical than the last cell, or than the margin.
    CHECK(mutant(run_file(), "margin 1/2", "margin 2/5") != "verified");
    CHECK(mutant(run_file(), "delta 1/20 1/20", "delta 1/20 1/19") != "verified");
}

TEST_CASE("adiabatic: leaves that are too large, or not outside, are refused") {
    int refused = 0, lines = 0;
    for (const std::string* text : {&bounce(), &run_file()}) {
        std::vector<std::string> all;
        std::istringstream in(*text);
        for (std::string line; std::getline(in, line);) all.push_back(line);
        bool in_claim = text == &bounce();
        for (std::size_t i = 0; i < all.size() && !all[i].starts_with("attained"); ++i) {
            in_claim = in_claim || all[i] == "end";
            if (!all[i].starts_with("split") || i % 7 != 0) continue;
            for (const std::string leaf :
                 {in_claim && text == &run_file() ? "bound 0" : "bound", "outside"}) {
                ++lines;
                refused += outcome(lifted(*text, i, leaf)) == leaf.substr(0, leaf.find(' '));
            }
        }
    }
    CHECK(refused == lines);  // the search halves nothing that need not be
    CHECK(lines >= 20);
    CHECK(mutant(bounce(), "\nbound\n", "\noutside\n") == "outside");
    CHECK(mutant(run_file(), "\nbound\n", "\noutside\n") == "outside");
    CHECK(mutant(run_file(), "\nbound 0\n", "\noutside\n") == "outside");
    CHECK(mutant(scattering(), "\nbound 0\n", "\noutside\n") == "outside");
    CHECK(mutant(run_file(), "\nbound 0\n", "\nbound 1\n") == "number");
    CHECK(mutant(run_file(), "\noutside\n", "\nbound\n") != "verified");
}

TEST_CASE("adiabatic: numbers beyond all bounds are refused without harm") {
    const std::string huge(2000, '9'), tiny = "1/" + huge;
    const auto refused = [](const std::string& text, const std::string& from, const std::string& to) {
        INFO(to.substr(0, 60));
        CHECK(outcome(mutated(text, from, to)) != "verified");
    };
    for (const std::string& value : {huge + "/1", tiny}) {
        refused(run_file(), "attained 63/125", "attained " + value);
        refused(run_file(), "margin 1/2", "margin " + value);
        refused(run_file(), "class 13/10", "class " + value);
        refused(run_file(), "delta 1/20 1/20", "delta 1/20 " + value);
        refused(bounce(), "attained 1119/5000 1/1", "attained 1119/5000 " + value);
    }
    refused(bounce(), "bound 5/2", "bound " + tiny);
    refused(run_file(), "10 93/10", "10 " + huge + "/1");
    refused(run_file(), "10 93/10", "999999999999999999 0/1");
    const std::string cell = run_file().substr(run_file().find("cell "));
    const std::string low = cell.substr(5, cell.find(' ', 5) - 5);
    refused(run_file(), "cell " + low, "cell " + tiny);
    refused(run_file(), cell.substr(0, cell.find('\n')),
            "cell " + low + " " + huge + "/1");  // V is unbounded
    CHECK(outcome(mutated(run_file(), "10 93/10", "10 " + tiny)) == "verified");
    // Beyond double, not beyond MPFR.
    CHECK(outcome(mutated(bounce(), "bound 5/2", "bound " + huge + "/1")) == "verified");
}
