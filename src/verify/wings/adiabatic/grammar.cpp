// The grammar of a file about the adiabatic invariant (format-adiabatic.md, section 2).
#include "verify/wings/adiabatic/grammar.hpp"

#include <cmath>

#include "verify/core/reader.hpp"
#include "verify/core/tree.hpp"
#include "verify/wings/starts/zero.hpp"

namespace dumbbell_verify::adiabatic {
namespace {

enum { split, bound_leaf, outside };
constexpr int most_halvings = 200;          ///< of one axis, above a node
constexpr unsigned least_orbit_bits = 256;  ///< of an orbit, unless doubles do

using Axes = std::array<std::string_view, 5>;  ///< the names of those that a tree has
constexpr Axes class_axes{"u", "", "", "delta", "sigma"}, bounce_axes{"u", "s", "", "delta", ""},
    run_axes{"u", "s", "v", "delta", ""};

class ClaimReader : public Reader<Leaf> {
  public:
    ClaimReader(Text& text, const Settings& settings, const Numbers& numbers, Claim::Kind kind)
        : Reader(text, settings), numbers_(numbers) {
        claim_.kind = kind;
        leaf_.terms = &terms_;
        for (const auto* name : {"split", "bound", "outside"}) proof_.tallies.push_back({name});
    }
    [[nodiscard]] Claim& claim() { return claim_; }

  private:
    [[nodiscard]] std::string_view kind() const override { return claim_.kind_name(); }
    [[nodiscard]] std::string missing() const override { return adiabatic::missing(claim_, numbers_); }
    [[nodiscard]] const char* check(const Leaf& leaf, Log* log) const override {
        return check_leaf(leaf, log);
    }
    [[nodiscard]] std::string_view opcode(const Leaf& leaf) const override { return leaf.opcode; }

    void read() override {
        header();
        if (claim_.has_classes()) classes();
        claim_tree();
        for (std::size_t i = 0; i < claim_.bounds.size(); ++i) attained();
    }

    void header() {
        text_.expect("delta", 2);
        claim_.delta_lo = starts::level(text_, 1);
        claim_.delta_hi = starts::level(text_, 2);
        if (!(claim_.delta_lo <= claim_.delta_hi && claim_.delta_hi > 0 && 2 * claim_.delta_hi < 1))
            text_.reject("number", "not 0 <= D1 <= D2 < 1/2, 0 < D2");
        if (claim_.delta_lo == 0 && claim_.kind != Claim::run)
            text_.reject("number", "D1 = 0 is for `adiabatic-run`");
        if (claim_.has_heights()) {
            text_.expect("heights", 2);
            claim_.y_lo = starts::level(text_, 1);
            claim_.y_hi = starts::level(text_, 2);
            if (!(claim_.y_lo < claim_.y_hi && claim_.y_hi <= 1)) text_.reject("number", "not Y1 < Y2 <= 1");
        }
        text_.expect("margin", 1);
        claim_.margin = starts::level(text_, 1);
        if (!(claim_.margin > 0 && claim_.margin <= 1)) text_.reject("number", "not 0 < margin <= 1");
        claim_.exponent = claim_.kind == Claim::run ? 0 : 8;
        if (claim_.kind == Claim::bounce) claim_.exponent = number("exponent", 0, 16);
        read_bits(leaf_);
        const std::size_t n = claim_.kind == Claim::bounce ? 2 : 1;
        text_.expect("bound", n);
        for (std::size_t i = 1; i <= n; ++i) claim_.bounds.push_back(starts::level(text_, i));
    }
    std::uint64_t number(std::string_view keyword, std::uint64_t least, std::uint64_t most) {
        text_.expect(keyword, 1);
        const std::uint64_t n = text_.natural(1);
        if (n < least || n > most)
            text_.reject("number", std::string(keyword) + " not within " + std::to_string(least) + " to " +
                                       std::to_string(most));
        return n;
    }

    void classes() {
        const std::uint64_t n = number("classes", 1, 64);
        while (terms_.classes.size() < n) {
            const std::size_t i = terms_.classes.size();
            text_.expect("class", 2);
            const std::uint64_t line = text_.line, cells = text_.natural(2);
            if (cells < 1 || cells > 4096) text_.reject("number", "not 1 to 4096 cells");
            mpq_class top(11, 7);
            Class& last = terms_.classes.emplace_back(Class{starts::level(text_, 1), Potential(top)});
            while (last.potential.size() < cells) {
                text_.expect("cell", 2);
                const mpq_class low = starts::level(text_, 1);
                if (low >= top) text_.reject("number", "cells go down from 11/7");
                last.potential.add_cell(low, starts::level(text_, 2));
                top = low;
            }
            set_root(class_axes);
            take(Leaf::class_itself, i, line, "class");
            read_tree(Leaf::class_tree, i, class_axes, "class" + std::to_string(i) + ".");
        }
        text_.expect("end", 0);
    }
    void claim_tree() {
        const Axes& axes = claim_.kind == Claim::bounce ? bounce_axes : run_axes;
        set_root(axes);
        read_tree(Leaf::claim_tree, 0, axes, "box.");
    }
    void set_root(const Axes& axes) {
        const mpq_class most[] = {2, 1, 2, claim_.delta_hi, 8};
        for (std::size_t i = 0; i < axes.size(); ++i) {
            leaf_.box.lo.at(i) = i == axis_delta ? claim_.delta_lo : mpq_class(0);
            leaf_.box.hi.at(i) = axes.at(i).empty() ? mpq_class(0) : most[i];
        }
    }
    void read_tree(Leaf::Part part, std::size_t index, const Axes& axes, const std::string& name) {
        ++proof_.roots;
        Tree<Box> tree{text_, axes, proof_.tallies[split].lines, leaf_.box, name, most_halvings};
        tree.read([&] { leaf(part, index, std::ldexp(1, -tree.depth), tree.path); });
    }
    void leaf(Leaf::Part part, std::size_t index, double share, const std::string& path) {
        const auto& f = text_.fields;
        const bool chooses = part == Leaf::claim_tree && claim_.has_classes();
        leaf_.outside = f[0] == "outside";
        if (!leaf_.outside && f[0] != "bound") text_.reject("opcode", "not a line for this place");
        if (f.size() != (chooses && !leaf_.outside ? 2 : 1)) text_.reject("syntax", "wrong number of values");
        if (chooses) {
            const std::uint64_t chosen = leaf_.outside ? 0 : text_.natural(1);
            if (chosen >= terms_.classes.size()) text_.reject("number", "no such class");
            index = static_cast<std::size_t>(chosen);
        }
        Tally& tally = proof_.tallies[leaf_.outside ? outside : bound_leaf];
        ++tally.lines;
        tally.covered += share;
        take(part, index, text_.line, tally.name);
        explain(path);
    }

