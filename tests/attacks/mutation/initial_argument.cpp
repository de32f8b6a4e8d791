#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <climits>
#include <memory>
#include <optional>

#include "argument.hpp"
#include "base/error.hpp"
#include "starts/incoming.hpp"
#include "starts/leaf.hpp"
#include "starts/trace.hpp"
#include "text.hpp"

namespace dumbbell_mutation {
namespace {

using namespace dumbbell;
using namespace dumbbell::starts;

using Names = std::array<std::string_view, initial_axes>;
constexpr Names box_names{"phi", "phidot", "y", "ydot", "q"};
constexpr Names incoming_names{"phi", "s", "", "", ""};  ///< that a file about incoming trajectories splits

struct NotShown {
    std::string what;
};

Rational signed_rational(const std::string& text) {
    return text[0] == '-' ? Rational(-parse_rational(text.substr(1))) : parse_rational(text);
}
Rational dyadic(const std::string& text) {
    const std::size_t b = text.find('b');
    const int exponent = std::stoi(text.substr(b + 1));
    const Rational power(Integer(1) << static_cast<unsigned>(std::abs(exponent)));
    const Rational mantissa = parse_rational(text.substr(0, b));
    return exponent < 0 ? Rational(mantissa / power) : Rational(mantissa * power);
}

/// A leaf by the words of its line.
InitialLeaf leaf_of(const Words& words) {
    if (words[0] == "open") return {};
    const std::size_t numbers = words[0] == "between" ? 2 : 1;
    InitialLeaf leaf{std::stol(words.at(1)), std::stol(words.at(numbers)), {}};
    if (words.size() > 1 + numbers)
        leaf.first = FirstContact{words.at(1 + numbers) == "heavy", dyadic(words.at(2 + numbers)),
                                  dyadic(words.at(3 + numbers))};
    return leaf;
}

/// The first contact of all orbits of the box, enclosed with many digits; for windows tighter than the prover
/// writes.
bool traced_to(const InitialBox& box, const FirstContact& first) {
    constexpr int digits = 60;
    const Trace traced = trace(box, digits);
    if (traced.collisions.empty()) return false;
    const auto& contact = traced.collisions.front();
    return contact.heavy == first.heavy && parse_rational(contact.time.lo) > first.from &&
           parse_rational(contact.time.hi) < first.until;
}

/// No collision, in exact arithmetic: all rise more steeply than any wall (L3), or do not sink and are above
/// all.
bool certainly_leaves(const InitialBox& box) {
    const auto lo = [&](InitialAxis axis) { return box.lower(axis); };
    const Rational scale = 1 + 1 / box.upper(InitialAxis::ratio);
    const Rational spin = std::max(Rational(-lo(InitialAxis::phidot)), box.upper(InitialAxis::phidot));
    const Rational& climb = lo(InitialAxis::ydot);
    return (climb > 0 && climb * scale >= spin) || (climb >= 0 && lo(InitialAxis::y) * scale > 1);
}

/// No dumbbell at rest, and both masses above the floor: format-initial.md, section 2.
bool starts_in_the_air(const InitialBox& box) {
    const auto holds_zero = [&](InitialAxis axis) { return box.lower(axis) <= 0 && box.upper(axis) >= 0; };
    const PrecisionScope scope(1024);
    const auto number = [](const Rational& x) { return enclose<BigInterval>(x); };
    const BigInterval sine =
        sin_cos(hull(number(box.lower(InitialAxis::phi)), number(box.upper(InitialAxis::phi)))).sin;
    const Rational &y = box.lower(InitialAxis::y), r_lo = 1 / box.upper(InitialAxis::ratio),
                   r_hi = 1 / box.lower(InitialAxis::ratio);
    return !(holds_zero(InitialAxis::phidot) && holds_zero(InitialAxis::ydot)) &&
           certainly_positive(number(y * (1 + r_lo)) + low_end(sine)) &&
           certainly_positive(number(y * (1 + r_hi)) - number(r_hi) * high_end(sine));
}

/// Does what the prover says of a box confirm what the leaf says of all of it?
bool confirms(const InitialLeaf& found, const InitialBox& box, const InitialLeaf& leaf) {
    if (!leaf.most || (*leaf.most == 0 && certainly_leaves(box))) return true;
    const long least =
        std::max(found.least, box.upper(InitialAxis::ydot) < 0 ? 1L : 0L);  // what falls collides
    const bool counts = least >= leaf.least && found.most && *found.most <= *leaf.most;
    const bool window =
        !leaf.first || (found.first && found.first->heavy == leaf.first->heavy &&
                        found.first->from >= leaf.first->from && found.first->until <= leaf.first->until);
    return counts && (window || traced_to(box, *leaf.first));
}

/// By the prover's code on the box, or on the parts of it: what holds for all parts holds for the box.
bool confirmed(const InitialBox& box, const InitialLeaf& leaf, int bits, int depth) {
    if (confirms(judge_initial(box, bits), box, leaf)) return true;
    if (depth == 0) return false;
    std::size_t widest = initial_axes;
    for (std::size_t i = 0; i < initial_axes; ++i)
        if (box.lo[i] < box.hi[i] &&
            (widest == initial_axes || box.hi[i] - box.lo[i] > box.hi[widest] - box.lo[widest]))
            widest = i;
    if (widest == initial_axes) return false;
    InitialBox lower = box, upper = box;
    lower.hi[widest] = upper.lo[widest] = (box.lo[widest] + box.hi[widest]) / 2;
    return confirmed(lower, leaf, bits, depth - 1) && confirmed(upper, leaf, bits, depth - 1);
}

class File {
  public:
    explicit File(const std::string& path);

