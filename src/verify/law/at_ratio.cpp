// The grammar of a file about one mass ratio by the law, and its rule (format-law.md, section 5).
#include "verify/law/at_ratio.hpp"

#include "verify/format/reader.hpp"
#include "verify/law/constants.hpp"
#include "verify/law/file.hpp"
#include "verify/number/big.hpp"

namespace dumbbell_verify {
namespace {

/// On which side of q_c(N) the ratio q is: not beyond it, so that N* <= N - 1, or beyond it, so that N* >= N.
struct Side {
    bool beyond = false;
    mpz_class N;
    std::uint64_t line = 0;
};

/// L56 for N > 902, with as many bits as C sqrt q - (N - 2) needs to be known to a small share of q^(-1/2).
class SideRule {
    using I = Interval<Big>;

  public:
    explicit SideRule(const mpq_class& q) {
        const auto size = [](const mpz_class& x) {
            return static_cast<long>(mpz_sizeinbase(x.get_mpz_t(), 2));
        };
        Big::precision = std::max(0L, size(q.get_num()) - size(q.get_den())) + 192;
        const I root = square_root(number(q)), rest = law_constant<Big>() / square_root(root);
        const Big ln = Big::rounded(up, mpfr_log, bound(up, q, Big(0)).get());
        place_ = growth_constant<Big>() * root;
        least_ = rest - (fraction<Big>(63, 1000) * I(ln) + fraction<Big>(7, 10)) / root;
        most_ = rest - fraction<Big>(16, 100) / root;
    }
    [[nodiscard]] bool certifies(const Side& side, std::string* log) const {
        const I excess = place_ - number(mpq_class(side.N - 2));
        if (log)
            *log += "  C sqrt q - (N - 2) in " + show(excess) +
                    "\n  c0 q^(-1/4) less its bounds by Theorem A in " + show({least_.lo, most_.hi}) + "\n";
        return side.beyond ? excess.lo > most_.hi : excess.hi <= least_.lo;
    }

  private:
    static I number(const mpq_class& x) { return {bound(down, x, Big(0)), bound(up, x, Big(0))}; }
    static std::string show(const I& x) {
        std::array<char, 80> text{};
        std::snprintf(text.data(), text.size(), "[%.17g, %.17g]", to_double(down, x.lo), to_double(up, x.hi));
        return text.data();
    }

    I place_, least_, most_;  ///< C sqrt q; what Theorem A says of delta_N, at q
};

class AtRatioReader : public Reader<Side> {
  public:
    AtRatioReader(Text& text, const Settings& settings) : Reader(text, settings) {
        if (settings.demand.keep)
            throw Failure{Verdict::unreadable, 0, "usage",
                          "--lemma compares covers; this file is about one mass ratio by the law"};
    }
    [[nodiscard]] LawAtRatio& claim() { return claim_; }

  private:
    [[nodiscard]] std::string_view kind() const override { return LawAtRatio::kind; }
    [[nodiscard]] std::string missing() const override { return claim_.missing(settings_.demand); }
    [[nodiscard]] std::string_view opcode(const Side& side) const override {
        return side.beyond ? "lower" : "upper";
    }
    [[nodiscard]] const char* check(const Side& side, std::string* log) const override {
        if (side.N > last_step)
            return SideRule(claim_.q).certifies(side, log) ? nullptr
                   : side.beyond                           ? "q > q_c(lower)"
                                                           : "q <= q_c(upper + 1)";
        if (side.N < first_step) return nullptr;  // N* >= 2 at every q
        if (side.beyond && side.N == first_step)  // q_c(3) = 1, Theorem 2 (d)
            return claim_.q > 1 ? nullptr : "q > 1";
        const Law::Step& step = law_->step(side.N.get_ui());
        if (log) *log += "  the step to " + side.N.get_str() + " is in " + to_string(step.lo, step.hi) + "\n";
        if (side.beyond) return claim_.q >= step.hi ? nullptr : "q >= B of the step to lower";
        return claim_.q <= step.lo ? nullptr : "q <= A of the step to upper + 1";
    }

    void read() override {
        text_.expect("ratio", 1);
        claim_.q = text_.ratio(1);
        if (claim_.q < 1) text_.reject("number", "not 1 <= q");
        text_.expect("law", 1);
        claim_.law = text_.fields[1];
        if (claim_.law.size() != 64 || claim_.law.find_first_not_of("0123456789abcdef") != std::string::npos)
            text_.reject("number", "not a SHA-256 in hexadecimal");
        if (!settings_.law)
            throw Failure{Verdict::unreadable, text_.line, "usage",
                          "this file rests on the certificate of the law with sha256=" + claim_.law +
                              ": give it by --law FILE"};
        law_ = &settings_.law->verified(claim_.law, settings_);
        claim_.upper = bound("upper");
        if (claim_.upper < 2) text_.reject("number", "not 2 <= upper");
        side(false, claim_.upper + 1);
        claim_.lower = bound("lower");
        if (claim_.lower < 2 || claim_.lower > claim_.upper || claim_.lower + 1 < claim_.upper)
            text_.reject("number", "not 2 <= lower, lower = upper or upper - 1");
        side(true, claim_.lower);
    }
    mpz_class bound(std::string_view keyword) {
        text_.expect(keyword, 1);
        return text_.long_natural(1);
    }
    void side(bool beyond, mpz_class N) {
        const Side side{beyond, std::move(N), text_.line};
        explain(side, std::string(opcode(side)));
        take(side);
    }

    LawAtRatio claim_;
    const Law* law_ = nullptr;
};

}  // namespace

std::pair<Proof, LawAtRatio> law_at_ratio(Text& text, const Settings& settings) {
    AtRatioReader reader(text, settings);
    Proof proof = reader.run();
    return {std::move(proof), std::move(reader.claim())};
}

}  // namespace dumbbell_verify
