#include "flight/macro/orbit_guess.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

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

/// The flow from s = -1 to 0 in double, by the distance from the peak.
struct Point {
    double depth, kappa;  ///< pi/2 - x, slope
};
Point flow_in_double(const Task& task, Point at) {
    constexpr int steps = 64;
    const double half_length = static_cast<double>(task.collisions) / 2;
    const double r = approximate(task.r);
    const auto rate = [&](const Point& p) -> Point {
        const double w = std::sin(p.depth);
        return {-half_length * p.kappa * 2 * (std::numbers::pi - p.depth) / w,
                2 * half_length * w * (r + p.kappa * p.kappa) / (w * w - r)};
    };
    const auto moved = [](const Point& p, const Point& v, double h) -> Point {
        return {p.depth + h * v.depth, p.kappa + h * v.kappa};
    };
    constexpr double h = 1. / steps;
    for (int i = 0; i < steps; ++i) {
        const Point a = rate(at);
        const Point b = rate(moved(at, a, h / 2));
        const Point c = rate(moved(at, b, h / 2));
        const Point d = rate(moved(at, c, h));
        at = moved(moved(moved(moved(at, a, h / 6), b, h / 3), c, h / 3), d, h / 6);
    }
    return at;
}

/// How the state at s = 0 moves with the state at s = -1: derivatives of (x, kappa) by (x, kappa).
struct Response {
    Point middle;
    std::array<std::array<double, 2>, 2> by;
};
Response response(const Task& task, const Point& start) {
    constexpr double part = 3e-5;
    Response result{flow_in_double(task, start), {}};
    const std::array<Point, 2> nudge{{{-start.depth * part, 0}, {0, result.middle.kappa * part}}};
    for (std::size_t i = 0; i < 2; ++i) {
        const auto [depth, kappa] = nudge.at(i);
        const Point above = flow_in_double(task, {start.depth + depth, start.kappa + kappa});
        const Point below = flow_in_double(task, {start.depth - depth, start.kappa - kappa});
        const double step = 2 * (i == 0 ? -depth : kappa);
        result.by.at(0).at(i) = (below.depth - above.depth) / step;
        result.by.at(1).at(i) = (above.kappa - below.kappa) / step;
    }
    return result;
}

Series without_radii(Series p) {
    for (slong i = 0; i < p.raw()->length; ++i) {
        mag_zero(arb_radref(p.raw()->coeffs + i));
    }
    return p;
}
/// The orbit with x and kappa moved by so little that its square does not count.
Orbit moved(const Orbit& orbit, const Ball& x, const Ball& kappa) {
    return {orbit.x.plus(x), orbit.kappa.plus(kappa), without_radii(orbit.sine + orbit.cosine.times(x)),
            without_radii(orbit.cosine - orbit.sine.times(x))};
}
double size(const Ball& x) { return std::abs(approximate(x)); }

}  // namespace

std::optional<Orbit> guess_orbit(const Task& task) {
    constexpr int sweeps = 60;
    const Point start{approximate(pi() * Ball(0.5) - task.x), approximate(task.kappa)};
    if (!(start.depth > 0 && start.kappa > 0)) return std::nullopt;
    const Response response = macro::response(task, start);
    const double depth = response.middle.depth;
    if (!(depth > 0 && depth <= start.depth && response.middle.kappa >= start.kappa)) return std::nullopt;

    // A shift of the whole orbit by so much changes the excess by less than it should be: dx/ds cos x too, by
    // no more than the shift times the depth.
    const Ball half_length = whole(task.collisions) * Ball(0.5);
    const double slack = 0.1 * size(task.kappa_excess / (half_length * task.r));
    const double x_slack = std::min(slack, 0.1 * size(task.x_excess) / depth);
    const double kappa_slack = slack * std::sqrt(approximate(task.r));

    // A sweep finds about 40 more bits of where the orbit is at s = 0, and of its shape as many as the number
    // of collisions has: it is made with no more than these. The last one has all.
    struct Part {
        double slack, unit, won;

        [[nodiscard]] double wanted() const { return -std::log2(slack / unit); }
        [[nodiscard]] double right(double wrong) const { return -std::log2(wrong / unit); }
    };
    const double root = std::sqrt(approximate(task.r));
    const double of_shape = std::log2(static_cast<double>(task.collisions)) + 4;
    const std::array<Part, 4> parts{{{x_slack, 1, 40},
                                     {kappa_slack, root, 40},
                                     {size(task.x_excess) / 2, 1, of_shape},
                                     {size(task.kappa_excess) / 2, root, of_shape}}};
    constexpr int spare = 24;
    const int full = PrecisionScope::current();
    int work = std::min(full, 96);
    Ball x = middle(task.x + Ball(start.depth - depth));
    Ball kappa = middle(task.kappa + Ball(response.middle.kappa - start.kappa));
    Series f, g;
    for (int i = 0; i < sweeps; ++i) {
        std::optional<PrecisionScope> scope(std::in_place, work);
        Task now = task;
        now.terms = 4 + (task.terms - 4) * work / full;
        Orbit orbit = follow_flow(now, x, kappa, f, g);
        const Ball missed_x = middle(task.x - orbit.x.at(Ball(-1)));
        const Ball missed_kappa = middle(task.kappa - orbit.kappa.at(Ball(-1)));
        Excess found = excess(orbit, now, now.terms - 1, {});
        found.height = without_radii(found.height.plus(Ball(-1) * task.x_excess));
        found.slope = without_radii(found.slope.plus(Ball(-1) * task.kappa_excess));
        const std::array<double, 4> wrong{size(missed_x), size(missed_kappa),
                                          approximate(size_from(found.height, 0)),
                                          approximate(size_from(found.slope, 0))};
        if (!std::isfinite(wrong[2]) || !std::isfinite(wrong[3]) || !(wrong[0] < depth)) return std::nullopt;
        const auto is_right = [&](std::size_t j) { return wrong.at(j) < parts.at(j).slack; };
        const auto next = [&](std::size_t j) {
            const Part& part = parts.at(j);
            return spare + std::min(part.wanted(), part.right(wrong.at(j)) + part.won);
        };
        const bool is_placed = is_right(0) && is_right(1), is_done = is_placed && is_right(2) && is_right(3);
        if (is_done && work == full) {
            return moved(orbit, missed_x, missed_kappa);
        }
        // As long as it is not in its place, its shape need not be closer than that.
        const double more = is_placed ? std::max(next(2), next(3)) : std::max(next(0), next(1));
        work = is_done ? full : std::min(full, std::max(work + 16, static_cast<int>(std::min(more, 1e6))));
        scope.reset();
        scope.emplace(work);
        x = middle(x + Ball(response.by[0][0]) * missed_x + Ball(response.by[0][1]) * missed_kappa);
        kappa = middle(kappa + Ball(response.by[1][0]) * missed_x + Ball(response.by[1][1]) * missed_kappa);
        f = f - found.height;
        g = g - found.slope;
    }
    return std::nullopt;
}

}  // namespace dumbbell::flight::macro
