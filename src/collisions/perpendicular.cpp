#include "collisions/perpendicular.hpp"

#include <algorithm>
#include <cmath>

#include "file/limits.hpp"
#include "flight/corner.hpp"
#include "flight/outward.hpp"

namespace dumbbell::collisions {
namespace {

using flight::Ray;

/// The places (0, hi) where something is not yet so, and from some place on is: the ends of a short stretch
/// between them, or of one with the same count at both. A guess; `is_so` is asked about it again.
template <class I, class IsSo, class Count>
std::pair<Rational, Rational> threshold(double end, const IsSo& is_so, const Count& count) {
    constexpr int by_magnitude = 12, often = 6;  // a count costs about as much as what is asked
    const int bits = bits_of<I>(), least_place = std::min(bits, 900);  // a double is not 0 there
    Rational lo = 0, hi = exact(end);
    for (int i = 1; i < (lo == 0 ? least_place / 3 : bits + by_magnitude); ++i) {
        const Rational middle = lo == 0       ? hi / 8
                                : hi > 4 * lo ? exact(std::sqrt(Rational(lo * hi).convert_to<double>()))
                                              : (lo + hi) / 2;
        (is_so(enclose<I>(middle)) ? hi : lo) = middle;
        if (i % often == 0 && count(enclose<I>(lo)) == count(enclose<I>(hi))) {
            break;
        }
    }
    return {lo, hi};
}

/// The shortest dyadic near p > 0, below or above, that is as good: files spell it.
template <class I, class IsGood>
Rational shortest(const Rational& p, bool above, const IsGood& is_good) {
    const int depth = -std::ilogb(p.convert_to<double>());
    for (int places = 2; places < bits_of<I>(); places += 2) {
        const Rational step = power_of_half(places + depth), steps = p / step,
                       shorter = step * (numerator(steps) / denominator(steps) + (above ? 1 : 0));
        if (is_good(enclose<I>(shorter))) {
            return shorter;
        }
    }
    return p;
}

/// ceil(pi/corner); of more than most_in_corner a guess.
long in_corner(const Rational& rho, const Rational& q) {
    if (const long near = flight::corner_count(rho, q, most_in_corner); near <= most_in_corner) {
        return near;
    }
    const double l = rho.convert_to<double>(), r = 1 / q.convert_to<double>(),
                 corner = std::atan2((1 + l) * std::sqrt(r), l - r);
    return static_cast<long>(std::ceil(half_pi<Interval>().hi() * 2 / corner));
}

/// A side of a rectangle: all rho, one Q.
template <class I>
class Edge {
  public:
    Edge(const Rectangle& bodies, const Rational& q, const Interrupted& interrupted)
        : least_(enclose<I>(bodies.rho.lo)),
          greatest_(enclose<I>(bodies.rho.hi)),
          r_(enclose<I>(1 / q)),
          cap_(static_cast<long>(2 * std::sqrt(q.convert_to<double>())) + 10),  // L84 (a)
          interrupted_(interrupted) {}

    /// k0 and the even motion of Theorem B, from below.
    [[nodiscard]] long top() const { return count({high_end(greatest_), I(0), high_end(r_)}); }
    [[nodiscard]] long through_corner() const {
        const Ray<I> along{I(0), high_end(greatest_), high_end(r_)};
        const auto out = flight::reflect_at_light_wall(high_end(-least_), I(1), high_end(r_));
        if (!certainly_positive(out.denominator)) {
            return 0;
        }
        const Ray<I> even{I(0), high_end(out.numerator / out.denominator), high_end(r_)};
        return std::min(count(flight::over_bridge(along)), count(flight::over_bridge(even)));
    }
    /// f(e_j) of all, from below, if j <= J.
    [[nodiscard]] std::pair<long, Rational> orbit_from_below(long j) const {
        const auto collisions = [&](const I& p) {
            const auto behind = flight::outward_from_above(j, p, least_, r_);
            return behind ? count(flight::over_bridge(*behind)) : -1;
        };
        const Rational p = least_passing(j, collisions);
        const long found = passes(j, enclose<I>(p)) ? collisions(enclose<I>(p)) : -1;
        const auto is_good = [&](const I& x) { return passes(j, x) && collisions(x) == found; };
        return {found, shortest<I>(p, true, is_good)};
    }
    /// About e_j, where the orbit that just passes touches the bridge; the top for j = 0.
    [[nodiscard]] I touching_place(long j) const {
        const auto any = [](const I&) { return std::nan(""); };  // equal to nothing: as close as can be
        const auto behind =
            j > 0 ? flight::outward_from_below(j, enclose<I>(least_passing(j, any)), greatest_, r_)
                  : std::nullopt;
        return half_pi<I>() - (behind ? asin(behind->kappa / greatest_) : I(0));
    }

