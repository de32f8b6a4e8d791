#include "flight/macro/orbit_guess.hpp"

#include <algorithm>
#include <cmath>

#include "base/ended_early.hpp"

namespace dumbbell::flight::macro {
namespace {

/// Coefficients without radii.
class Terms {
  public:
    explicit Terms(slong size) : size_(size), terms_(_arb_vec_init(size)) {}
    Terms(const Terms&) = delete;
    Terms& operator=(const Terms&) = delete;
    ~Terms() { _arb_vec_clear(terms_, size_); }

    arb_ptr operator[](slong i) { return terms_ + i; }
    void set(slong i, const Ball& x) {
        arb_set(terms_ + i, x.raw());
        mag_zero(arb_radref(terms_ + i));
    }
    [[nodiscard]] Ball operator()(slong i) const { return Ball(terms_ + i); }
    [[nodiscard]] Series series() const {
        Series result;
        for (slong i = size_ - 1; i >= 0; --i) {
            arb_poly_set_coeff_arb(result.raw(), i, terms_ + i);
        }
        return result;
    }
    /// The sum of a_j b_(i-j) over j from `first` to i.
    static Ball product(const Terms& a, const Terms& b, slong i, slong first = 0) {
        Ball result;
        arb_approx_dot(result.raw(), nullptr, 0, a.terms_ + first, 1, b.terms_ + i - first, -1, i - first + 1,
                       bits());
        return result;
    }

