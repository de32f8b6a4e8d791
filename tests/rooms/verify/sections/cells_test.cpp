// The section cells of the scene body: true cells are accepted, and of mutants those only that are true.
#include "attacks/oracle/tangents.hpp"
#include "catch.hpp"
#include "rooms/verify/core/make_certificate.hpp"
#include "verify/core/big.hpp"
#include "verify/sections/valley.hpp"

namespace {

using dumbbell_verify::Big;

// The bounds of flights in the valley, at a few bits.
struct CoarseValley : dumbbell_verify::Valley<Big> {
    CoarseValley() : Valley(nullptr) {}
    using Valley::hits_bridge, Valley::I, Valley::outward_from_above, Valley::outward_from_below,
        Valley::over_bridge, Valley::passes_bridge, Valley::Ray;
};

std::string cells_text(const std::string& q, const std::string& rho, const std::string& tree,
                       const std::string& bits = "53") {
    return make::closed(
        "dumbbell-certificate 1\ngenerator test 1.0\nlemmas body\nscene body\nsection "
        "cells\nclaim collisions\nratio " +
            q + "\nrho " + rho + "\nbits " + bits + "\n" + tree,
        {"split", "cell", "beyond", "open"});
}
std::string said_of_cells(const std::string& q, const std::string& rho, const std::string& tree,
                          const std::string& bits = "53",
                          const dumbbell_verify::Request& asked = make::asking("body")) {
    return make::outcome(cells_text(q, rho, tree, bits), asked);
}

struct Base {
    double q_lo, q_hi, rho_lo, rho_hi;
    std::string cell;
};
const Base true_cells[] = {
    {8, 9, 0.5, 0.5625, "cell 5 5 1 21b-6 2"},
    {100, 100.125, 0.296875, 0.3046875, "cell 9 9 0 0b0 4 1 1b-2 2 5b-5 3 7b-7"},
    {10000, 10000.125, 0.28, 0.280001, "cell 73 73 0 0b0 35 1 71b-8 2 35b-7 9 471b-11 23 7b-6 31 1b-5"},
    {4, 4, 1, 1, "cell 4 4 0 0b0 2"},
    {5.44921875, 5.4493, 0.15625, 0.171875, "cell 4 4 0 0b0 1"},
    {120.375, 125.125, 0.3955078125, 0.400390625, "cell 11 11 4 3b-5 6 2 1b-2 4 5b-6 5 0b0"}};

std::string ratios(double lo, double hi) {
    return make::fraction(mpq_class(lo)) + " " + make::fraction(mpq_class(hi));
}
std::string said_of(const Base& base) {
    return said_of_cells(ratios(base.q_lo, base.q_hi), ratios(base.rho_lo, base.rho_hi), base.cell + "\n",
                         "96");
}

// A number of the line one more or less, another place, or another end of a side.
Base mutant_of(Base base, dumbbell_oracle::Sampler& sampler) {
    const double grow = sampler.coin() ? 0 : sampler.log_uniform(1e-4, 1);
    switch (static_cast<int>(sampler.uniform(0, 8))) {
        case 0:
            return base.q_lo /= 1 + grow, base;
        case 1:
            return base.q_hi *= 1 + grow, base;
        case 2:
            return base.rho_lo /= 1 + grow, base;
        case 3:
            return base.rho_hi = std::min(1.0, base.rho_hi * (1 + grow)), base;
        default:
            break;
    }
    std::vector<std::string> words;
    std::istringstream line(base.cell);
    for (std::string word; line >> word;) words.push_back(word);
    std::string& word =
        words[static_cast<std::size_t>(sampler.uniform(1, static_cast<double>(words.size())))];
    if (const auto at = word.find('b'); at != std::string::npos)
        word = sampler.coin() ? "0b0"
                              : std::to_string(2 * std::stol(word) + (sampler.coin() ? 1 : -1)) + "b" +
                                    std::to_string(std::stol(word.substr(at + 1)) - 1);
    else
        word = std::to_string(std::max(0L, std::stol(word) + (sampler.coin() ? 1 : -1)));
    base.cell.clear();
    for (const std::string& each : words) base.cell += (base.cell.empty() ? "" : " ") + each;
    return base;
}

bool is_true(const Base& cell) {
    long upper = 0, lower = 0;
    std::istringstream(cell.cell.substr(5)) >> upper >> lower;
    for (const double q : {cell.q_lo, cell.q_hi})
        for (const double x : {0.0, 0.3, 0.7, 1.0}) {
            const double rho = std::min(cell.rho_hi, cell.rho_lo + x * (cell.rho_hi - cell.rho_lo));
            const auto n = dumbbell_oracle::TheoremB::of<long double>({rho, q}).maximum();
            if (static_cast<long>(n) < lower || static_cast<long>(n) > upper) return false;
        }
    return true;
}

}  // namespace

