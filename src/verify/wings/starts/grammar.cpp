// The grammar of a file about initial conditions (format-initial.md, section 2).
#include "verify/wings/starts/grammar.hpp"

#include <cmath>

#include "verify/core/reader.hpp"
#include "verify/core/tree.hpp"
#include "verify/wings/starts/zero.hpp"

namespace dumbbell_verify::starts {
namespace {

enum { split, exactly, between, open };

constexpr std::size_t most_shares = 20'000;  ///< where they change: the memory is bounded

class ClaimReader : public Reader<Leaf> {
  public:
    ClaimReader(Text& text, const Settings& settings, const Numbers& numbers, bool incoming)
        : Reader(text, settings), numbers_(numbers) {
        claim_.incoming = incoming;
        claim_.least = UINT64_MAX;
        claim_.most = 0;
        claim_.asked = static_cast<const Known&>(claim_);
        if (settings.shares) claim_.shares.emplace();
        for (const auto* name : {"split", "exactly", "between", "open"}) proof_.tallies.push_back({name});
    }
    [[nodiscard]] Claim& claim() { return claim_; }

  private:
    [[nodiscard]] std::string_view kind() const override { return claim_.kind_name(); }
    [[nodiscard]] std::string missing() const override {
        return starts::missing(claim_, settings_.demand, numbers_);
    }
    [[nodiscard]] const char* check(const Leaf& leaf, Log* log) const override {
        return check_leaf(leaf, log);
    }
    [[nodiscard]] std::string_view opcode(const Leaf& leaf) const override { return leaf.opcode; }

    void read() override {
        header();
        Tree<Box> tree{text_, axes(), proof_.tallies[split].lines, leaf_.box, "box."};
        tree.read([&] { leaf(tree.depth, tree.path); });
        compare_bounds();
    }

    [[nodiscard]] std::span<const std::string_view> axes() const {
        static constexpr std::array<std::string_view, 2> section{"phi", "s"};
        return claim_.incoming ? std::span<const std::string_view>(section) : axis_names;
    }

    void header() {
        read_axis("ratio", 4, [](const Text& text, std::size_t i) { return text.ratio(i); });
        if (leaf_.box.lo[4] < 1) text_.reject("number", "not 1 <= LO");
        for (std::size_t i = 0; i < 4 && !claim_.incoming; ++i) read_axis(axis_names[i], i, signed_ratio);
        if (claim_.incoming) {
            if (leaf_.box.lo[4] != leaf_.box.hi[4]) text_.reject("number", "not LO = HI");
            leaf_.box.hi[0] = 2;
            leaf_.box.hi[1] = 1;
        }
        claim_.box = leaf_.box;
        claim_.asked_box = demanded_box(leaf_.box, numbers_, settings_.demand.ratios);
        read_bits(leaf_);
        if (!claim_.incoming) require_motion();
        text_.expect("between", 2);
        bounds_line_ = text_.line;
        least_ = text_.natural(1);
        if (text_.fields[2] != "none") most_ = text_.natural(2);
        proof_.roots = 1;
    }
    void read_axis(std::string_view keyword, std::size_t i, mpq_class (*value)(const Text&, std::size_t)) {
        text_.expect(keyword, 2);
        leaf_.box.lo[i] = value(text_, 1);
        leaf_.box.hi[i] = value(text_, 2);
        if (leaf_.box.lo[i] > leaf_.box.hi[i]) text_.reject("number", "not LO <= HI");
    }
    /// Once for the file: no dumbbell of the box rests, and all start in the air.
    void require_motion() const {
        const auto holds_zero = [&](std::size_t i) { return leaf_.box.lo[i] <= 0 && leaf_.box.hi[i] >= 0; };
        if (holds_zero(1) && holds_zero(3)) text_.reject("rest", "the box holds a dumbbell at rest");
        if (leaf_.box.hi[0] - leaf_.box.lo[0] > 7) text_.reject("number", "phi spans more than 7");
        const auto floor = judge(text_.line, "floor", [&] {
            return starts_in_the_air(leaf_.box, leaf_.bits) ? nullptr : "both masses start above the floor";
        });
        if (floor) throw Failure(*floor);
    }

