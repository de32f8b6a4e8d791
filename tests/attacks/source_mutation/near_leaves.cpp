// near_leaves make SEED NUMBER: leaves that are just certified, and their neighbours that just are not.
// near_leaves differ FILE:      the number of the first row of which the verifier says something else.
//
// Random small leaves of all charts and opcodes; of each that is certified, every side of the box (and of the
// window of a first contact) is moved outwards by bisection until the leaf is no longer certified. In double
// and in MPFR, also with so few bits that a bound rounded to the wrong side is off by a percent.
#include <cmath>
#include <iostream>
#include <random>

#include "collisions/perpendicular.hpp"
#include "near_main.hpp"

namespace starts = dumbbell_verify::starts;

namespace {

using namespace leaf_rows;
using dumbbell::Rational;

class Maker {
  public:
    explicit Maker(std::uint64_t seed) : random_(seed) {}

    void make(int number) {
        const auto sections = dumbbell_verify::sections();
        for (int i = 0; i < number; ++i) {
            bits_ = std::array{0U, 0U, 8U, 11U, 16U, 53U}[below(6)];
            if (i % 3 == 2) {
                const AnyLeaf leaf = initial();
                around(leaf);
                if (i % 6 == 2) around(Start{std::get<starts::Leaf>(leaf).box});
                continue;
            }
            around(below(8) == 0 ? cell() : of(*sections[below(i % 2 == 0 ? 3 : 5)]));
        }
    }

  private:
    std::uint64_t below(std::uint64_t n) { return random_() % n; }
    double uniform(double lo, double hi) { return std::uniform_real_distribution<>(lo, hi)(random_); }
    /// A number of few digits: sometimes so few that inequalities become equalities.
    mpq_class rounded(double x) {
        const double digits = std::exp2(below(3) == 0 ? 2 : 12);
        return mpq_class(std::round(x * digits) / digits);
    }
    mpq_class width() {
        return below(2) == 0 ? mpq_class(0) : mpq_class(std::exp2(-static_cast<int>(below(10)) - 1));
    }
    mpq_class ratio() {
        const double q = below(4) == 0 ? uniform(1, 3) : std::exp2(uniform(0, 6));
        return std::max(mpq_class(1), rounded(q));
    }

    AnyLeaf of(const Section& section) {
        SectionLeaf result{&section, {}};
        Leaf& leaf = result.leaf;
        set_bits(leaf, bits_);
        do {
            leaf.opcode = below(section.opcodes.size());
            leaf.chart = below(section.charts.size());
        } while ((section.opcodes[leaf.opcode].charts >> leaf.chart & 1) == 0);
        const mpq_class q = ratio();
        const double size = std::min(3.0, q.get_d());
        leaf.box.lo = {rounded(uniform(0, leaf.chart == 0 && section.charts.size() == 3 ? 3.3 : 1.7)),
                       rounded(uniform(0, size)), q};
        const bool point = section.opcodes[leaf.opcode].place == dumbbell_verify::Place::witness;
        leaf.box.hi = leaf.box.lo;
        for (std::size_t i = point ? 2 : 0; i < 3; ++i) leaf.box.hi[i] += width() * (i == 2 ? 4 : 1);
        if (section.charts[leaf.chart].axes[0].empty()) leaf.box.lo[0] = leaf.box.hi[0] = 0;
        leaf.claimed = 2;
        // The best hints.
        const auto certified = [&] { return judged(result) == "certified"; };
        constexpr std::uint64_t most = 9;
        if (point) {
            for (leaf.a = 0; leaf.a < most; ++leaf.a)
                if (leaf.claimed = 1 + leaf.a; !certified()) break;
            if (leaf.a == 0) return result;
            --leaf.a;
            for (leaf.b = 1; leaf.b < most; ++leaf.b)
                if (leaf.claimed = 1 + leaf.a + leaf.b; !certified()) break;
            --leaf.b;
            leaf.claimed = 1 + leaf.a + leaf.b;
        } else if (section.opcodes[leaf.opcode].hints > 0) {
            const bool two = section.opcodes[leaf.opcode].hints == 2 && section.name == "turning";
            leaf.a = leaf.b = most;
            leaf.claimed = 40;
            if (!certified()) return result;
            while (leaf.a > 0 && (--leaf.a, !certified()) == false) {
            }
            if (!certified()) ++leaf.a;
            leaf.b = two ? leaf.b : 0;
            while (two && leaf.b > 0 && (--leaf.b, !certified()) == false) {
            }
            if (!certified()) ++leaf.b;
            leaf.claimed = 1 + leaf.a + leaf.b;
        }
        return result;
    }