    void check(const dumbbell_verify::Initial& proved) {
        if (!incoming_ && !starts_in_the_air(box_)) throw NotShown{"at rest, or not in the air"};
        const std::size_t begin = next_;
        walk(box_, 1);
        if (!lines_.at(next_).starts_with("total ")) throw NotShown{"lines behind the tree"};
        const bool all = open_ == 0;
        if (proved.least != static_cast<std::uint64_t>(all ? least_ : 0) || proved.most.has_value() != all ||
            (all && *proved.most != static_cast<std::uint64_t>(most_)) ||
            dumbbell_verify::to_string(proved.decided) != to_fraction(decided_))
            throw NotShown{"the verdict states another claim than the leaves"};
        if (proved.incoming != incoming_) throw NotShown{"the verdict states another claim than the file"};
        for (std::size_t i = incoming_ ? initial_axes - 1 : 0; i < initial_axes; ++i)
            if (dumbbell_verify::to_string(proved.box.lo[i]) != to_fraction(box_.lo[i]) ||
                dumbbell_verify::to_string(proved.box.hi[i]) != to_fraction(box_.hi[i]))
                throw NotShown{"the verdict states another box than the file"};
        nodes_ = next_ - begin;
    }
    [[nodiscard]] std::size_t nodes() const { return nodes_; }

  private:
    void walk(const InitialBox& box, const Rational& share) {
        const std::size_t line = next_++;
        const Words words = words_of(lines_.at(line));
        if (words[0] == "split") {
            const Names& names = incoming_ ? incoming_names : box_names;
            const auto axis =
                static_cast<std::size_t>(std::find(names.begin(), names.end(), words.at(1)) - names.begin());
            InitialBox lower = box, upper = box;
            lower.hi.at(axis) = upper.lo.at(axis) = (box.lo.at(axis) + box.hi.at(axis)) / 2;
            walk(lower, share / 2);
            walk(upper, share / 2);
            return;
        }
        const InitialLeaf leaf = leaf_of(words);
        if (!(incoming_ ? holds_for_incoming(box, leaf) : confirmed(box, leaf, bits_, most_halvings)))
            throw NotShown{fmt::format("line {}: {}", line + 1, lines_[line])};
        if (!leaf.most) {
            ++open_;
            return;
        }
        if (*leaf.most == leaf.least) decided_ += share;
        least_ = std::min(least_, leaf.least);
        most_ = std::max(most_, *leaf.most);
    }

    /// Up to s = 1 the states have no bound: they fall, and no trajectory has more than the maximum.
    [[nodiscard]] bool holds_for_incoming(const InitialBox& piece, const InitialLeaf& leaf) const {
        if (!is_unbounded(piece)) return confirmed(states_of_incoming(piece), leaf, bits_, most_halvings);
        const auto maximum = judge_falling(piece.lower(InitialAxis::ratio)).most;
        return !leaf.most || (!leaf.first && leaf.least <= 1 && leaf.least < *leaf.most && maximum &&
                              *maximum <= *leaf.most);
    }

    static constexpr int most_halvings = 10;
    Lines lines_;
    std::size_t next_ = 0, nodes_ = 0;
    InitialBox box_;
    int bits_ = 53;
    bool incoming_ = false;
    Rational decided_ = 0;
    long least_ = LONG_MAX, most_ = 0, open_ = 0;
};

File::File(const std::string& path) {
    const std::unique_ptr<gzFile_s, int (*)(gzFile)> in(gzopen(path.c_str(), "rb"), &gzclose);
    std::string text;
    std::array<char, 4096> block{};
    for (int n = 1; in && n > 0; text.append(block.data(), static_cast<std::size_t>(std::max(n, 0))))
        n = gzread(in.get(), block.data(), block.size());
    lines_ = lines_of(text);
    constexpr std::size_t ratio_line = 6;  // counted from 0; after it the other axes, if it is about a box
    incoming_ = lines_.at(ratio_line - 1) == "claim incoming";
    for (std::size_t i = incoming_ ? initial_axes - 1 : 0; i < initial_axes; ++i) {
        const bool ratio = i + 1 == initial_axes;
        const Words words = words_of(lines_.at(ratio ? ratio_line : ratio_line + 1 + i));
        if (words.at(0) != (ratio ? "ratio" : box_names.at(i))) throw NotShown{"the header"};
        box_.lo[i] = signed_rational(words.at(1));
        box_.hi[i] = signed_rational(words.at(2));
    }
    const std::size_t bits_line = ratio_line + (incoming_ ? 1 : initial_axes);
    if (incoming_) {
        if (box_.lo.back() != box_.hi.back()) throw NotShown{"a range of ratios"};
        box_ = incoming_box(box_.lo.back());
    }
    bits_ = std::stoi(words_of(lines_.at(bits_line)).at(1));
    next_ = bits_line + 2;  // after `bits` and `between`
}

}  // namespace

Argument initial_argument(const std::string& path, const dumbbell_verify::Initial& proved) {
    try {
        File file(path);
        file.check(proved);
        return {true, fmt::format("{} nodes judged again by the prover", file.nodes())};
    } catch (const NotShown& fault) {
        return {false, fault.what};
    } catch (const std::exception& error) {
        return {false, error.what()};
    }
}

}  // namespace dumbbell_mutation