    void leaf(int depth, const std::string& path) {
        const auto& f = text_.fields;
        const std::size_t opcode = f[0] == "exactly" ? exactly : f[0] == "between" ? between : open;
        const double share = std::ldexp(1, -depth);
        ++proof_.tallies[opcode].lines;
        proof_.tallies[opcode].covered += share;
        const mpq_class volume(1, mpz_class(1) << depth);
        if (opcode == open) {
            if (f.size() != 1 || f[0] != "open") text_.reject("opcode", "not a line for this place");
            if (claim_.shares) claim_.shares->open += volume;
            return join(0, std::nullopt, volume);
        }
        const std::size_t numbers = opcode == exactly ? 1 : 2;
        if (f.size() != 1 + numbers && f.size() != 4 + numbers)
            text_.reject("syntax", "wrong number of values");
        leaf_.opcode = proof_.tallies[opcode].name;
        leaf_.line = text_.line;
        leaf_.least = text_.natural(1);
        leaf_.most = text_.natural(numbers);
        leaf_.first.reset();
        if (f.size() == 4 + numbers) window(1 + numbers);
        if (opcode == exactly && leaf_.first.has_value() != (leaf_.least > 0))
            text_.reject("syntax", "`exactly` has a window iff its number is not 0");
        if (opcode == between && leaf_.least >= leaf_.most) text_.reject("number", "not a < b");
        if (claim_.shares) {
            text_.budget.take(4 * Work::of_box({}, {}, depth), text_.line);
            claim_.shares->add(leaf_.least, leaf_.most, volume);
            if (claim_.shares->counts.size() > most_shares)
                throw Failure{Verdict::limit, text_.line, "limit",
                              "--shares of more than 20,000 different numbers of collisions"};
        }
        join(leaf_.least, leaf_.most, volume);
        const Leaf judged = claim_.incoming ? of_states() : leaf_;
        explain(judged, path);
        take(judged);
    }
    /// What the present leaf says, which has this share of the file's box.
    void join(std::uint64_t least, const std::optional<std::uint64_t>& most, const mpq_class& volume) {
        claim_.join(least, most, volume);
        if (!claim_.asks_of_part()) return claim_.asked.join(least, most, volume);
        const auto& [lo, hi] = leaf_.box;
        for (std::size_t i = 0; i < lo.size(); ++i)  // some rational numbers of a size like that
            text_.budget.take(6 * Work::of_halving(lo[i], hi[i]), text_.line);
        const mpq_class share = share_in(leaf_.box, claim_.asked_box, claim_.box);
        text_.budget.take(6 * Work::of_halving(share, claim_.asked.decided), text_.line);
        if (share > 0) claim_.asked.join(least, most, share);
    }
    /// The present leaf, its piece of the section replaced by its states. Up to s = 1 they have no bound:
    /// there nothing but that they fall may be used.
    Leaf of_states() {
        Leaf result = leaf_;
        const bool unbounded = leaf_.box.hi[1] == 1;
        if (unbounded && (leaf_.first || leaf_.least == leaf_.most))
            text_.reject("section", "up to s = 1 a leaf is `open`, or `between` without a window");
        if (unbounded) result.box.hi[1] = result.box.lo[1];
        result.any_spin = unbounded;
        result.box = incoming_states(result.box);
        return result;
    }
    void window(std::size_t i) {
        const auto mass = text_.fields[i];
        if (mass != "light" && mass != "heavy") text_.reject("syntax", "not a mass");
        leaf_.first = FirstContact{mass == "heavy", text_.dyadic(i + 1), text_.dyadic(i + 2)};
        if (!(0 < leaf_.first->from && leaf_.first->from < leaf_.first->until))
            text_.reject("number", "not 0 < t0 < t1");
        if (leaf_.least == 0) text_.reject("number", "a first contact and no collision");
    }
    void compare_bounds() {
        if (least_ != claim_.least || most_ != claim_.most)
            throw Failure{Verdict::rejected, bounds_line_, "between",
                          "expected " + std::to_string(claim_.least) + " " +
                              (claim_.most ? std::to_string(*claim_.most) : "none")};
    }
    const Numbers& numbers_;
    Claim claim_;
    Leaf leaf_;  ///< the present one; its box is that of the present node
    std::uint64_t bounds_line_ = 0, least_ = 0;
    std::optional<std::uint64_t> most_;
};

}  // namespace

Box incoming_states(const Box& piece) {
    constexpr mp_bitcnt_t places = 512;  // binary
    static const mpz_class units("100000000000000000000000000000000000000000000000000"),
        half_turn("314159265358979323846264338327950288419716939937510");  // units * pi, rounded down
    const mpq_class q = piece.lo[4], beta2 = q / (q + 1);
    const auto spin = [&](const mpq_class& s, int more) {
        const mpq_class squared = s * s * q / (1 - s * s) * (mpz_class(1) << (2 * places));
        const mpz_class whole = squared.get_num() / squared.get_den(), root = sqrt(whole);
        return mpq_class(mpq_class(root + more) / (mpz_class(1) << places));
    };
    Box box = piece;
    box.lo[0] *= mpq_class(half_turn) / units;
    box.hi[0] *= mpq_class(half_turn + 1) / units;
    box.lo[1] = spin(piece.lo[1], 0);
    box.hi[1] = spin(piece.hi[1], 1);
    box.lo[2] = box.hi[2] = beta2 * (1 + mpq_class(1, 1 << 20));
    box.lo[3] = box.hi[3] = -beta2;
    return box;
}

std::pair<Proof, Claim> proof(Text& text, const Settings& settings, const Numbers& numbers, bool incoming) {
    ClaimReader reader(text, settings, numbers, incoming);
    Proof proof = reader.proof();
    return {std::move(proof), std::move(reader.claim())};
}

template <bool incoming>
Verified read_kind(Text& text, const Request& request) {
    return about(proof(text, request, request.numbers, incoming));
}

std::span<const ClaimKind> claim_kinds() {
    static constexpr ClaimKind kinds[] = {
        {.name = "initial-conditions", .proof = read_kind<false>, .is_of_starts = true},
        {.name = "incoming", .proof = read_kind<true>, .is_of_starts = true}};
    return kinds;
}

}  // namespace dumbbell_verify::starts