TEST_CASE("section cells: true cells are accepted, in trees, and what is no cell is not") {
    for (const Base& base : true_cells) CHECK(said_of(base) == "verified");
    const std::string five = "cell 5 5 1 21b-6 2\n";
    CHECK(said_of_cells("8/1 9/1", "1/2 9/16",
                        "split rho\n" + five + "split q\n" + five + "cell 5 5 1 11b-5 2\n") == "verified");
    auto at_most_five = make::asking("body");
    at_most_five.demand.most = 5;
    for (const std::string& tree : {"split rho\nopen\n" + five, "split rho\n" + five + "open\n"})
        CHECK(said_of_cells("8/1 9/1", "1/2 9/16", tree, "53", at_most_five) == "claim-not-proved");
    for (const char* line : {"cell 5 6 1 21b-6 2", "cell 0 0 0 0b0 1"})
        CHECK(said_of_cells("8/1 9/1", "1/2 9/16", std::string(line) + "\n") == "number");
    for (const char* line : {"cell 5 5 1 21b-6", "cell 5 5 1 21b-6 2 1", "cell"})
        CHECK(said_of_cells("8/1 9/1", "1/2 9/16", std::string(line) + "\n") == "syntax");
    CHECK(said_of_cells("8/1 9/1", "1/2 9/16", "outside\n") == "opcode");
    CHECK(said_of_cells("8/1 9/1", "1/2 17/16", five) == "number");
    CHECK(said_of_cells("8/1 9/1", "1/2 9/16", "cell 5 5 1 0b0 2\n") == "cell");
}

TEST_CASE("section cells: the share is a ratio of areas in logs, rounded down, of the part in question") {
    const std::string five = "cell 5 5 1 21b-6 2\n", wide = "cell 5 4 1 11b-5 2\n",
                      three = "cell 3 3 0 0b0 2 1 3b-8\n";
    const auto share = [](const std::string& q, const std::string& rho, const std::string& tree,
                          const dumbbell_verify::Collisions& demand = {}) {
        auto asked = make::asking("body");
        asked.demand = demand;
        return verify(make::File(cells_text(q, rho, tree)).path(), asked).decided.value().get_d();
    };
    const auto is = [](double x) { return Approx(x).epsilon(1e-14); };
    const double half = std::log(1.0625) / std::log(1.125);  // of both sides
    CHECK(share("8/1 9/1", "1/2 9/16", five) == 1);
    CHECK(share("8/1 9/1", "1/2 9/16", "open\n") == 0);
    CHECK(share("8/1 9/1", "1/2 9/16", "split q\n" + five + wide) == is(half));
    CHECK(share("8/1 9/1", "1/2 9/16", "split rho\nsplit q\n" + five + "open\n" + five) ==
          is(half * half + 1 - half));
    const std::string split = "split rho\n" + five + "open\n";
    using dumbbell_verify::Range;
    dumbbell_verify::Collisions part;
    part.ratios = Range(8, mpq_class(17, 2));
    part.rhos = Range(mpq_class(33, 64), mpq_class(35, 64));
    CHECK(share("8/1 9/1", "1/2 9/16", split, part) == is(std::log(34.0 / 33) / std::log(35.0 / 33)));
    part.rhos = Range(mpq_class(17, 32), mpq_class(17, 32));  // the end of both: it is in the upper one
    CHECK(share("8/1 9/1", "1/2 9/16", split, part) == 0);
    CHECK(share("8/1 9/1", "1/2 9/16", "split rho\nopen\n" + five, part) == 1);
    for (const std::string below : {"beyond\n", "open\n", "cell 3 3 0 0b0 1\n"})
        CHECK(share("1/1 3/1", "1/2 1/2", "split q\n" + below + "split q\n" + three + "open\n") ==
              is(std::log(1.25) / std::log(1.5)));
    CHECK(share("3/2 3/1", "1/2 9/16", "split q\n" + three + "split q\n" + three + "open\n") ==
          is(std::log(2.625 / 2.25) / std::log(2)));  // the lower cell is across the edge
}