    void attained() {
        text_.expect("attained", 5);
        Claim::Attained state{starts::signed_ratio(text_, 1), starts::signed_ratio(text_, 2),
                              starts::level(text_, 3), text_.natural(4), starts::level(text_, 5)};
        if (!(state.u > 0 && state.s >= 0 && state.s <= 1)) text_.reject("number", "not u > 0, 0 <= s <= 1");
        if (!(state.delta > 0 && state.delta >= claim_.delta_lo && state.delta <= claim_.delta_hi))
            text_.reject("number", "delta beyond D1 to D2, or 0");
        if (claim_.kind == Claim::bounce && state.collisions != 1)
            text_.reject("number", "one collision follows");
        // The distance from the vertical, exactly: u^16 >= m^16 delta^exponent.
        if (power(state.u, 16) < power(claim_.margin, 16) * power(state.delta, claim_.exponent))
            text_.reject("attained", "the rod is nearer to the vertical than the margin");
        claim_.attained.push_back(state);
        leaf_.outside = false;
        const unsigned bits = leaf_.bits;
        leaf_.bits = std::max(bits, least_orbit_bits);
        take(Leaf::attained, claim_.attained.size() - 1, text_.line, "attained");
        explain("attained" + std::to_string(claim_.attained.size()));
        leaf_.bits = bits;
    }
    static mpq_class power(const mpq_class& x, std::uint64_t n) {
        mpq_class result;
        mpz_pow_ui(result.get_num_mpz_t(), x.get_num_mpz_t(), n);
        mpz_pow_ui(result.get_den_mpz_t(), x.get_den_mpz_t(), n);
        return result;
    }

    /// The present leaf is to be checked.
    void take(Leaf::Part part, std::size_t index, std::uint64_t line, std::string_view opcode) {
        leaf_.part = part;
        leaf_.index = index;
        leaf_.line = line;
        leaf_.opcode = opcode;
        Reader::take(leaf_);
    }
    void explain(const std::string& path) {
        if (!is_asked_for(path)) return;
        std::string box;
        for (std::size_t i = 0; i < leaf_.box.lo.size(); ++i)
            box += "  " + std::string(names[i]) + " in [" + to_string(leaf_.box.lo.at(i)) + ", " +
                   to_string(leaf_.box.hi.at(i)) + "]\n";
        Reader::explain(leaf_, path, box);
    }

    static constexpr std::array<std::string_view, 5> names{"u", "s", "v", "delta", "sigma"};

    const Numbers& numbers_;
    Terms terms_;
    Claim& claim_ = terms_.claim;
    Leaf leaf_;  ///< the present one; its box is that of the present node
};

}  // namespace

const char* check_leaf(const Leaf& leaf, Log* log) {
    switch (leaf.part) {
        case Leaf::attained:
            return check_attained(leaf, log);
        case Leaf::claim_tree:
            return leaf.terms->claim.kind == Claim::bounce ? check_bounce(leaf, log)
                                                           : check_bounces(leaf, log);
        default:
            return check_class(leaf, log);
    }
}

std::pair<Proof, Claim> proof(Text& text, const Settings& settings, const Numbers& numbers,
                              Claim::Kind kind) {
    ClaimReader reader(text, settings, numbers, kind);
    Proof proof = reader.proof();
    return {std::move(proof), std::move(reader.claim())};
}

template <Claim::Kind kind>
Verified read_kind(Text& text, const Request& request) {
    return about(proof(text, request, request.numbers, kind));
}

std::span<const ClaimKind> claim_kinds() {
    static constexpr ClaimKind kinds[] = {
        {.name = Claim::names[Claim::bounce], .proof = read_kind<Claim::bounce>},
        {.name = Claim::names[Claim::run], .proof = read_kind<Claim::run>},
        {.name = Claim::names[Claim::scattering], .proof = read_kind<Claim::scattering>}};
    return kinds;
}

}  // namespace dumbbell_verify::adiabatic