    /// Of a rectangle or a single body, by the prover's orbits; few bits need a bound with some room.
    AnyLeaf cell() {
        const double rho = std::exp(uniform(-3, 0)), q = std::exp2(uniform(-1, 7)),
                     grow = below(3) == 0 ? 0.02 : 0;
        Cell cell;
        set_bits(cell, below(2) == 0 ? bits_ : 5 + static_cast<unsigned>(below(4)));
        cell.box.lo = {0, 0, std::max(mpq_class(1, 2), rounded(q)), std::max(mpq_class(1, 16), rounded(rho))};
        cell.box.hi = {0, 0, cell.box.lo[2] * mpq_class(1 + grow), cell.box.lo[3] * mpq_class(1 + grow)};
        if (below(6) == 0 || cell.box.hi[3] > 1) cell.box.lo[3] = cell.box.hi[3] = 1;
        const auto side = [&](std::size_t i) -> dumbbell::collisions::Range {
            return {Rational(cell.box.lo[i].get_mpq_t()), Rational(cell.box.hi[i].get_mpq_t())};
        };
        const dumbbell::collisions::Rectangle bodies{side(3), side(2)};
        const auto least = dumbbell::collisions::least_collisions(bodies);
        const long room = static_cast<long>(below(3));
        cell.lower = std::max(0L, least.bound - room);
        cell.j = least.j;
        cell.p = mpq_class(least.p.raw());
        for (long most = least.bound + room; cell.end == 0; ++most) {
            if (const auto found = dumbbell::collisions::at_most(most, bodies)) {
                cell.upper = most;
                cell.end = found->end;
                for (const auto& [x, p] : found->orbits) cell.orbits.emplace_back(x, mpq_class(p.raw()));
            }
        }
        return cell;
    }

    AnyLeaf initial() {
        starts::Leaf leaf;
        set_bits(leaf, bits_);
        const double q = ratio().get_d(), r = 1 / q;
        const double phi = uniform(-4, 7), w = below(4) == 0 ? 0 : uniform(-2, 2), y = uniform(1, 2),
                     v = below(3) == 0 ? uniform(-0.2, 0.5) : uniform(-2, 0);
        leaf.box.lo = {rounded(phi), rounded(w), rounded(y), rounded(v), std::max(mpq_class(1), rounded(q))};
        leaf.box.hi = leaf.box.lo;
        const auto thin = below(3) == 0;
        for (std::size_t i = 0; i < 5 && !thin; ++i)
            if (below(2) == 0) leaf.box.hi[i] += width() / 8;
        std::array<double, 5> at{};
        for (std::size_t i = 0; i < 5; ++i) at[i] = mpq_class((leaf.box.lo[i] + leaf.box.hi[i]) / 2).get_d();
        const auto clearance = [&](bool heavy, double t) {
            const double sine = std::sin(at[0] + at[1] * t);
            return at[2] * (1 + r) + at[3] * (1 + r) * t + (heavy ? -r * sine : sine);
        };
        const auto certified = [&] { return judged(leaf) == "certified"; };
        for (double t = 0; t < 60; t += 1.0 / 64)
            for (const bool heavy : {false, true})
                if (!leaf.first && clearance(heavy, t) < 0) {
                    const double pad = std::exp2(-static_cast<int>(below(8)) - 4);
                    const mpq_class from = rounded(t - 1.0 / 64 - pad), until = rounded(t + pad);
                    if (from <= 0 || until <= from) return leaf;
                    leaf.first = starts::FirstContact{heavy, from, until};
                }
        const bool window = below(6) != 0;
        if (!window) leaf.first.reset();
        leaf.most = 11;
        leaf.least = leaf.first ? 1 : 0;
        if (!leaf.first && certified()) {
            while (leaf.most > 0 && certified()) --leaf.most;
            if (!certified()) ++leaf.most;
            if (certified() && leaf.least < leaf.most && ++leaf.least, !certified()) --leaf.least;
            return leaf;
        }
        if (!certified()) return leaf;
        while (leaf.most > leaf.least && certified()) --leaf.most;
        if (!certified()) ++leaf.most;
        while (leaf.least < leaf.most && certified()) ++leaf.least;
        if (!certified()) --leaf.least;
        return leaf;
    }

    void print(const AnyLeaf& leaf) { std::cout << words(leaf) << "\t" << judged(leaf) << "\n"; }