    /// k0, and f(e_j) of all that have so many hits in the valley, each from above; most + 1: it is not
    /// certain that it is at most `most`.
    [[nodiscard]] long top_at_most(long most) const {
        return at_most({low_end(least_), I(0), low_end(r_)}, most);
    }
    [[nodiscard]] std::pair<long, Rational> orbit_from_above(long j, long most) const {
        const auto misses = [&](const I& p) {
            const auto behind = interrupted_() ? std::nullopt : flight::outward_from_above(j, p, least_, r_);
            return !behind || !flight::contact_from_above(*behind, least_);
        };
        const auto collisions = [&](const I& p) {
            const auto behind = flight::outward_from_below(j, p, greatest_, r_);
            return behind ? at_most(flight::over_bridge(*behind), most) : most + 1;
        };
        const Rational p = threshold<I>(least_.lo(), misses, collisions).first;
        const long found = collisions(enclose<I>(p));
        const auto is_good = [&](const I& x) { return !misses(x) && collisions(x) <= found; };
        return {found, p == 0 ? p : shortest<I>(p, false, is_good)};
    }
    /// Whether J is certainly at most `hits`, and T, from above, if it is.
    [[nodiscard]] bool corner_hits_at_most(long hits) const {
        return flight::corner_hits_at_most(hits, greatest_, r_, interrupted_);
    }
    [[nodiscard]] long even_at_most(long hits, long most) const {
        return flight::even_at_most(hits, greatest_, r_, most, interrupted_);
    }

  private:
    /// About where the orbit (j, p) begins to pass the bridge.
    template <class Count>
    [[nodiscard]] Rational least_passing(long j, const Count& count) const {
        // R is as high as 1 for all of them, the bridge only as the least one's.
        const double hi = j % 2 != 0 ? greatest_.hi() : least_.lo();
        return threshold<I>(
                   hi, [&](const I& p) { return passes(j, p, true); }, count)
            .second;
    }
    [[nodiscard]] bool passes(long j, const I& p, bool if_there_is_none = false) const {
        const auto behind = interrupted_() ? std::nullopt : flight::outward_from_below(j, p, greatest_, r_);
        return behind ? !flight::contact_from_below(*behind, greatest_) : if_there_is_none;
    }
    [[nodiscard]] long count(const Ray<I>& highest) const {
        return as_long(count_at_least(highest, cap_, interrupted_));
    }
    [[nodiscard]] long at_most(const Ray<I>& lowest, long most) const {
        return as_long(count_at_most(lowest, most, interrupted_));
    }

    I least_, greatest_, r_;
    long cap_;
    const Interrupted& interrupted_;
};

}  // namespace

template <class I>
LowerBound least_collisions(const Rectangle& bodies, const Interrupted& interrupted) {
    const Edge<I> edge(bodies, bodies.q.lo, interrupted);
    const long near = in_corner(bodies.rho.lo, bodies.q.lo);
    LowerBound best{near};
    const auto take = [&best](const LowerBound& found) { best = found.bound > best.bound ? found : best; };
    take({1 + 2 * edge.top()});
    take({2 + 2 * edge.through_corner()});
    const long hits = (near - 1) / 2;
    for (const long j : {1L, hits}) {  // seen: others have no more (body.md)
        if (j > 0 && j <= hits) {
            const auto [beyond, p] = edge.orbit_from_below(j);
            take({2 * j + 1 + 2 * beyond, j, p});
        }
    }
    return best;
}

template <class I>
std::optional<UpperBound> at_most(long upper, const Rectangle& bodies, const Interrupted& interrupted) {
    const Edge<I> edge(bodies, bodies.q.hi, interrupted);
    const long near = in_corner(bodies.rho.hi, bodies.q.hi), half = (upper - 1) / 2;
    const bool is_known = near <= most_in_corner;
    UpperBound found{(near + 1) / 2};
    if (!is_known && !edge.corner_hits_at_most(found.end - 1)) {
        return std::nullopt;
    }
    long beyond = bodies.rho.lo == 1 ? 0 : edge.top_at_most(half);
    if (beyond > half) {
        return std::nullopt;
    }
    for (long x = half + 1 - beyond; x < found.end; x = half + 1 - beyond) {
        const auto [collisions, p] = edge.orbit_from_above(x, half - x);
        if (collisions > half - x) {
            return std::nullopt;
        }
        found.orbits.emplace_back(x, p);
        beyond = collisions;
    }
    const long last = half + 1 - found.end;
    const bool may_be_even =
        upper % 2 == 1 && (!is_known || near % 2 == 0) && edge.even_at_most(found.end - 1, last) >= last;
    return may_be_even ? std::nullopt : std::optional(found);
}

template <class I>
Rational touching_place(long j, const Rational& rho, const Rational& q) {
    return exact_lo(Edge<I>({{rho, rho}, {q, q}}, q, never).touching_place(j));
}

template LowerBound least_collisions<Interval>(const Rectangle&, const Interrupted&);
template LowerBound least_collisions<BigInterval>(const Rectangle&, const Interrupted&);
template std::optional<UpperBound> at_most<Interval>(long, const Rectangle&, const Interrupted&);
template std::optional<UpperBound> at_most<BigInterval>(long, const Rectangle&, const Interrupted&);
template Rational touching_place<Interval>(long, const Rational&, const Rational&);
template Rational touching_place<BigInterval>(long, const Rational&, const Rational&);

}  // namespace dumbbell::collisions
