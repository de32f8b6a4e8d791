#include "bases.hpp"

#include <span>

#include "base/error.hpp"
#include "collisions/certify.hpp"
#include "collisions/leaf.hpp"
#include "collisions/piece.hpp"
#include "collisions/writer.hpp"
#include "starts/answer/writer.hpp"
#include "starts/cover/incoming.hpp"
#include "starts/cover/subdivide.hpp"

namespace dumbbell_mutation {
namespace {

using namespace dumbbell;
using namespace dumbbell::collisions;

Base base(const std::string& name, Certificate data, std::size_t cost = 1) {
    std::string text = render(data).text;
    return {name, std::move(data), std::move(text), cost};
}
Base base(const std::string& name, starts::Certificate data) {
    std::string text = render(data).text;
    return {name, std::move(data), std::move(text), 1};
}

Certificate certificate(std::vector<Piece> pieces, const System& system = {}) {
    return {{"mutation", "1.0"}, std::move(pieces), system};
}

/// What `dumbbell certify` writes.
Certificate certified(const std::string& lo, const std::string& hi, const std::string& gap = "1e-3",
                      Section section = Section::turning) {
    const CertifyRequest request{.claim = {.range = {parse_rational(lo), parse_rational(hi)},
                                           .system = {section},
                                           .gap = parse_rational(gap)}};
    std::vector<Piece> pieces;
    for (const ProvedPiece& piece : certify(request)) pieces.push_back(piece.piece);
    return certificate(std::move(pieces), {section});
}

/// Of bodies, by plain covers or by orbits.
Certificate bodies(Section section, const std::string& rho, const std::string& q_lo, const std::string& q_hi,
                   long upper, long lower) {
    const System system{section, parse_rational(rho)};
    return certificate(
        {prove_piece(parse_rational(q_lo), parse_rational(q_hi), upper, lower, {.system = system}).piece},
        system);
}

Piece proved(const std::string& lo, const std::string& hi, long upper, long lower,
             Section section = Section::turning) {
    PieceOptions options;
    options.system.section = section;
    return prove_piece(parse_rational(lo), parse_rational(hi), upper, lower, options).piece;
}
/// Nothing is said of it.
Piece left_open(const std::string& lo, const std::string& hi) {
    Piece piece;
    piece.q_lo = parse_rational(lo);
    piece.q_hi = parse_rational(hi);
    return piece;
}

/// States whose surroundings are split further, so that all opcodes occur: near the first of the chart light
/// `meets`, near the second `meets-reversed`.
bool near_meeting(const Box& box) {
    const Rational e = box[Axis::position].lo, least = box[Axis::slope].lo, greatest = box[Axis::slope].hi,
                   q = box[Axis::ratio].lo;
    const Rational reversed = 2 * q / (q - 1);
    return e == 0 && (least == 0 || (least <= reversed && reversed <= greatest));
}
/// More splits than are needed, in turn of all axes: `depth` everywhere, twelve more near meetings.
void grow(Chart chart, const Box& box, const Count& upper, int depth, int done, Tree& tree) {
    const auto leaf = judge<Interval>(chart, box, upper);
    if (leaf && done >= depth + (chart == Chart::light && near_meeting(box) ? 12 : 0)) {
        tree.push_back({std::nullopt, *leaf});
        return;
    }
    require(done < depth + 20, "a deep tree does not close");
    const bool ratio =
        Rational(box[Axis::ratio].lo) < Rational(box[Axis::ratio].hi) && done % 3 == 2 && done < depth;
    const Axis axis = ratio ? Axis::ratio : done % 2 == 0 ? Axis::position : Axis::slope;
    const auto [low, high] = halves(box, axis);
    tree.push_back({axis, {}});
    grow(chart, low, upper, depth, done + 1, tree);
    grow(chart, high, upper, depth, done + 1, tree);
}
Certificate deep(Certificate certificate, int depth) {
    for (Piece& piece : certificate.pieces)
        for (auto& [chart, tree] : piece.cover.charts) {
            tree.clear();
            grow(chart, root_box(chart, piece.q_lo, piece.q_hi), *piece.upper, depth, 0, tree);
        }
    return certificate;
}

starts::Box box(std::array<std::array<const char*, 2>, starts::axis_count> sides) {
    const auto rational = [](const std::string& text) {
        return text[0] == '-' ? Rational(-parse_rational(text.substr(1))) : parse_rational(text);
    };
    starts::Box result;
    for (std::size_t i = 0; i < starts::axis_count; ++i) {
        result.lo[i] = rational(sides[i][0]);
        result.hi[i] = rational(sides[i][1]);
    }
    return result;
}
starts::Certificate subdivided(const starts::Box& box, std::size_t boxes, int bits = 53) {
    const starts::Subdivision parts = subdivide(box, {.max_boxes = boxes, .bits = bits});
    return {{"mutation", "1.0"}, box, parts.bits, parts.tree.nodes()};
}
starts::Certificate all_incoming(const Rational& q, std::size_t boxes) {
    const starts::Subdivision parts =
        subdivide(starts::incoming_box(q), {.max_boxes = boxes, .incoming = true});
    return {{"mutation", "1.0"}, starts::incoming_box(q), parts.bits, parts.tree.nodes(), true};
}
starts::Certificate with_open_leaf(starts::Certificate certificate) {
    for (starts::Node& node : certificate.tree)
        if (!node.split && node.leaf.least != node.leaf.most) {
            node.leaf = {};
            break;
        }
    return certificate;
}

}  // namespace

std::vector<Base> bases(bool large) {
    std::vector<Base> all = {
        base("equal", certified("1", "1")),
        base("single", certified("10", "10")),
        base("thousand", certified("1000", "1000")),
        base("single-split", certified("11.3622592", "11.3622592")),
        base("deep", deep(certified("10", "10"), 2)),
        base("range", certified("4", "5")),
        base("range-from-1", certified("1", "1.2")),
        base("range-split", certified("10", "12")),
        base("range-deep", deep(certificate({proved("2", "9/4", 3, 3)}), 3)),
        base("open", certificate({proved("2", "5/2", 3, 3), left_open("5/2", "3")})),
        base("loose", certificate({proved("4", "5", 6, 2)})),
        base("big", certified("4.603338848751702", "4.603338848751702")),
        base("big-range", certified("11.3622592088388", "11.3622592088389", "1e-18")),
        base("full", certified("3", "3", "1e-3", Section::full)),
        base("full-equal", certified("1", "1", "1e-3", Section::full)),
        base("full-range", certified("2", "2.1", "1e-3", Section::full)),
        base("full-deep", deep(certified("3/2", "3/2", "1e-3", Section::full), 3)),
        base("full-again", certificate({proved("30", "45", 20, 5, Section::full)}, {Section::full})),
        base("plain", certificate({proved("1.01", "1.01", 4, 3, Section::plain)}, {Section::plain})),
        base("coin", bodies(Section::plain_body, "1", "4", "4", 4, 4)),
        base("symmetric-range", bodies(Section::plain_body, "1", "2", "3", 3, 3)),
        base("orbits", bodies(Section::body, "1/2", "13/2", "13/2", 4, 4)),
        base("orbits-range", bodies(Section::body, "1/2", "5/2", "5", 3, 3)),
        base("falling",
             subdivided(box({{{"-1", "1"}, {"1/100", "1/100"}, {"3/2", "3/2"}, {"-1", "-1"}, {"10", "10"}}}),
                        16)),
        base("turning-starts",
             subdivided(box({{{"4", "5"}, {"-1", "-1/2"}, {"3/2", "7/4"}, {"-1/10", "1/10"}, {"3", "4"}}}),
                        12)),
        base("precise-starts",
             subdivided(box({{{"1/3", "1/3"}, {"1", "1"}, {"3/2", "3/2"}, {"-1", "-1"}, {"100", "100"}}}), 1,
                        200)),
        base("rising-starts",
             subdivided(box({{{"0", "3"}, {"2", "3"}, {"1", "1"}, {"1/4", "2"}, {"2", "2"}}}), 12)),
        base("open-starts",
             with_open_leaf(subdivided(
                 box({{{"0", "3"}, {"-1/2", "1/2"}, {"3/2", "3/2"}, {"-1", "-1"}, {"1", "3/2"}}}), 8))),
        base("incoming", all_incoming(10, 96))};
    if (large) {
        all.push_back(base("full-large", certified("10", "10", "1e-3", Section::full)));
        all.push_back(base("body", bodies(Section::plain_body, "1/2", "5/2", "5/2", 6, 3), 6));
        all.push_back(base("staircase", certified("1", "50")));
    }
    for (Base& adiabatic : adiabatic_bases()) all.push_back(std::move(adiabatic));
    return all;
}

}  // namespace dumbbell_mutation