  private:
    slong size_;
    arb_ptr terms_;
};

/// The power series at s = 0 of the flow that the collisions follow,
///     cos x  dx/ds = A kappa (2 x + pi) + f,    (cos^2 x - r) dkappa/ds = 2 A cos x (r + kappa^2) + g,
/// A = collisions/2, from x(0), kappa(0).
Orbit follow_flow(const Task& task, const Ball& x0, const Ball& kappa0, const Series& f, const Series& g) {
    const slong n = task.terms;
    const Ball half_length = middle(whole(task.collisions) * Ball(0.5));
    Terms x(n), kappa(n), sine(n), cosine(n), dx(n), dkappa(n), reach(n), w2(n), push(n);
    x.set(0, x0);
    kappa.set(0, kappa0);
    arb_sin_cos(sine[0], cosine[0], x0.raw(), bits());
    sine.set(0, sine(0));
    cosine.set(0, cosine(0));
    for (slong i = 0;; ++i) {
        go_on(task.interrupted);
        const Ball start(i == 0 ? 1. : 0.);
        reach.set(i, Ball(2) * x(i) + start * pi());
        w2.set(i, Terms::product(cosine, cosine, i) - start * task.r);
        push.set(i, half_length * (Terms::product(kappa, kappa, i) + start * task.r));
        if (i + 1 == n) break;
        const Ball next = whole(i + 1);
        const Ball climb = half_length * Terms::product(kappa, reach, i) + f[i];
        sine.set(i + 1, climb / next);
        dx.set(i, (climb - (i > 0 ? Terms::product(cosine, dx, i, 1) : Ball())) / cosine(0));
        x.set(i + 1, dx(i) / next);
        const Ball turn = Ball(2) * Terms::product(cosine, push, i) + g[i];
        dkappa.set(i, (turn - (i > 0 ? Terms::product(w2, dkappa, i, 1) : Ball())) / w2(0));
        kappa.set(i + 1, dkappa(i) / next);
        cosine.set(i + 1, Ball(-1) * Terms::product(dx, sine, i) / next);
    }
    return {x.series(), kappa.series(), sine.series(), cosine.series()};
}

Series without_radii(Series p) {
    for (slong i = 0; i < p.raw()->length; ++i) {
        mag_zero(arb_radref(p.raw()->coeffs + i));
    }
    return p;
}
/// p(s + h/collisions), but for its third power.
Series moved(const Series& p, double h, const Task& task) {
    const Ball by = Ball(h) / whole(task.collisions);
    const Series slope = p.derivative();
    return without_radii(p + slope.times(by) + slope.derivative().times(by * by * Ball(0.5)));
}
/// p(s - 1).
Series from_the_start(const Series& p) {
    Series result;
    arb_poly_taylor_shift(result.raw(), p.raw(), Ball(-1).raw(), bits());
    return without_radii(std::move(result));
}

/// The slope before the collision at s = -1 that makes task.kappa the one after it, with f and g from there.
Ball first_kappa(const Task& task, const Series& f, const Series& g) {
    Task few = task;
    few.terms = 3;
    Ball kappa = middle(task.kappa);
    for (int i = 0; i < 100; ++i) {
        const Orbit begin = follow_flow(few, middle(task.x), kappa, f, g);
        const Ball missed = middle(task.kappa - moved(begin.kappa, 1, task)[0]);
        kappa = middle(kappa + missed);
        if (!positive(greatest_size(missed) - greatest_size(kappa) * power_of_two(2 - bits()))) break;
    }
    return kappa;
}

/// The flow with f and g, from task.x and task.kappa at s = -1. For its slope half a collision counts: with
/// that it is the same forwards and backwards, as the collisions are, and misses them by the square of
/// 1/collisions.
Orbit follow_collisions(const Task& task, const Series& f, const Series& g) {
    const Series f0 = from_the_start(f);
    const Series g0 = from_the_start(g);
    const Orbit begin = follow_flow(task, middle(task.x), first_kappa(task, f0, g0), f0, g0);
    Orbit orbit = follow_flow(task, middle(begin.x.at(Ball(1))), middle(begin.kappa.at(Ball(1))), f, g);
    orbit.kappa = moved(orbit.kappa, 1, task);
    return orbit;
}

/// The orbit with x and kappa moved, by so little that its square does not count, to where it is to begin.
Orbit settled(const Orbit& orbit, const Task& task) {
    const Ball x = middle(task.x - orbit.x.at(Ball(-1)));
    const Ball kappa = middle(task.kappa - orbit.kappa.at(Ball(-1)));
    return {orbit.x.plus(x), orbit.kappa.plus(kappa), without_radii(orbit.sine + orbit.cosine.times(x)),
            without_radii(orbit.cosine - orbit.sine.times(x))};
}

double right_bits(const Ball& wrong, double unit) { return -std::log2(std::abs(approximate(wrong)) / unit); }

}  // namespace

std::optional<Orbit> guess_orbit(const Task& task) {
    // Bits of the excess: a sweep finds 2 log k more of them, a few less to be sure, and needs some to spare.
    // Nearer the peak the first one has more, for the orbit is nearer to that of a ball that falls.
    constexpr double spare = 24;
    const double root = std::sqrt(approximate(task.r));
    const double of_k = std::log2(static_cast<double>(task.collisions));
    const double won = 2 * of_k - 8;
    const double wanted = right_bits(task.x_excess, 1) + 3;
    const double small =
        std::max(0., -std::log2(root) - of_k);  // so many bits are both sides' terms less than 1
    double known = 1.5 * small;
    double first = 0;
    const int full = PrecisionScope::current();
    Series f, g;  // a flow with f and g exceeds the collisions by about as much
    f.set(0, task.x_excess);
    g.set(0, task.kappa_excess);
    for (int sweep = 0; sweep < 60; ++sweep) {
        const bool last = known + won >= wanted;
        const double enough = std::max(64., known + 2 * won + spare - small);
        const int work = last || enough > full ? full : static_cast<int>(enough);
        const PrecisionScope scope(work);
        Task now = task;
        now.terms = 4 + (task.terms - 4) * work / full;
        const Orbit orbit = follow_collisions(now, f, g);
        if (last) {
            return settled(orbit, task);
        }
        Excess found = excess(orbit, now, now.terms - 1, {});
        found.height = without_radii(found.height.plus(Ball(-1) * task.x_excess));
        found.slope = without_radii(found.slope.plus(Ball(-1) * task.kappa_excess));
        const double before = known;
        known = std::min({right_bits(size_from(found.height, 0), 1),
                          right_bits(size_from(found.slope, 0), root), work + small - spare - won + 8});
        if (!std::isfinite(known) || (sweep > 0 && known < before + 2)) return std::nullopt;
        first = sweep == 0 ? known : first;
        // Beyond that degree there is nothing but rounding.
        const slong degree = static_cast<slong>(std::max(0., known - first + won + 8) / 2) + 4;
        arb_poly_truncate(found.height.raw(), degree);
        arb_poly_truncate(found.slope.raw(), degree);
        f = without_radii(f - moved(found.height, -1, now));
        g = without_radii(g - moved(found.slope, -2, now));
    }
    return std::nullopt;
}

}  // namespace dumbbell::flight::macro
