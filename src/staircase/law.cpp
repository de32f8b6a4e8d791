#include "staircase/law.hpp"

#include <algorithm>
#include <vector>

#include "flight/growth_constant.hpp"
#include "flight/paper_bound.hpp"
#include "number/rational.hpp"

namespace dumbbell::staircase {
namespace {

/// Whether `upper` <= ceil(pi / gamma) = paper_bound - 1 on the piece. That grows with the ratio, so the
/// lower end decides; if a piece before it ends there, the end itself belongs to that one.
bool is_below_paper(const collisions::Piece& piece, bool first) {
    const bool closed = first || piece.q_lo == piece.q_hi;
    return *piece.upper <=
           (closed ? flight::paper_bound(piece.q_lo) : flight::paper_bound_behind(piece.q_lo)) - 1;
}

/// Takes the greater (sign = 1) or the lesser (-1) of what is known and a new value.
class Best {
  public:
    explicit Best(int sign) : sign_(sign) {}

    void take(const BigInterval& value, const Rational& at, bool occurs) {
        if (!outer_ || is_beyond(value, *outer_)) {
            outer_ = value;
        }
        if (occurs && (!inner_ || is_beyond(value, *inner_))) {
            inner_ = value;
            at_ = at;
        }
    }
    [[nodiscard]] std::optional<Extremum> result() const {
        return inner_ ? std::optional(Extremum{*inner_, *outer_, at_, {}}) : std::nullopt;
    }

  private:
    /// By the ends on the far side: of two enclosures that overlap either may stay as inner one, the one that
    /// reaches further stays as outer one.
    [[nodiscard]] bool is_beyond(const BigInterval& a, const BigInterval& b) const {
        return sign_ > 0 ? certainly_less(high_end(b), high_end(a)) : certainly_less(low_end(a), low_end(b));
    }

    int sign_;
    std::optional<BigInterval> inner_, outer_;
    Rational at_;
};

/// Whether the supremum of N - C sqrt q is attained, from its enclosures at the pieces' lower ends, with N's
/// upper bound. Where N is constant that falls, and at a step N has the lower of its values (theorem 2): so
/// only the value at the lowest ratio can be the supremum, and it is unless a greater one is approached.
std::optional<bool> supremum_attained(const std::vector<collisions::Piece>& pieces,
                                      const std::vector<BigInterval>& highest) {
    const BigInterval& lowest_ratio = highest.front();
    bool all_less = pieces.front().status() == collisions::Status::exact;
    for (std::size_t i = 1; i < pieces.size(); ++i) {
        if (pieces[i].status() == collisions::Status::exact && certainly_less(lowest_ratio, highest[i])) {
            return false;
        }
        all_less = all_less && certainly_less(highest[i], lowest_ratio);
    }
    return all_less ? std::optional(true) : std::nullopt;
}

}  // namespace

Law law_of(const collisions::Certificate& certificate) {
    Law law;
    law.q_lo = certificate.q_lo();
    law.q_hi = certificate.q_hi();
    law.constant = flight::growth_constant();
    law.complete = std::none_of(
        certificate.pieces.begin(), certificate.pieces.end(),
        [](const collisions::Piece& piece) { return piece.status() == collisions::Status::open; });
    if (!law.complete) {
        return law;
    }
    law.never_decreases = law.below_paper = true;
    law.first = {certificate.pieces.front().lower, *certificate.pieces.front().upper};
    law.last = {certificate.pieces.back().lower, *certificate.pieces.back().upper};
    const auto excess = [&](long n, const Rational& q) {
        return BigInterval(static_cast<double>(n)) - law.constant * sqrt(enclose<BigInterval>(q));
    };
    std::vector<BigInterval> highest;
    Best sup(1);
    Best inf(-1);
    long before = 0;  // the upper bound of the piece before
    for (const collisions::Piece& piece : certificate.pieces) {
        const bool exact = piece.status() == collisions::Status::exact;
        ++(exact ? law.values : law.gaps);
        law.never_decreases = law.never_decreases && piece.lower >= before;
        before = *piece.upper;
        law.below_paper = law.below_paper && is_below_paper(piece, &piece == certificate.pieces.data());
        highest.push_back(excess(*piece.upper, piece.q_lo));
        sup.take(highest.back(), piece.q_lo, exact);
        inf.take(excess(piece.lower, piece.q_hi), piece.q_hi, exact);
    }
    law.sup = sup.result();
    law.inf = inf.result();
    if (law.sup) {
        law.sup->attained = supremum_attained(certificate.pieces, highest);
    }
    return law;
}

}  // namespace dumbbell::staircase
