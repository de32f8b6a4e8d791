// Well-formed files about initial conditions with wrong claims: a box of starts around a random one, halved,
// with leaves at, above and below what the simulated trajectories (tests/attacks/oracle) do. What the
// verifier accepts, all of the file or the leaves before the line that it rejects, must hold for the
// simulated trajectories of the leaf's starts.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "certificates.hpp"
#include "scratch.hpp"
#include "start_truth.hpp"
#include "starts/answer/writer.hpp"
#include "target.hpp"
#include "verify/program/verify.hpp"
#include "verify/wings/starts/claim.hpp"

namespace {

using namespace dumbbell_fuzz;
using namespace dumbbell;
using namespace dumbbell::starts;
using dumbbell_oracle::Mass;
constexpr std::size_t header_lines = 13;

/// A multiple of 2^-8.
Rational any_number(Choices& choices, long lo, long hi) {
    return Rational(choices.between(256 * lo, 256 * hi), 256);
}

/// A start in the air around which the box lies: phi, phidot, y, ydot, q.
starts::Box any_box(Choices& choices) {
    constexpr long ratios[] = {1, 2, 3, 10, 47, 100, 1000};
    starts::Box box;
    box.lo = {any_number(choices, -7, 7), any_number(choices, -2, 2), any_number(choices, 0, 3),
              any_number(choices, -2, 2),
              ratios[choices.below(std::size(ratios))] + any_number(choices, 0, 1)};
    box.hi = box.lo;
    const std::size_t exact_axes = choices.below(32);
    for (std::size_t i = 0; i < starts::axis_count; ++i) {
        if ((exact_axes >> i & 1) != 0) continue;
        const Rational width = power_of_two(-choices.between(0, 40));
        box.lo.at(i) -= width * Rational(choices.between(0, 3), 3);
        box.hi.at(i) += width;
    }
    box.lo[4] = std::max(Rational(1), box.lo[4]);
    return box;
}

/// The start at the given fractions of the box's sides.
Start start_at(const starts::Box& box, const Start& at) {
    Start start{};
    for (std::size_t i = 0; i < starts::axis_count; ++i) {
        const auto lo = box.lo.at(i).convert_to<Real>(), hi = box.hi.at(i).convert_to<Real>();
        start.at(i) = lo + at.at(i) * (hi - lo);
    }
    return start;
}

/// m 2^-40 near x > 0, not below the least such number.
Rational dyadic(Real x) {
    const Real scaled = std::clamp(std::round(std::ldexp(x, 40)), 1.0L, 0x1p62L);
    return Rational(static_cast<std::int64_t>(scaled)) * power_of_two(-40);
}

starts::Leaf any_leaf_of(Choices& choices, const starts::Box& box) {
    starts::Leaf leaf;
    const auto run = simulated(start_at(box, {0.5, 0.5, 0.5, 0.5, 0.5}));
    const std::size_t kind = choices.below(8);
    if (kind == 7) return leaf;  // open
    const long seen = run ? static_cast<long>(run->collisions.size()) : choices.between(0, 5);
    leaf.least = std::max(0L, seen + choices.between(-1, 2));
    leaf.most = leaf.least + (kind < 5 ? 0 : choices.between(1, 4));
    const bool must_have = leaf.most == leaf.least ? leaf.least > 0 : leaf.least > 0 && choices.coin();
    if (!must_have) return leaf;
    const bool known = run && !run->collisions.empty();
    const Real time = known ? run->collisions[0].time : 1.0L;
    const Real width = std::ldexp(1.0L, -static_cast<int>(choices.below(30)));
    leaf.first = FirstContact{(known && run->collisions[0].mass == Mass::heavy) != (choices.below(16) == 15),
                              dyadic(time - width), dyadic(time + width) + power_of_two(-41)};
    return leaf;
}

struct PlacedLeaf {
    starts::Box box;
    starts::Leaf leaf;
};

/// Any tree, and its leaves with their boxes.
void grow(Choices& choices, const starts::Box& box, std::size_t splits, std::vector<starts::Node>& tree,
          std::vector<std::optional<PlacedLeaf>>& lines) {
    std::size_t here = splits == 0 ? 0 : choices.below(splits + 1);
    const std::size_t axis = here == 0 ? 0 : choices.below(starts::axis_count);
    if (box.lo.at(axis) == box.hi.at(axis)) here = 0;
    if (here == 0) {
        tree.push_back({std::nullopt, any_leaf_of(choices, box)});
        lines.push_back(PlacedLeaf{box, tree.back().leaf});
        return;
    }
    tree.push_back({static_cast<starts::Axis>(axis), {}});
    lines.emplace_back();
    starts::Box lower = box, upper = box;
    lower.hi.at(axis) = upper.lo.at(axis) = (box.lo.at(axis) + box.hi.at(axis)) / 2;
    const std::size_t below = choices.below(here);
    grow(choices, lower, below, tree, lines);
    grow(choices, upper, here - 1 - below, tree, lines);
}

void check_leaf(const PlacedLeaf& placed, Choices& choices) {
    constexpr int samples = 3;
    for (int i = 0; i < samples; ++i) {
        Start at{};
        for (Real& x : at) x = choices.sample();
        const Start start = start_at(placed.box, at);
        const auto run = simulated(start);
        if (!run) continue;
        const auto& leaf = placed.leaf;
        must_be_between(*run, static_cast<std::uint64_t>(leaf.least), leaf.most, start);
        if (!leaf.first) continue;
        const auto& first = run->collisions.at(0);
        const Real tolerance = 1e-9L * (1 + first.time);
        must(leaf.first->heavy == (first.mass == Mass::heavy), "the mass of the first contact");
        must(leaf.first->from.convert_to<Real>() <= first.time + tolerance &&
                 first.time - tolerance <= leaf.first->until.convert_to<Real>(),
             "the time of the first contact");
    }
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static MemoryFile file;
    Choices choices(data, size);
    starts::Certificate claim{.generator = {"fuzz", "1"}, .box = any_box(choices), .tree = {}};
    claim.bits = choices.below(16) == 15 ? 80 : 53;
    std::vector<std::optional<PlacedLeaf>> lines;
    grow(choices, claim.box, choices.below(8), claim.tree, lines);

    dumbbell_verify::Request settings;
    settings.max_bits = 128;
    std::uint64_t end = std::numeric_limits<std::uint64_t>::max();
    try {
        const auto proof = dumbbell_verify::verify(file.holding(render(claim).text), settings);
        must(dynamic_cast<const dumbbell_verify::starts::Claim*>(proof.other.get()) != nullptr,
             "a claim about initial conditions");
    } catch (const dumbbell_verify::Failure& failure) {
        must(failure.verdict == dumbbell_verify::Verdict::rejected ||
                 failure.verdict == dumbbell_verify::Verdict::limit,
             "a well-formed file is verified, rejected or too much");
        end = failure.line;
    }
    for (std::size_t i = 0; i < lines.size() && header_lines + 1 + i < end; ++i)
        if (lines[i]) check_leaf(*lines[i], choices);
    return 0;
}
