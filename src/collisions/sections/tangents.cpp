#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "collisions/chart.hpp"
#include "collisions/names.hpp"
#include "collisions/section.hpp"
#include "collisions/witness.hpp"
#include "flight/certain_count.hpp"
#include "flight/corner.hpp"
#include "flight/valley.hpp"

/// Every rigid body, by Theorem B (body.md): the two tangents of the bridge, over a tree of their places e.
namespace dumbbell::collisions {
namespace {

using flight::Bounce;
using flight::Ray;

/// One body, as its counts need it; rho and r enclose it.
template <class I>
class Tangents {
  public:
    Tangents(const Rational& rho, const Rational& q, const Interrupted& interrupted)
        : rho_(enclose<I>(rho)), r_(enclose<I>(1 / q)), is_symmetric_(rho == 1), interrupted_(interrupted) {}

    /// Upper bounds of f(e) and b(e), of k1 and J at e = 0, each at most cap + 1 (L81, L82).
    [[nodiscard]] long upward(const I& e, long cap) const {
        return is_symmetric_                     ? 0  // over the top all is as high as the peaks
               : certainly_less(e, half_pi<I>()) ? count(flight::tangent_upward(e, rho_, r_), cap)
                                                 : count({low_end(rho_), I(0), low_end(r_)}, cap);
    }
    [[nodiscard]] long into_valley(const I& e, long cap) const {
        return flight::valley_hits_at_most(flight::tangent_into_valley(e, rho_, r_), rho_, cap, interrupted_);
    }
    /// The same of T if J is `hits`.
    [[nodiscard]] long even(long hits, long cap) const {
        Ray<I> ray = flight::tangent_into_valley(I(0), rho_, r_);
        for (long bounces = 0; bounces <= 2 * hits; ++bounces) {
            if (ends_early(bounces, interrupted_)) {
                return cap + 1;
            }
            const Bounce bounce = bounce_from_below(ray, bounces % 2 == 0 ? I(1) : rho_);
            if (bounce != Bounce::returns) {
                return bounce == Bounce::undecided ? cap + 1 : 0;
            }
        }
        return count({low_end(pi<I>() * ray.kappa), ray.kappa, low_end(r_)}, cap);
    }

  private:
    [[nodiscard]] long count(const Ray<I>& ray, long cap) const {
        return as_long(count_at_most(ray, cap, interrupted_));
    }

