#include "critical/bodies.hpp"

#include <array>
#include <cmath>
#include <utility>

#include "collisions/leaf.hpp"
#include "collisions/section.hpp"
#include "file/limits.hpp"
#include "flight/certain_count.hpp"
#include "flight/corner.hpp"
#include "flight/count.hpp"
#include "flight/extremal_orbit.hpp"
#include "flight/valley.hpp"
#include "number/decimal.hpp"

namespace dumbbell::critical {

using collisions::Claim;
using collisions::Witness;
using flight::Ray;

namespace {

using Big = BigInterval;

template <class I>
const collisions::BoundSearch<I>& body_bounds() {
    return std::get<collisions::BoundSearch<I>>(row_of(collisions::Section::body).bounds);
}

const Rational& rho_of(const Claim& body) { return *body.system.rho; }
const Rational& inertia_of(const Claim& body) { return body.range.lo; }

/// What seems to be N; nothing if interrupted.
template <class I = Interval>
std::optional<Count> guess_at(const Bodies& bodies, const Rational& t, const Options& options) {
    const Claim body = bodies.at(t);
    return body_bounds<I>().maximum(inertia_of(body), body.system, options.interrupted);
}

/// Ends of a bracket: the one with less than n collisions, the other with as many.
struct Ends {
    Rational less, more;
};

/// Seen from the corner: pi over its angle.
double turns_at(const Claim& body) {
    const double root = std::sqrt(inertia_of(body).convert_to<double>());
    return M_PI / (std::atan(1 / root) + std::atan(1 / (rho_of(body).convert_to<double>() * root)));
}

/// What seems to decide at a step: the corner, or a flight of one of the three motions of Theorem B.
struct Tie {
    enum class Kind { corner, top, tangent, even } kind;
    long hits = 0;    ///< of the bridge in the valley; of `corner` its copies in half a turn
    long flight = 0;  ///< from 1
    Rational e = 0;   ///< of `tangent`: its place, nearly
};

std::optional<Tie> tie_between(const Bodies& bodies, long n, const Ends& ends, const Options& options) {
    const Claim body = bodies.at(ends.more);
    const auto turns = static_cast<long>(std::ceil(turns_at(body)));
    if (static_cast<double>(turns - 1) >= turns_at(bodies.at(ends.less))) {
        return Tie{Tie::Kind::corner, turns - 1};
    }
    const auto found = body_bounds<Big>().witness(body.range, n, body.system, options.interrupted);
    if (!found || found->place == collisions::Place::corner) {
        return std::nullopt;
    }
    const long forward = as_long(found->forward), hits = (as_long(found->backward) - forward + 1) / 2;
    return found->eta > found->e ? Tie{Tie::Kind::even, turns / 2 - 1, (n - turns) / 2}
           : hits == 0           ? Tie{Tie::Kind::top, 0, forward}
                                 : Tie{Tie::Kind::tangent, hits, forward, found->e};
}

/// What vanishes at a step: how far the tangent is from the bridge where it comes back to it, and how far the
/// flight that decides is from the hump. Nearly: lower bounds are followed.
struct Margins {
    Big touch, flight;
};

std::optional<Margins> margins(const Tie& tie, const Rational& e, const Claim& body, const Options& options) {
    const Big rho = enclose<Big>(rho_of(body)), inertia = enclose<Big>(inertia_of(body)),
              r = Big(1) / inertia;
    const Big place = enclose<Big>(e);
    if (tie.kind == Tie::Kind::corner) {
        const auto arctangent = [](const Big& square) { return asin(sqrt(square / (Big(1) + square))); };
        const Big corner = pi<Big>() - arctangent(inertia) - arctangent(sqr(rho) * inertia);
        return Margins{place, pi<Big>() - Big(static_cast<double>(tie.hits)) * corner};
    }
    const bool is_tangent = tie.kind == Tie::Kind::tangent;
    Ray<Big> ray = is_tangent ? flight::tangent_into_valley(place, rho, r) : Ray<Big>{Big(0), -rho, r};
    const long bounces = is_tangent ? 2 * tie.hits - 1 : tie.kind == Tie::Kind::even ? 2 * tie.hits + 1 : 0;
    for (long i = 0; i < bounces; ++i) {
        if (bounce_from_below(ray, i % 2 == 0 ? Big(1) : rho) != flight::Bounce::returns) {
            return std::nullopt;
        }
    }
    const Ray<Big> left = is_tangent                    ? flight::tangent_upward(place, rho, r)
                          : tie.kind == Tie::Kind::even ? Ray<Big>{pi<Big>() * ray.kappa, ray.kappa, r}
                                                        : Ray<Big>{rho, Big(0), r};
    std::optional<Ray<Big>> last;
    (void)count_at_most(left, Count(tie.flight - 1), options.interrupted,
                        [&](const Count& count, const Big& c, const Big& kappa) {
                            if (count == tie.flight - 1) {
                                last = {c, kappa, r};
                            }
                        });
    if (!last || (is_tangent && !certainly_positive(ray.kappa))) {
        return std::nullopt;
    }
    return Margins{is_tangent ? margin(Ray<Big>{ray.c / rho, ray.kappa / rho, r}) : place, margin(*last)};
}

Rational some_of(const Big& x) { return exact_lo(midpoint(x)); }

/// By Newton steps with differences for derivatives: e of the tie, and t, to three quarters of the bits.
std::optional<Rational> refined(const Bodies& bodies, Tie& tie, Rational t, const Options& options) {
    constexpr int most_steps = 20;
    const int bits = PrecisionScope::current();
    const auto at = [&](const Rational& e, const Rational& number) {
        return margins(tie, e, bodies.at(number), options);
    };
    for (int i = 0; i < most_steps && t > 0; ++i) {
        const Rational small = power_of_half(bits / 2), by_t = t * small;
        const Rational by_e = tie.e == 0 ? small : tie.e * small;
        const auto here = at(tie.e, t), right = at(tie.e + by_e, t), above = at(tie.e, t + by_t);
        if (!here || !right || !above) {
            return std::nullopt;
        }
        const Big a = right->touch - here->touch, b = above->touch - here->touch,
                  c = right->flight - here->flight, d = above->flight - here->flight;
        const Big determinant = a * d - b * c;
        const Rational step =
            some_of((a * here->flight - c * here->touch) / determinant * enclose<Big>(by_t));
        tie.e -= some_of((d * here->touch - b * here->flight) / determinant * enclose<Big>(by_e));
        t = some_of(enclose<Big>(t - step));
        if (abs(step) < t * power_of_half(3 * bits / 4)) {
            return t;
        }
    }
    return std::nullopt;
}

/// The place where the tangent comes back to the bridge as a tangent: to about as many bits as there are.
std::optional<Rational> touching(const Claim& body, const Tie& tie, const Options& options) {
    if (tie.kind != Tie::Kind::tangent) {
        return std::nullopt;
    }
    Rational e = tie.e, by_e = e * power_of_half(PrecisionScope::current() / 2);
    for (int i = 0; i < 4; ++i) {
        const auto here = margins(tie, e, body, options), right = margins(tie, e + by_e, body, options);
        if (!here || !right) {
            return std::nullopt;
        }
        e -= some_of(here->touch / (right->touch - here->touch) * enclose<Big>(by_e));
    }
    return e;
}

/// L82, of places that are cut where the tangent is too high to touch the bridge, and too low to have the
/// flight, which may depend on the place alone: whether no motion has more.
bool has_at_most(const Claim& body, long most, const Tie& tie, const Options& options) {
    constexpr int most_boxes = 2000;
    collisions::Box box = root_box(collisions::Chart::tangent, inertia_of(body), inertia_of(body));
    box.rho = rho_of(body);
    const Rational between = (touching(body, tie, options).value_or(tie.e) + tie.e) / 2;
    std::vector<std::pair<Rational, Rational>> todo{{0, 2}};
    for (int boxes = 0; !todo.empty(); ++boxes) {
        if (boxes == most_boxes || options.interrupted()) {
            return false;
        }
        const auto [lo, hi] = std::move(todo.back());
        todo.pop_back();
        box[collisions::Axis::position] = {lo, hi};
        if (!collisions::judge<Big>(collisions::Chart::tangent, box, most, options.interrupted)) {
            const Rational cut = lo < between && between < hi ? between : (lo + hi) / 2;
            todo.insert(todo.end(), {{lo, cut}, {cut, hi}});
        }
    }
    return true;
}

/// A contact e, eta close to what Theorem B has in the limit.
Witness contact_near(const Claim& body, const Tie& tie, const Options& options) {
    const int bits = PrecisionScope::current();
    const Rational eta = power_of_half(7 * bits / 16);
    if (const auto last = touching(body, tie, options)) {
        // Where it misses a tangency by d it comes back with an angle like sqrt d.
        const Rational before = *last * power_of_half(bits - 64);
        return {*last - before, before / 1024};
    }
    const Rational away = power_of_half(bits / 4);
    return {tie.kind == Tie::Kind::top ? exact_lo(half_pi<Big>()) - away : away, eta};
}

/// L74, of that contact; or L73, exactly, for it may be in a tie.
bool has_at_least(const Claim& body, long n, const Tie& tie, const Options& options) {
    if (n <= most_in_corner && flight::corner_count(rho_of(body), inertia_of(body), n) >= n) {
        return true;
    }
    const auto counted =
        flight::Body<Big>::with_mass(enclose<Big>(rho_of(body)), Big(1) / enclose<Big>(inertia_of(body)));
    const Witness near = contact_near(body, tie, options);
    const Big e = enclose<Big>(near.e), eta = enclose<Big>(near.eta);
    if (!certainly_positive(e) || !certainly_less(e, half_pi<Big>()) || !certainly_positive(eta)) {
        return false;
    }
    const auto rays = contact_rays(e, eta, counted);
    const long forward = certain_count(rays.outgoing, counted, n - 1);
    return forward + certain_count(rays.reversed, counted, n - 1 - forward) >= n - 1;
}

/// The same where no tie is near.
bool has_at_least(const Claim& body, long n, const Options& options) {
    const PrecisionScope scope(256);
    return body_bounds<Interval>().witness(body.range, n, body.system, options.interrupted) ||
           body_bounds<Big>().witness(body.range, n, body.system, options.interrupted);
}

/// Of a step between `below` and n, whose ends seem to be these.
struct Step {
    long below, n;
    Ends ends;
};

/// Between the decimals of so many digits that are next to t.
std::optional<Ratio> proved_near(const Rational& t, int digits, const Bodies& bodies, const Step& step,
                                 const Tie& tie, const Options& options) {
    const Decimal before = cut_down(t, digits);
    const Rational unit = exact(Decimal{1, before.exponent});
    for (const int shift : {0, 1, -1}) {  // t may be a decimal itself
        const Rational lo = exact(before) + shift * unit, hi = lo + unit;
        const Claim less = bodies.at(bodies.have_rods ? hi : lo),
                    more = bodies.at(bodies.have_rods ? lo : hi);
        if (shared_digits(lo, hi, options.digits) && has_at_most(less, step.below, tie, options) &&
            has_at_least(more, step.n, tie, options) && has_at_least(less, step.below, options) &&
            has_at_most(more, step.n, tie, options)) {
            return Ratio{
                .n = step.n, .q_lo = lo, .q_hi = hi, .bits = PrecisionScope::current(), .below = step.below};
        }
    }
    return std::nullopt;
}

/// To so many bits.
template <class I>
std::optional<Ends> narrowed(const Bodies& bodies, long n, Ends ends, int bits, const Options& options) {
    while (abs(ends.more - ends.less) > ends.more * power_of_half(bits)) {
        const bool is_far = ends.more > 2 * ends.less || ends.less > 2 * ends.more;
        const Rational middle = is_far
                                    ? exact(std::sqrt(Rational(ends.less * ends.more).convert_to<double>()))
                                    : (ends.less + ends.more) / 2;
        const auto most = guess_at<I>(bodies, middle, options);
        if (!most) {
            return std::nullopt;
        }
        (*most < n ? ends.less : ends.more) = middle;
    }
    return ends;
}

std::optional<Ratio> enclose_at(const Bodies& bodies, const Step& step, const Options& options) {
    const auto seen = tie_between(bodies, step.n, step.ends, options);
    for (int bits = 192 + 8 * options.digits; seen && bits <= most_bits && !options.interrupted();
         bits *= 2) {
        const PrecisionScope scope(bits);
        Tie tie = *seen;
        const auto t = refined(bodies, tie, step.ends.more, options);
        for (int more = 2; t && more < 20; more += 6) {  // more, if it is close to a decimal
            if (auto ratio = proved_near(*t, options.digits + more, bodies, step, tie, options)) {
                return ratio;
            }
        }
    }
    return std::nullopt;
}

/// The step to n between these ends, or where N leaps over it.
std::optional<Ratio> enclose_between(const Bodies& bodies, long n, const Ends& far, const Options& options) {
    const PrecisionScope scope(256);
    constexpr int few = 26, more = 60;
    auto ends = narrowed<Interval>(bodies, n, far, few, options);
    for (const int bits : {few, more}) {
        ends = ends && bits == more ? narrowed<Big>(bodies, n, *ends, bits, options) : ends;
        const auto below = ends ? guess_at<Big>(bodies, ends->less, options) : std::nullopt,
                   above = below ? guess_at<Big>(bodies, ends->more, options) : std::nullopt;
        auto ratio =
            above ? enclose_at(bodies, {as_long(*below), as_long(*above), *ends}, options) : std::nullopt;
        if (ratio) {
            return ratio;
        }
    }
    return std::nullopt;
}

}  // namespace

Claim Bodies::at(const Rational& t) const {
    return have_rods ? claim_of(collisions::Rod{number, t})
                     : Claim{.range = {t, t}, .system = {collisions::Section::body, number}};
}

std::optional<Ratio> enclose_inertia(const Bodies& bodies, long n, const Options& options) {
    Ends far{1, 1};
    auto most = guess_at(bodies, 1, options);
    for (; most && *most < n; most = guess_at(bodies, far.more, options)) {
        far.more *= 4;
    }
    for (most = guess_at(bodies, 1, options); most && *most >= n;
         most = guess_at(bodies, far.less, options)) {
        far.less /= 4;
    }
    return most ? enclose_between(bodies, n, far, options) : std::nullopt;
}

std::vector<Row> enclose_falls(const Bodies& bodies, const Options& options) {
    const Rational greatest = 2048;
    std::vector<Row> falls;
    Rational mass = power_of_half(60);
    for (auto most = guess_at(bodies, mass, options); mass < greatest; mass *= 2) {
        const auto next = guess_at(bodies, 2 * mass, options);
        while (most && next && *most > *next) {
            falls.push_back(
                {as_long(*most), enclose_between(bodies, as_long(*most), {2 * mass, mass}, options)});
            const auto& fall = falls.back().ratio;
            most = fall ? std::optional(Count(fall->below)) : std::nullopt;
        }
        if (!most || !next) {
            falls.push_back({});
            break;
        }
        most = next;
    }
    return falls;
}

}  // namespace dumbbell::critical
