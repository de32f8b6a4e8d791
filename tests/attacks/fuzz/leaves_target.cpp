// Single leaves and witnesses, made to be wrong: boxes around random states and around extremal ones, of any
// size, in any chart, with counts at, above and below what the trajectory through their middle does. What the
// verifier's check accepts must hold for the simulated trajectories of the box's states.
#include <algorithm>
#include <cmath>

#include "certificates.hpp"
#include "collisions/chart.hpp"
#include "collisions/names.hpp"
#include "leaf_truth.hpp"
#include "target.hpp"
#include "truth.hpp"
#include "verify/core/section.hpp"

namespace {

using namespace dumbbell_fuzz;
using dumbbell::collisions::Chart, dumbbell::collisions::Reason;

/// A chart with the section of the verifier that has it.
struct Place {
    Chart chart;
    const dumbbell_verify::Section* section;
    std::size_t number;  ///< of the chart in the section
};

Place any_place(Choices& choices) {
    using namespace dumbbell_verify;
    const Place places[] = {{Chart::bridge, &turning(), 0},       {Chart::light, &turning(), 1},
                            {Chart::contact, &full(), 0},         {Chart::departure, &full(), 1},
                            {Chart::again, &full(), 2},           {Chart::plain_contact, &plain(), 0},
                            {Chart::plain_departure, &plain(), 1}};
    return places[choices.below(std::size(places))];
}

mpq_class rational(const dumbbell::Rational& x) { return mpq_class(x.raw()); }

/// In [0, top]: anywhere, or close to 0, to the top, to pi/2 or to pi.
mpq_class any_coordinate(Choices& choices, const mpq_class& top) {
    const mpq_class small = abs(rational(small_number(choices, 60)));
    const mpq_class fraction(static_cast<unsigned long>(choices.below(65536)), 65536UL);
    mpq_class result;
    switch (choices.below(6)) {
        case 0:
        case 1:
            result = top * fraction;
            break;
        case 2:
            result = small;
            break;
        case 3:
            result = top - small;
            break;
        case 4:
            result = mpq_class(0x1.921fb54442d18p0) - small;
            break;
        default:
            result = mpq_class(0x1.921fb54442d18p1) - small;
    }
    result.canonicalize();
    return std::clamp(result, mpq_class(0), top);
}

mpq_class any_ratio(Choices& choices) {
    mpq_class q = choices.coin() ? critical_ratio(3 + choices.below(40))
                                 : mpq_class(static_cast<unsigned long>(256 + choices.below(65000)), 256UL);
    q.canonicalize();
    q += q * rational(small_number(choices, 100));
    return std::clamp(q, mpq_class(1), mpq_class(2000));
}

/// A width that a box may have around x without leaving [lo, hi].
void widen(mpq_class& x_lo, mpq_class& x_hi, Choices& choices, const mpq_class& lo, const mpq_class& hi) {
    const mpq_class width = abs(rational(small_number(choices, 60)));
    if (choices.coin()) x_lo = std::max(lo, mpq_class(x_lo - width));
    if (choices.coin()) x_hi = std::min(hi, mpq_class(x_hi + width));
}

Real real(const mpq_class& x) { return x.get_d(); }

/// A state of the box, at the given fractions of its sides.
ChartState state_of(const dumbbell_verify::Box& box, const std::array<double, 3>& at) {
    const auto side = [&](std::size_t i) {
        return real(box.lo.at(i)) + at.at(i) * (real(box.hi.at(i)) - real(box.lo.at(i)));
    };
    return {side(0), side(1), side(2)};
}

/// The line of the section's table that stands in this place for this word; nothing if there is none.
std::optional<std::size_t> opcode_of(const Place& place, std::string_view word) {
    const auto& table = place.section->opcodes;
    const auto opcode = std::find_if(table.begin(), table.end(), [&](const dumbbell_verify::Opcode& o) {
        return o.name == word && (o.charts >> place.number & 1) != 0;
    });
    return opcode == table.end() ? std::nullopt : std::optional<std::size_t>(opcode - table.begin());
}

bool is_accepted(const Place& place, std::string_view word, dumbbell_verify::Leaf leaf, long a, long b,
                 Choices& choices) {
    const auto opcode = opcode_of(place, word);
    if (!opcode) return false;
    leaf.opcode = *opcode;
    leaf.a = static_cast<std::uint64_t>(a);
    leaf.b = static_cast<std::uint64_t>(b);
    leaf.claimed = 1 + leaf.a + leaf.b;
    constexpr unsigned precisions[] = {53, 53, 64, 128};
    leaf.bits = precisions[choices.below(4)];
    leaf.multiple = leaf.bits > 53 && choices.coin();
    return place.section->check(leaf, nullptr) == nullptr;
}

/// What the middle of the box does, and a little more or less.
long about_as_many(const Place& place, const dumbbell_verify::Box& box, Choices& choices) {
    const auto seen = simulated(place.chart, state_of(box, {0.5, 0.5, 0.5}));
    return std::max(0L, (seen ? seen->collisions : 0) + choices.between(-2, 2));
}

constexpr std::array reasons{Reason::count, Reason::count,          Reason::count, Reason::outside,
                             Reason::meets, Reason::meets_reversed, Reason::once};

void try_leaf(const Place& place, const dumbbell_verify::Leaf& leaf, Choices& choices) {
    dumbbell::collisions::Leaf said{.reason = reasons[choices.below(std::size(reasons))]};
    if (said.reason == Reason::count) {
        const bool both_ways = row_of(place.chart).counts_both_ways;
        const long total = std::max(0L, about_as_many(place, leaf.box, choices) - (both_ways ? 1 : 0));
        said.forward = both_ways ? choices.between(0, total) : total;
        said.backward = dumbbell::Count(total) - said.forward;
    }
    if (!is_accepted(place, name(said.reason), leaf, as_long(said.forward), as_long(said.backward), choices))
        return;
    constexpr int samples = 5;
    for (int i = 0; i < samples; ++i)
        must_hold(place.chart, said,
                  state_of(leaf.box, {choices.sample(), choices.sample(), choices.sample()}));
}

void try_witness(const Place& place, dumbbell_verify::Leaf leaf, Choices& choices) {
    for (std::size_t i = 0; i < 2; ++i) leaf.box.hi.at(i) = leaf.box.lo.at(i);
    dumbbell::collisions::Witness said{dumbbell::Rational(leaf.box.lo[0].get_mpq_t()),
                                       dumbbell::Rational(leaf.box.lo[1].get_mpq_t())};
    const long total = std::max(1L, about_as_many(place, leaf.box, choices));
    said.forward = choices.between(0, total - 1);
    said.backward = dumbbell::Count(total - 1) - said.forward;
    if (!is_accepted(place, "witness", leaf, as_long(said.forward), as_long(said.backward), choices)) return;
    for (const mpq_class& q : {leaf.box.lo[2], leaf.box.hi[2]}) must_hold(said, real(q));
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    Choices choices(data, size);
    const Place place = any_place(choices);
    const mpq_class q = any_ratio(choices);
    const dumbbell_verify::Box root = place.section->root(place.number, q, q);
    dumbbell_verify::Leaf leaf;
    leaf.chart = place.number;
    for (std::size_t i = 0; i < 2; ++i) {
        leaf.box.lo.at(i) = leaf.box.hi.at(i) = any_coordinate(choices, root.hi.at(i));
        widen(leaf.box.lo.at(i), leaf.box.hi.at(i), choices, root.lo.at(i), root.hi.at(i));
    }
    leaf.box.lo[2] = leaf.box.hi[2] = q;
    widen(leaf.box.lo[2], leaf.box.hi[2], choices, 1, 2000);
    if (place.chart == Chart::bridge && choices.below(4) == 3) {
        try_witness(place, leaf, choices);
    } else {
        try_leaf(place, leaf, choices);
    }
    return 0;
}