TEST_CASE("section cells: what is beyond the edge does not count, and is no bound") {
    CHECK(said_of_cells("1/1 2/1", "1/4 1/2", "beyond\n") == "verified");
    CHECK(said_of_cells("1/1 2/1", "1/4 1/2", "beyond 1\n") == "opcode");
    CHECK(said_of_cells("1/1 2/1", "1/4 513/1024", "beyond\n") == "beyond");
    auto asked = make::asking("body");
    asked.demand.most = 100;
    CHECK(said_of_cells("1/1 2/1", "1/4 1/2", "beyond\n", "53", asked) == "claim-not-proved");
}

TEST_CASE("section cells: a mutant that is accepted is true") {
    dumbbell_oracle::Sampler sampler(1, 8702);
    int accepted = 0;
    for (int i = 0; i < scaled(90); ++i) {
        Base cell = true_cells[i % 6];
        for (int times = 1 + i % 3; times > 0; --times) cell = mutant_of(std::move(cell), sampler);
        if (said_of(cell) != "verified") continue;
        ++accepted;
        INFO(cell.q_lo << ' ' << cell.q_hi << ' ' << cell.rho_lo << ' ' << cell.rho_hi << ' ' << cell.cell);
        CHECK(is_true(cell));
    }
    CHECK((accepted > 10 && accepted < scaled(80)));
}

// So coarse that a wrong rounding of any number shows.
TEST_CASE("section cells: the flight Y lies between its bounds, of six bits") {
    using Exact = dumbbell_oracle::Ray<long double>;
    dumbbell_oracle::Sampler sampler(1, 8703);
    int below = 0, above = 0, hits = 0, passes = 0;
    for (int i = 0; i < scaled(5'000); ++i) {
        // Half of the numbers have few bits: nothing but what is rounded later then hides a rounding.
        const auto some = [&](double x) {
            return sampler.coin() ? x : std::max(1.0, std::round(32 * x)) / 32;
        };
        const double rho = some(sampler.uniform(0.1, 1)),
                     p = std::min(some(sampler.uniform(0, rho)), 0.99 * rho),
                     q = sampler.coin() ? sampler.log_uniform(2, 60)
                                        : std::exp2(std::round(sampler.uniform(1, 6)));
        const long j = i % 3 + 1;
        const long double heights[] = {rho, 1}, r = 1 / static_cast<long double>(q), h = heights[j % 2],
                          x = std::asin(p / h), slope = r / (h * std::cos(x));
        std::optional<Exact> flight = Exact{p + slope * x, slope};
        for (long wall = j + 1; wall < 2 * j && flight; ++wall) {
            const auto step = dumbbell_oracle::valley_step(*flight, heights[wall % 2], r);
            flight = step ? step->next : std::nullopt;
        }
        Big::precision = 6;
        const auto number = [](dumbbell_verify::Round d, double value) {
            return bound(d, mpq_class(value), Big(0));
        };
        const auto exact = [](const Big& value) { return mpfr_get_ld(value.get(), MPFR_RNDN); };
        CoarseValley valley;
        const CoarseValley::I height{number(dumbbell_verify::down, rho), number(dumbbell_verify::up, rho)};
        CoarseValley::Ray low{0, 0, 0}, high = low;
        const bool is_below =
                       valley.outward_from_below(j, number(dumbbell_verify::down, p), height,
                                                 bound(dumbbell_verify::down, 1 / mpq_class(q), Big(0)), low),
                   is_above =
                       valley.outward_from_above(j, number(dumbbell_verify::up, p), height,
                                                 bound(dumbbell_verify::up, 1 / mpq_class(q), Big(0)), high);
        INFO(rho << ' ' << q << ' ' << p << ' ' << j);
        if (is_above) CHECK(flight);
        if (!flight) continue;
        const bool is_hit = valley_step(*flight, heights[0], r).has_value();
        const long double far = flight->c + dumbbell_oracle::pi<long double>() * flight->kappa;
        if (is_below) {
            CHECK((exact(low.c) <= flight->c && exact(low.kappa) <= flight->kappa));
            CHECK(exact(valley.over_bridge(dumbbell_verify::down, low).c) <= far);
            const bool over = valley.passes_bridge(low, height);
            CHECK_FALSE((over && is_hit));
            ++below, passes += over;
        }
        if (is_above) {
            CHECK((exact(high.c) >= flight->c && exact(high.kappa) >= flight->kappa));
            CHECK(exact(valley.over_bridge(dumbbell_verify::up, high).c) >= far);
            const bool under = valley.hits_bridge(high, height);
            CHECK_FALSE((under && !is_hit));
            ++above, hits += under;
        }
    }
    CHECK((below > 2'000 && above > 2'000 && hits > 500 && passes > 500));
}
