// near_adiabatic make SEED NUMBER: rows of ../../data/near_adiabatic.tsv, leaves of the adiabatic claims that
//     are just certified, and their neighbours that just are not. Every number of a random leaf that is
//     certified is moved both ways by bisection until it no longer is.
// near_adiabatic differ FILE: the number of the first row of which the verifier says something else.
#include <array>
#include <cmath>
#include <functional>
#include <iostream>
#include <map>
#include <random>

#include "near_main.hpp"
#include "rooms/verify/wings/adiabatic/rows.hpp"

namespace {

using namespace adiabatic_rows;
using namespace dumbbell_verify;

std::mt19937_64 engine;

std::uint64_t below(std::uint64_t n) { return engine() % n; }
double uniform(double lo, double hi) { return std::uniform_real_distribution<>(lo, hi)(engine); }
mpq_class rounded(double x) { return mpq_class(std::round(x * 4096) / 4096); }

void print(const Case& c) { std::cout << words(c) << "\t" << judged(c) << "\n"; }

/// Moves this number of the case as far as it is certified, and prints both sides of the edge.
void move(Case& c, mpq_class& x, int sign, const mpq_class& most = 64) {
    const mpq_class start = x;
    const auto is_good = [&](const mpq_class& value) {
        x = value;
        return judged(c) == "certified";
    };
    mpq_class good = start, bad = start;
    for (mpq_class far(1, 64); far <= 64; far *= 8) {
        bad = start + sign * far;
        if (bad < 0) bad = 0;
        if (bad > most) bad = std::max(most, start);
        if (bad == good || !is_good(bad)) break;
        good = bad;
    }
    if (good != bad) {
        for (int i = 0; i < 14; ++i) {
            const mpq_class middle = (good + bad) / 2;
            (is_good(middle) ? good : bad) = middle;
        }
        x = bad;
        print(c);
        x = good;
        print(c);
    }
    x = start;
}

/// What a file may say of u, s, v, delta and sigma.
const std::array<mpq_class, 5> greatest{2, 1, 2, mpq_class(49, 100), 8};

/// Also leaves that are far from certified, some for each reason.
bool is_certified(const Case& c) {
    static std::map<std::string, int> seen;
    const std::string result = judged(c);
    if (result == "certified" || ++seen[std::to_string(c.kind) + result] <= 6) print(c);
    return result == "certified";
}

void around(Case c, std::initializer_list<std::size_t> axes) {
    if (!is_certified(c)) return;
    for (const std::size_t axis : axes) {
        move(c, c.box.lo.at(axis), -1);
        move(c, c.box.hi.at(axis), 1, greatest.at(axis));
    }
    for (mpq_class& bound : c.bounds) move(c, bound, -1);
    if (!c.cells.empty()) move(c, c.J, -1), move(c, c.J, 1);
    for (auto& [u, v] : c.cells) move(c, v, -1), move(c, v, 1);
    move(c, c.margin, 1, 1);
    if (c.outside) move(c, c.margin, -1);
    move(c, c.y_lo, c.outside ? -1 : 1);
    move(c, c.y_hi, c.outside ? 1 : -1);
}

void narrow(Case& c, std::size_t axis, double at, double width) {
    c.box.lo.at(axis) = rounded(at);
    c.box.hi.at(axis) = c.box.lo.at(axis) + (below(3) == 0 ? mpq_class(0) : mpq_class(std::abs(width)));
}
double small() { return std::exp2(-static_cast<double>(below(6)) - 4); }

Case common(adiabatic::Claim::Kind kind) {
    Case c;
    c.kind = kind;
    c.bits = std::array{0U, 0U, 9U, 12U, 16U, 53U}.at(below(6));
    c.exponent = kind == adiabatic::Claim::run      ? 0
                 : kind == adiabatic::Claim::bounce ? static_cast<unsigned>(below(17))
                                                    : 8;
    c.y_lo = rounded(uniform(0, 0.6));
    c.y_hi = rounded(uniform(0.7, 1));
    c.margin = rounded(uniform(0.2, 1));
    narrow(c, adiabatic::axis_delta, std::max(0.01, uniform(0.02, 0.4)), 0.05 * small());
    return c;
}

void cells_of(Case& c, double factor) {
    c.J = rounded(uniform(0.8, 1.6));
    for (const double u : {1.2, 0.9, 0.6, 0.4}) {
        const double w = std::sin(u);
        c.cells.emplace_back(rounded(u), rounded(factor * (8 / (w * w * w * w))));
    }
}

void bounce_leaf() {
    Case c = common(adiabatic::Claim::bounce);
    narrow(c, adiabatic::axis_u, uniform(0.1, 1.5), small());
    narrow(c, adiabatic::axis_s, uniform(0, 0.9), small());
    c.bounds = {4, 64};
    c.outside = below(3) == 0;
    if (c.outside && below(2) == 0) c.y_hi = rounded(uniform(0, 0.6)), c.y_lo = 0;
    around(c, {adiabatic::axis_u, adiabatic::axis_s, adiabatic::axis_delta});
}
void run_leaf(adiabatic::Claim::Kind kind) {
    Case c = common(kind);
    if (kind == adiabatic::Claim::scattering)
        narrow(c, adiabatic::axis_delta, uniform(0.001, 0.05), 0.001 * small());
    narrow(c, adiabatic::axis_u, uniform(0.2, 1.5), small());
    narrow(c, adiabatic::axis_v, uniform(0.2, 1.5), small());
    if (below(3) == 0) {  // where r/w^2 is large
        narrow(c, adiabatic::axis_delta, uniform(0.3, 0.48), 0.001 * small());
        narrow(c, adiabatic::axis_v, uniform(0.1, 0.6), small());
        c.margin = mpq_class(1, 64);
    }
    narrow(c, adiabatic::axis_s, uniform(0, 0.9), small());
    c.bounds = {64};
    cells_of(c, uniform(0.1, 1));
    c.outside = below(3) == 0;
    if (c.outside && below(2) == 0) c.y_hi = rounded(uniform(0, 0.6)), c.y_lo = 0;
    around(c, {adiabatic::axis_u, adiabatic::axis_v, adiabatic::axis_s, adiabatic::axis_delta});
}
void class_leaf() {
    Case c = common(adiabatic::Claim::run);
    c.part = adiabatic::Leaf::class_tree;
    if (c.bits > 12) c.bits = 0;
    narrow(c, adiabatic::axis_u, uniform(0.4, 1.4), small() / 8);
    narrow(c, adiabatic::axis_sigma, uniform(0, 3), small() / 4);
    if (below(3) == 0)  // where the wall at the upper contact is about as steep as the flight
        narrow(c, adiabatic::axis_u,
               c.box.lo.at(adiabatic::axis_sigma).get_d() * c.box.lo.at(adiabatic::axis_delta).get_d(),
               small());
    cells_of(c, uniform(0.5, 4));
    c.outside = below(3) == 0;
    if (c.outside) narrow(c, adiabatic::axis_sigma, uniform(1, 7), small());
    around(c, {adiabatic::axis_u, adiabatic::axis_sigma, adiabatic::axis_delta});
    c.part = adiabatic::Leaf::class_itself;
    move(c, c.J, -1);
}
void state() {
    const auto kind = static_cast<adiabatic::Claim::Kind>(below(3));
    Case c = common(kind);
    c.part = adiabatic::Leaf::attained;
    c.bits = c.bits > 0 && c.bits < 53 ? 26 : c.bits;
    c.box.hi[adiabatic::axis_delta] = c.box.lo[adiabatic::axis_delta];
    c.margin = mpq_class(1, 64);
    c.y_lo = 0;
    c.y_hi = 1;
    c.bounds.assign(kind == adiabatic::Claim::bounce ? 2 : 1, 1);
    c.index = kind == adiabatic::Claim::bounce ? below(2) : 0;
    c.state = {rounded(uniform(0.1, 1.4)), rounded(uniform(0, 1)), c.box.lo[adiabatic::axis_delta], 1, 0};
    const std::uint64_t most = kind == adiabatic::Claim::bounce ? 1 : 6;
    for (c.state.collisions = kind == adiabatic::Claim::bounce ? 1 : below(4); c.state.collisions <= most;
         ++c.state.collisions) {
        if (!is_certified(c)) continue;
        move(c, c.state.value, 1);
        move(c, c.state.u, -1);
        move(c, c.state.u, 1);
        move(c, c.state.s, -1);
        move(c, c.state.s, 1, 1);
        move(c, c.margin, 1);
        move(c, c.y_lo, 1);
        move(c, c.y_hi, -1);
        ++c.state.collisions;
        print(c);
        return;
    }
}

void make(std::uint64_t seed, int number) {
    engine.seed(seed);
    for (int i = 0; i < number; ++i) {
        bounce_leaf();
        run_leaf(adiabatic::Claim::run);
        run_leaf(adiabatic::Claim::scattering);
        state();
        if (i % 2 == 0) class_leaf();
    }
}

}  // namespace

int main(int argc, char** argv) {
    return leaf_rows::near_main(argc, argv, make,
                                [](const std::string& leaf) { return judged(parsed(leaf)); });
}