    I rho_, r_;
    bool is_symmetric_;
    const Interrupted& interrupted_;
};

/// Whether ceil(pi/corner) >= n, exactly where that is not too long; else true.
bool may_have_in_corner(long n, const Rational& rho, const Rational& q) {
    return n > most_in_corner || flight::corner_count(rho, q, n) >= n;
}

/// J from above, and exactly where the corner's count is not too long: beside a tie no precision tells it.
template <class I>
long corner_hits(const Tangents<I>& of, const Rational& rho, const Rational& q, long cap) {
    const long hits = of.into_valley(I(0), cap);
    return may_have_in_corner(2 * hits + 1, rho, q) ? hits
                                                    : (flight::corner_count(rho, q, 2 * hits + 1) - 1) / 2;
}

/// L82, of the places [e0, e1]: f(e1) and b(e0), or at the corner J, and there the even value of Theorem B.
template <class I>
std::optional<Leaf> judge_tangent(const Box& box, const Count& most, const Interrupted& interrupted) {
    const auto& [position, slope, ratio] = box.sides;
    const I begin = position.lo.template enclosure<I>();
    if (certainly_less(half_pi<I>(), begin)) {
        return Leaf{Reason::outside};
    }
    const long upper = as_long(most), half = (upper - 1) / 2;
    const Rational rho = box.rho, q = ratio.hi;
    const Tangents<I> of(rho, q, interrupted);
    const long up = of.upward(position.hi.template enclosure<I>(), half), room = half - up;
    if (up > half) {
        return std::nullopt;
    }
    const bool at_corner = approximate(position.lo) == 0;
    long down = of.into_valley(begin, room);
    if (down > room && (!at_corner || may_have_in_corner(2 * room + 3, rho, q))) {
        return std::nullopt;
    }
    down = std::min(down, room);
    const bool may_be_even = at_corner && upper % 2 == 1 && of.even(down, room) > half - down - 1 &&
                             may_have_in_corner(2 * down + 2, rho, q);
    return may_be_even ? std::nullopt : std::optional(Leaf{Reason::count, up, down});
}

/// Just below pi/2.
Rational quarter() { return exact_lo(half_pi<BigInterval>()); }

/// Where f + b seems to be as great as anywhere, or at least `enough`.
struct Best {
    long total = 0, hits = 0;
    Rational e = 0;
};

/// As many as this arithmetic tells places apart with.
template <class I>
int bits_of() {
    return std::is_same_v<I, Interval> ? double_bits : PrecisionScope::current();
}

/// In between, by magnitude where that differs.
Rational middle_place(const Rational& lo, const Rational& hi) {
    return lo == 0       ? hi / 1024
           : hi > 4 * lo ? exact(std::sqrt(Rational(lo * hi).convert_to<double>()))
                         : (lo + hi) / 2;
}

/// f does not decrease and b does not increase, so f at the end and b at the beginning bound the sum.
template <class I>
Best best_tangent(const Tangents<I>& of, long corner, long cap, long enough, const Interrupted& interrupted) {
    const Rational least = power_of_half(bits_of<I>() - 10), narrow = power_of_half(bits_of<I>() - 4);
    struct Part {
        Rational lo, hi;
        long up_lo, down_lo, up_hi, down_hi;
    };
    const long top_up = of.upward(I(2), cap), corner_up = of.upward(I(0), cap);
    Best best =
        corner + corner_up > top_up ? Best{corner + corner_up, corner, least} : Best{top_up, 0, quarter()};
    std::vector<Part> todo{{0, quarter(), corner_up, corner, top_up, 0}};
    while (!todo.empty() && best.total < enough && !interrupted()) {
        const Part part = std::move(todo.back());
        todo.pop_back();
        const Rational middle = middle_place(part.lo, part.hi);
        if (part.up_hi + part.down_lo <= best.total || middle < least ||
            part.hi - part.lo < narrow * part.hi) {
            continue;
        }
        const I e = enclose<I>(middle);
        const long up = of.upward(e, cap), down = of.into_valley(e, cap);
        if (up + down > best.total) {
            best = {up + down, down, middle};
        }
        todo.push_back({part.lo, middle, part.up_lo, part.down_lo, up, down});
        todo.push_back({middle, part.hi, up, down, part.up_hi, part.down_hi});
    }
    return best;
}

/// More than any motion has: L84 (a), about.
long more_than_all(const Rational& q) {
    return static_cast<long>(2 * std::sqrt(q.convert_to<double>())) + 10;
}

template <class I>
std::optional<Count> body_maximum(const Rational& q, const System& system, const Interrupted& interrupted) {
    const Rational& rho = *system.rho;
    const Tangents<I> of(rho, q, interrupted);
    const long cap = more_than_all(q), corner = corner_hits(of, rho, q, cap), least = of.upward(I(0), cap),
               even = 2 * corner + 2 + 2 * least,
               most = 1 + 2 * best_tangent(of, corner, cap, cap, interrupted).total;
    const bool is_even =
        even > most && of.even(corner, cap) >= least && may_have_in_corner(2 * corner + 2, rho, q);
    return interrupted() ? std::nullopt : std::optional(Count(is_even ? even : most));
}

/// The greatest dyadic of so many places at which the tangent seems to have `hits` in the valley.
template <class I>
Rational last_place(const Tangents<I>& of, Rational lo, long hits) {
    Rational step = 1;
    for (int place = 0; place < bits_of<I>(); ++place, step /= 2) {
        const Rational next = lo + step;
        if (next < quarter() && of.into_valley(enclose<I>(next), hits) >= hits) {
            lo = next;
        }
    }
    return lo;
}

template <class I>
std::optional<Witness> contact(const Rational& e, const Rational& eta, const flight::Body<I>& body,
                               long target) {
    const auto rays = contact_rays(enclose<I>(e), enclose<I>(eta), body);
    const long forward = certain_count(rays.outgoing, body, target - 1),
               backward = certain_count(rays.reversed, body, target - 1 - forward);
    return 1 + forward + backward >= target ? std::optional(Witness{e, eta, forward, backward})
                                            : std::nullopt;
}

template <class I>
std::optional<Witness> body_witness(const Range& range, const Count& wanted, const System& system,
                                    const Interrupted& interrupted) {
    const long target = as_long(wanted);
    if (target <= most_in_corner && flight::corner_count(*system.rho, range.lo, target) >= target) {
        return Witness{0, 0, target - 1, 0, Place::corner};
    }
    return contact_of_body<I>(range, target, system, interrupted);
}

template <class I>
constexpr BoundSearch<I> body_bounds{body_maximum<I>, nullptr, nullptr, body_witness<I>};

/// L72.
std::optional<Cover> symmetric_cover(const Range& range, const Count& upper, const System& system) {
    const bool holds = *system.rho == 1 && flight::corner_count(1, range.hi, most_in_corner) <=
                                               std::min(upper, Count(most_in_corner));
    return holds ? std::optional(Cover{.symmetric = true, .charts = {}}) : std::nullopt;
}

constexpr std::array tangent_charts{Chart::tangent};
constexpr std::array plain_body_charts{Chart::plain_contact, Chart::plain_departure};

}  // namespace

/// Just before a place where the tangent touches the bridge again, or close to the corner. It is of the least
/// Q; greater ones have as many (L83), which plain covers do not know.
template <class I>
std::optional<Witness> contact_of_body(const Range& range, long target, const System& system,
                                       const Interrupted& interrupted) {
    const Rational &q = range.lo, &rho = *system.rho;
    const Rational& greatest = system.section == Section::body ? q : range.hi;
    const Tangents<I> of(rho, q, interrupted);
    const auto body =
        flight::Body<I>::with_mass(enclose<I>(rho), hull(enclose<I>(1 / greatest), enclose<I>(1 / q)));
    const long cap = more_than_all(q);
    const Best best = best_tangent(of, corner_hits(of, rho, q, cap), cap, target / 2, interrupted);
    const Rational last = best.hits > 0 ? last_place(of, best.e, best.hits) : quarter();
    const int depth = -std::ilogb(last.convert_to<double>());
    for (int places = 8; places < bits_of<I>() && !interrupted(); places += 4) {
        const Rational step = power_of_half(places + depth), steps = last / step,
                       e = step * (numerator(steps) / denominator(steps) - 1);
        auto found = contact(e, step * power_of_half(depth + 6), body, target);
        found = found ? found : contact(power_of_half(2 * places), power_of_half(places), body, target);
        if (found) {
            return found;
        }
    }
    return std::nullopt;
}

template std::optional<Witness> contact_of_body<Interval>(const Range&, long, const System&,
                                                          const Interrupted&);

const ChartRow tangent_chart{.name = "tangent",
                             .position = "e",
                             .slope = {},
                             .greatest_position = 2,
                             .greatest_slope = 1,
                             .splits_position_only = true,
                             .judges = {judge_tangent<Interval>, judge_tangent<BigInterval>}};

constexpr SectionRow body_row{.scene = "body",
                              .section = "tangents",
                              .lemmas = "body",
                              .section_in_file = "tangents",
                              .hits = "motion of the body in a plane, without a corner, hits the floor",
                              .hits_it = "motion hits it",
                              .system = "The body",
                              .where = " of a body",
                              .title = "Greatest number of collisions of a rigid body against Q = (d1/k)^2",
                              .growth = "1.570796326794896619231321691640",
                              .most_digits = 12,  // there are no macro steps in the valley
                              .max_nodes = 2'000,
                              .charts = tangent_charts,
                              .step = nullptr,
                              .is_monotone = true,  // L83
                              .bounds = {body_bounds<Interval>, body_bounds<BigInterval>}};

/// The same of bodies with mass between their contacts, for who doubts the theorem.
const SectionRow plain_body_row = [] {
    SectionRow row = body_row;
    row.section = "plain";
    row.section_in_file = "full";
    row.kind_in_totals = symmetric_word;
    row.bits_to_verify = 0;
    row.max_bits = double_bits;  // what it leaves open is next to a tie
    row.max_nodes = 20'000'000;
    row.charts = plain_body_charts;
    row.is_monotone = false;
    row.by_lemma = symmetric_cover;
    return row;
}();

}  // namespace dumbbell::collisions