    /// The leaf and its neighbours.
    void around(AnyLeaf any) {
        print(any);
        if (judged(any) != "certified") return;
        if (auto* one = std::get_if<SectionLeaf>(&any)) {
            Leaf& leaf = one->leaf;
            const bool point = one->section->opcodes[leaf.opcode].place == dumbbell_verify::Place::witness;
            for (std::size_t i = one->section->charts[leaf.chart].axes[0].empty() ? 1 : 0; i < 3; ++i)
                if (i == 2 || !point) {
                    move(any, {&leaf.box.lo[i]}, -1);
                    move(any, {&leaf.box.hi[i]}, 1);
                } else {
                    move(any, {&leaf.box.lo[i], &leaf.box.hi[i]}, -1);
                    move(any, {&leaf.box.lo[i], &leaf.box.hi[i]}, 1);
                }
            for (mpz_class* hint : {&leaf.a, &leaf.b, &leaf.claimed})
                for (const int step : {-1, 1}) {
                    if (*hint == 0 && step < 0) continue;
                    *hint += step;
                    print(any);
                    *hint -= step;
                }
            return;
        }
        if (auto* cell = std::get_if<Cell>(&any)) {
            for (const std::size_t i : {2, 3}) {
                move(any, {&cell->box.lo[i]}, -1);
                move(any, {&cell->box.hi[i]}, 1);
            }
            for (const int sign : {-1, 1}) {
                move(any, {&cell->p}, sign);
                std::vector<mpz_class*> counts{&cell->upper, &cell->lower, &cell->j, &cell->end};
                for (auto& [x, p] : cell->orbits) {
                    move(any, {&p}, sign);
                    counts.push_back(&x);
                }
                for (mpz_class* count : counts) {
                    if (*count + sign < 0) continue;
                    *count += sign;
                    print(any);
                    *count -= sign;
                }
            }
            return;
        }
        auto* start = std::get_if<Start>(&any);
        auto& box = start ? start->box : std::get<starts::Leaf>(any).box;
        for (std::size_t i = 0; i < 5; ++i) {
            move(any, {&box.lo[i]}, -1);
            move(any, {&box.hi[i]}, 1);
        }
        if (start) return;
        auto& leaf = std::get<starts::Leaf>(any);
        if (leaf.first) {
            move(any, {&leaf.first->from}, -1);
            move(any, {&leaf.first->from}, 1);
            move(any, {&leaf.first->until}, -1);
            move(any, {&leaf.first->until}, 1);
        }
        if (leaf.least < leaf.most) ++leaf.least, print(any), --leaf.least;
        if (leaf.least < leaf.most) --leaf.most, print(any), ++leaf.most;
        if (leaf.least > 1) --leaf.least, print(any), ++leaf.least;
    }
    /// Moves these coordinates, which are equal, as far as the leaf is certified.
    void move(AnyLeaf& any, const std::vector<mpq_class*>& coordinates, int sign) {
        const mpq_class start = *coordinates[0];
        const auto set = [&](const mpq_class& x) {
            for (mpq_class* c : coordinates) *c = x;
        };
        const auto is_good = [&](const mpq_class& x) {
            set(x);
            return judged(any) == "certified";
        };
        const bool is_ratio = is_ratio_side(any, coordinates[0]);
        mpq_class good = start, bad = start;
        for (mpq_class far(1, 4); far <= 4; far *= 4) {
            bad = start + sign * far;
            if (sign < 0 && is_ratio && bad < 1) bad = 1;
            if (sign < 0 && !is_signed(any, coordinates[0]) && bad < 0) bad = 0;
            if (bad == good || !is_good(bad)) break;
            good = bad;
        }
        if (good != bad) {
            for (int i = 0; i < 16; ++i) {
                const mpq_class middle = (good + bad) / 2;
                (is_good(middle) ? good : bad) = middle;
            }
            set(bad);
            print(any);
        }
        if (good != start) {
            set(good);
            print(any);
        }
        set(start);
    }
    static bool is_ratio_side(const AnyLeaf& any, const mpq_class* c) {
        if (const auto* one = std::get_if<SectionLeaf>(&any))
            return c == &one->leaf.box.lo[2] || c == &one->leaf.box.hi[2];
        if (const auto* cell = std::get_if<Cell>(&any)) return c == &cell->box.lo[2];
        const auto* start = std::get_if<Start>(&any);
        const auto& box = start ? start->box : std::get<starts::Leaf>(any).box;
        return c == &box.lo[4] || c == &box.hi[4];
    }
    static bool is_signed(const AnyLeaf& any, const mpq_class* c) {
        const auto* leaf = std::get_if<starts::Leaf>(&any);
        if (std::holds_alternative<Start>(any)) return true;
        return leaf && !(leaf->first && (c == &leaf->first->from || c == &leaf->first->until));
    }

    std::mt19937_64 random_;
    unsigned bits_ = 0;
};

}  // namespace

int main(int argc, char** argv) {
    return leaf_rows::near_main(
        argc, argv, [](std::uint64_t seed, int number) { Maker(seed).make(number); },
        [](const std::string& leaf) { return judged(parsed(leaf)); });
}
