// The enclosures under a check of initial conditions hold for random states in their boxes: the first
// contact's angle and the rays after a reflection, against bisection and the law (1) of L0 in long double.
#include <cmath>

#include "catch.hpp"
#include "rooms/number/random.hpp"
#include "scale.hpp"
#include "verify/functions/exact_value.hpp"
#include "verify/wings/starts/reflection.hpp"

using namespace dumbbell_verify;
using dumbbell_verify::starts::Departures;
using dumbbell_verify::starts::FirstReflection;
using dumbbell_verify::starts::Flight;

namespace {

using LongDouble = long double;
using Doubles = Interval<double>;
constexpr LongDouble pi_long = 3.14159265358979323846264338327950288L;

dumbbell_test::Random step_random(2024);

Doubles around(double lo, double width) { return {lo, lo + width}; }
/// A number of X, often an end.
double in(const Doubles& x) {
    return step_random.below(3) == 0 ? x.lo : step_random.coin() ? x.hi : step_random.uniform(x.lo, x.hi);
}
bool step_holds(const Doubles& x, LongDouble value) {
    const LongDouble tolerance = 1e-13L * (1 + std::abs(value));
    return x.lo - tolerance <= value && value <= x.hi + tolerance;
}

/// (1) of L0 at a wall of slope t.
std::pair<LongDouble, LongDouble> reflected(LongDouble spin, LongDouble climb, LongDouble t, LongDouble r) {
    const LongDouble rate = climb - t * spin, factor = 2 * rate / (t * t + r);
    return {spin + factor * t, climb - factor * r};
}
/// The least root of sin x = c + k x in (0, pi], or none; c > 0.
std::optional<LongDouble> first_contact(LongDouble c, LongDouble k) {
    const auto gap = [&](LongDouble x) { return std::sin(x) - c - k * x; };
    LongDouble lo = 0, hi = k >= 1 ? 0 : k <= -1 ? pi_long : std::acos(k);  // the gap is greatest at hi
    if (gap(hi) < 0) return std::nullopt;
    for (int j = 0; j < 80; ++j) ((gap((lo + hi) / 2) < 0) ? lo : hi) = (lo + hi) / 2;
    return lo;
}

}  // namespace

TEST_CASE("initial conditions: the enclosure of the first contact's angle holds, for either mass") {
    const long boxes = scaled(3'000);
    long found[2] = {0, 0}, narrow = 0;
    for (long i = 0; i < boxes; ++i) {
        const double size = std::exp2(step_random.uniform(-20, -3));
        const auto rational = [](double x) { return mpq_class(x); };
        // One wide side or all of them.
        const std::size_t wide = step_random.below(6);
        const auto width = [&](std::size_t k) {
            return wide == 5 || wide == k ? size * step_random.uniform(0, 1) : 0;
        };
        const std::array lo{step_random.uniform(-4, 4), step_random.uniform(-2, 2), step_random.uniform(1, 2),
                            -step_random.uniform(0.1, 2), step_random.uniform(1, 12)};
        starts::Box box;
        std::array<double, 5> hi{};
        for (std::size_t k = 0; k < 5; ++k) {
            hi.at(k) = lo.at(k) + width(k);
            box.lo.at(k) = rational(lo.at(k));
            box.hi.at(k) = rational(hi.at(k));
        }
        const Flight<double> flight(box);
        const bool heavy = step_random.coin();
        struct Start {
            LongDouble phi, w, h, v, r;
            [[nodiscard]] LongDouble clearance(bool heavy, LongDouble t) const {
                const LongDouble sine = std::sin(phi + w * t);
                return h + v * t + (heavy ? -r * sine : sine);
            }
        };
        const auto start = [&] {  // h, v and r independent: more than the states of the box
            return Start{in(flight.phi), in(flight.w), in(flight.h), in(flight.v), in(flight.r)};
        };
        // A zero of the clearance, and a window around it in which all states have one.
        const auto zero = [&](const Start& s, LongDouble from, LongDouble until) {
            for (int j = 0; j < 90; ++j)
                (s.clearance(heavy, (from + until) / 2) > 0 ? from : until) = (from + until) / 2;
            return from;
        };
        const Start guide = start();
        const LongDouble near = zero(guide, 0, (guide.h + 2) / -guide.v);
        const Doubles window(static_cast<double>(near - 30 * size), static_cast<double>(near + 30 * size));
        if (!(window.lo > 0 && flight.clearance(heavy, Doubles(window.lo)).lo > 0 &&
              flight.clearance(heavy, Doubles(window.hi)).hi < 0 && flight.rate_over(heavy, window).hi < 0))
            continue;
        const auto angle = flight.contact_angle(heavy, window);
        REQUIRE(angle);
        ++found[heavy];
        narrow += angle->hi - angle->lo < 10 * size;
        for (int j = 0; j < 8; ++j) {
            const Start s = start();
            const LongDouble phi = s.phi + s.w * zero(s, window.lo, window.hi);
            INFO("box " << i << ", wide side " << wide << ", heavy " << heavy);
            REQUIRE(step_holds(*angle, phi));
        }
    }
    CHECK(found[0] > boxes / 15);
    CHECK(found[1] > boxes / 15);
    CHECK(narrow > boxes / 15);
}

TEST_CASE("initial conditions: steps off the bridge and off a light wall hold for every ray of the box") {
    const long boxes = scaled(8'000);
    long bridge[2] = {0, 0}, light = 0, last = 0, far = 0, dives = 0;
    for (long i = 0; i < boxes; ++i) {
        const double size = std::exp2(step_random.uniform(-16, -3));
        const Doubles r = around(1 / step_random.uniform(1.05, 40), 0);
        const Doubles ratio(r.lo, std::min(1.0, r.lo * (1 + size * step_random.uniform(0, 1))));
        Departures<double> departures(ratio, nullptr);
        const bool low = step_random.coin();  // heights that meet the bridge, and such that do not
        const Doubles height =
            around(low ? r.lo * step_random.uniform(0.01, 1) : step_random.uniform(0.01, 1.2), r.lo * size);
        const Doubles slope =
            around(low ? r.lo * step_random.uniform(-2, 1) : step_random.uniform(-0.3, 0.6), r.lo * size);
        const bool from_light = step_random.below(4) != 0;  // else from the bridge: a light wall is ahead
        const bool passes = !from_light || departures.passes_bridge({true, height, slope});
        bool leaves = false;
        const auto next = passes ? departures.off_light_wall({from_light, height, slope}, leaves)
                                 : departures.off_bridge({true, height, slope});
        if (!next && !leaves) continue;
        for (int j = 0; j < 6; ++j) {
            const LongDouble a = in(height), k = in(slope), q = in(ratio);
            INFO("height " << a << " slope " << k << " r " << q);
            const auto x = !from_light ? first_contact(a, k)
                           : passes    ? first_contact(a + k * pi_long, k)
                                       : first_contact(a / q, k / q);
            REQUIRE(x);
            const LongDouble wall = passes ? std::cos(*x) : q * std::cos(*x);
            const auto [spin, climb] = reflected(1, k, wall, q);
            if (passes && from_light)  // nothing of the bridge on the way
                for (int n = 1; n < 40; ++n)
                    REQUIRE(a + k * pi_long * n / 40 > q * std::sin(pi_long * n / 40));
            if (leaves) {
                ++last;
                REQUIRE(spin >= -1e-15L);
                continue;
            }
            const LongDouble run = !passes && spin > 0 ? pi_long - *x : *x;
            if (passes) REQUIRE(spin < 0);
            far += !passes && *x > pi_long / 2;
            dives += passes && k < -q;
            REQUIRE(next->light == passes);
            REQUIRE(step_holds(next->slope, climb / std::abs(spin)));
            REQUIRE(step_holds(next->height, (passes ? 1 : q) * std::sin(*x) + climb / std::abs(spin) * run));
            ++(passes ? light : bridge[spin > 0]);
        }
    }
    CHECK(bridge[0] > boxes / 40);
    CHECK(bridge[1] > boxes / 40);
    CHECK(light > boxes / 40);
    CHECK(last > boxes / 80);
    CHECK(far > boxes / 40);
    CHECK(dives > boxes / 40);
}

TEST_CASE("initial conditions: steps off the bridge hold in few bits, where a wrong rounding shows") {
    int found[2] = {0, 0}, far = 0;
    for (int i = 0; i < 250; ++i) {
        Big::precision = 6 + i % 5;
        const auto number = [](double x) { return bound(down, mpq_class(x), Big(0)); };
        const auto interval = [&](double lo, double width) {
            const Big from = number(lo);
            return Interval<Big>(from, add(up, from, number(width)));
        };
        const bool behind = i % 4 != 0;  // the bridge is met behind its top
        const double ratio = step_random.uniform(0.02, 1),
                     k = ratio * (behind ? step_random.uniform(-4, -0.3) : step_random.uniform(-2, 1)),
                     a = behind ? -k * step_random.uniform(1.6, 3.3) : ratio * step_random.uniform(0.01, 1.5);
        const auto width = [&] { return i % 3 != 0 ? 0 : ratio * std::exp2(step_random.uniform(-10, 0)); };
        const Interval<Big> r = interval(ratio, 0), height = interval(a, width()),
                            slope = interval(k, width());
        const auto next = Departures<Big>(r, nullptr).off_bridge({true, height, slope});
        if (!next) continue;
        for (int corner = 0; corner < 4; ++corner) {
            const LongDouble q = to_double(down, r.lo),
                             c = to_double(down, corner & 1 ? height.hi : height.lo),
                             kappa = to_double(down, corner & 2 ? slope.hi : slope.lo);
            INFO("height " << c << " slope " << kappa << " r " << q << " bits " << Big::precision);
            const auto x = first_contact(c / q, kappa / q);
            REQUIRE(x);
            const auto [spin, climb] = reflected(1, kappa, q * std::cos(*x), q);
            const LongDouble out = climb / std::abs(spin),
                             rise = q * std::sin(*x) + out * (spin > 0 ? pi_long - *x : *x);
            const auto encloses = [](const Interval<Big>& y, LongDouble value) {
                const LongDouble tolerance = 1e-12L * (1 + std::abs(value));
                return to_double(down, y.lo) <= value + tolerance && value <= to_double(up, y.hi) + tolerance;
            };
            REQUIRE(encloses(next->slope, out));
            REQUIRE(encloses(next->height, rise));
            ++found[spin > 0];
            far += *x > pi_long / 2;
        }
    }
    CHECK(found[0] > 10);
    CHECK(found[1] > 10);
    CHECK(far > 10);
}

TEST_CASE("initial conditions: the rays after the first reflection hold for every state and angle") {
    int found[2][2][2] = {}, outward = 0, steep = 0;  // mass, falling, turning forwards
    for (int i = 0; i < 60'000; ++i) {
        const double size = std::exp2(step_random.uniform(-20, -3));
        const std::array lo{0.0, step_random.uniform(-2, 2), 1.0, step_random.uniform(-2, 1),
                            step_random.uniform(1, 12)};
        starts::Box box;
        const std::size_t wide = step_random.below(5);
        for (std::size_t k = 0; k < 5; ++k) {
            box.lo.at(k) = mpq_class(lo.at(k));
            box.hi.at(k) =
                mpq_class(lo.at(k) + ((k == 1 || k == 3 || k == 4) && (wide == k || wide == 0) ? size : 0));
        }
        const Flight<double> flight(box);
        const bool heavy = step_random.coin();
        const Doubles angle = around(step_random.uniform(-7, 7), wide <= 1 ? size : 0);
        FirstReflection<double> reflection(flight, nullptr);
        bool none = false;
        const auto ray = reflection.behind_first(heavy, angle, none);
        if (!ray && !none) continue;
        for (int j = 0; j < 8; ++j) {
            const LongDouble phi = in(angle), w = in(flight.w), v = in(flight.v), r = in(flight.r);
            const LongDouble c = std::cos(phi), height = heavy ? r * std::sin(phi) : -std::sin(phi);
            if (height <= 0 || v + (heavy ? -r : 1) * w * c >= 0) break;  // no contact of this mass
            const auto [spin, climb] = reflected(w, v, heavy ? r * c : -c, r);
            INFO("phi " << phi << " w " << w << " v " << v << " r " << r << " heavy " << heavy);
            if (none) {
                const bool is_steep = climb >= std::abs(spin) * (1 - 1e-15L);
                const LongDouble peak = (std::floor(phi / pi_long) + 0.5L) * pi_long;
                REQUIRE((is_steep || (!heavy && (spin > 0) == (phi < peak))));
                ++(is_steep ? steep : outward);
                continue;
            }
            const LongDouble corner = (std::floor(phi / pi_long) + (spin > 0 ? 1 : 0)) * pi_long;
            const LongDouble slope = climb / std::abs(spin);
            REQUIRE(ray->light == !heavy);
            REQUIRE(step_holds(ray->slope, slope));
            REQUIRE(step_holds(ray->height, height + slope * std::abs(corner - phi)));
            ++found[heavy][flight.v.hi < 0][w > 0];
        }
    }
    for (const bool heavy : {false, true})
        for (const bool falling : {false, true})
            for (const bool forwards : {false, true}) {
                INFO(heavy << falling << forwards);
                CHECK(found[heavy][falling][forwards] > 100);
            }
    CHECK(outward > 10);
    CHECK(steep > 1000);
}

TEST_CASE("initial conditions: the number of later collisions must hold for every ray of a box") {
    const Doubles r(0.1);
    const auto certified = [&](bool light, const Doubles& height, const Doubles& slope, int least, int most) {
        return Departures<double>(r, nullptr).certify({light, height, slope}, least, most);
    };
    CHECK(certified(true, Doubles(0.5), Doubles(1, 2), 0, 0));  // steep
    CHECK_FALSE(certified(true, Doubles(0.5), Doubles(0.05, 2), 0, 0));
    CHECK_FALSE(certified(false, Doubles(0.1), Doubles(0.05, 2), 0, 0));
    CHECK(
        certified(false, Doubles(0.1), Doubles(0.05), 1, 1));  // from the bridge to the light wall, and away
    CHECK_FALSE(certified(false, Doubles(0.1), Doubles(0.05), 0, 0));
    CHECK_FALSE(certified(false, Doubles(0.1), Doubles(0.05), 2, 2));
    CHECK(certified(false, Doubles(2), Doubles(-0.05, 3), 0, 0));  // over everything
    CHECK_FALSE(certified(false, Doubles(0.1, 2), Doubles(0.05), 0, 0));
    CHECK_FALSE(certified(false, Doubles(0.1, 2), Doubles(0.05), 1, 1));
}

TEST_CASE("initial conditions: a second dip of a mass is not its first contact") {
    // Low and turning fast: the light mass is down at about pi/20 * 3, up again, and down after another turn.
    starts::Box box;
    box.lo = box.hi = {0, 10, mpq_class(9, 10), mpq_class(-1, 1000), 10};
    const Flight<double> flight(box);
    const auto crossing = [&](double from, double until) {
        return flight.clearance(false, Doubles(from)).lo > 0 &&
               flight.clearance(false, Doubles(until)).hi < 0 &&
               flight.rate_over(false, Doubles(from, until)).hi < 0;
    };
    const double turn = 0.2 * static_cast<double>(pi_long);
    REQUIRE(crossing(0.40, 0.47));
    REQUIRE(crossing(0.40 + turn, 0.47 + turn));
    CHECK(flight.is_closed(false, 0.47));
    CHECK_FALSE(flight.is_closed(false, 0.47 + turn));
    CHECK_FALSE(flight.is_closed(true, 0.47));
    const starts::Box turning = box;
    // The same a hundred times as slow.
    box.lo[1] = box.hi[1] = mpq_class(1, 10);
    box.lo[3] = box.hi[3] = mpq_class(-1, 100'000);
    const Flight<double> slow(box);
    CHECK(slow.is_closed(false, 47));
    CHECK_FALSE(slow.is_closed(false, 47 + 100 * turn));
    for (const double shift : {0.0, turn}) {
        starts::Leaf leaf;
        leaf.box = turning;
        leaf.least = 1;
        leaf.most = 9;
        leaf.first = starts::FirstContact{false, mpq_class(0.40 + shift), mpq_class(0.47 + shift)};
        CHECK((starts::check_leaf(leaf, nullptr) == nullptr) == (shift == 0));
        // Of states of every phidot nothing is known but that they fall.
        leaf.any_spin = true;
        CHECK(starts::check_leaf(leaf, nullptr) != nullptr);
        leaf.first.reset();
        CHECK(starts::check_leaf(leaf, nullptr) == nullptr);
    }
}

TEST_CASE("initial conditions: contacts behind the top of the bridge are sharp from below") {
    struct Slopes {
        mpq_class lo, hi;
    };
    // Rays of one height and slopes in [lo, hi] at r = 1/2: their slopes behind the contact.
    const auto off_bridge = [](int bits, const mpq_class& height, const mpq_class& lo, const mpq_class& hi) {
        Big::precision = bits;
        const auto number = [](const mpq_class& x) { return bound(down, x, Big()); };
        const Interval<Big> r = number(mpq_class(1, 2));
        const auto next =
            Departures<Big>(r, nullptr).off_bridge({true, number(height), {number(lo), number(hi)}});
        REQUIRE(next);
        return Slopes{exact_value(next->slope.lo), exact_value(next->slope.hi)};
    };
    const mpq_class steep(-5, 16), flat(-1, 4), tiny(1, mpz_class(1) << 80);
    const mpq_class tangent(0.9566114774905181);  // the height of a ray of slope -1/4 that just touches
    for (int i = 0; i < 14; ++i) {
        mpq_class height = mpq_class(917 + 3 * i) / 1024;
        if (i >= 12) height = tangent - mpq_class(1, 1 << (2 * i));
        CAPTURE(i, height.get_d());
        const Slopes thin = off_bridge(90, height, flat, flat), truth = off_bridge(300, height, flat, flat);
        CHECK((thin.lo <= truth.lo));
        CHECK((thin.hi >= truth.hi));
        if (i < 12) CHECK((thin.hi < truth.hi + tiny));
        // Of these the lowest ray, the steepest one down, comes first and leaves with the greatest slope.
        const Slopes wide = off_bridge(90, height, steep, flat),
                     lowest = off_bridge(300, height, steep, steep);
        CHECK((wide.lo <= truth.lo));
        CHECK((wide.hi >= lowest.hi));
        CHECK((wide.hi < lowest.hi + tiny));
    }
}

TEST_CASE("initial conditions: states that rise, fall or may do either, turning either way, are reflected") {
    for (const bool heavy : {false, true})
        for (const int w : {-8, 8})
            for (const int kind : {-1, 0, 1}) {
                starts::Box box;
                const mpq_class middle = mpq_class(kind) / 2, width(1, 1000);
                box.lo = {0, w, 1, middle - width, 4};
                box.hi = {0, w, 1, middle + width, 4};
                const Flight<double> flight(box);
                FirstReflection<double> reflection(flight, nullptr);
                int found = 0;
                for (int i = -60; i < 60; ++i) {
                    const LongDouble phi = 0.05 * i, r = 0.25, sine = std::sin(phi), wall = std::cos(phi);
                    const LongDouble height = heavy ? r * sine : -sine, t = heavy ? r * wall : -wall;
                    bool none = false;
                    const auto ray = reflection.behind_first(heavy, Doubles(0.05 * i), none);
                    if (none) CHECK_FALSE(ray);
                    if (height <= 0 || flight.v.hi - t * w >= 0 || !ray) continue;
                    ++found;
                    for (const double v : {flight.v.lo, flight.v.hi}) {
                        const auto [spin, climb] = reflected(w, v, t, r);
                        const LongDouble slope = climb / std::abs(spin),
                                         corner = (std::floor(phi / pi_long) + (spin > 0 ? 1 : 0)) * pi_long;
                        CAPTURE(heavy, w, v, i);
                        CHECK(step_holds(ray->slope, slope));
                        CHECK(step_holds(ray->height, height + slope * std::abs(corner - phi)));
                    }
                }
                CAPTURE(heavy, w, kind);
                CHECK(found > 2);
            }
}

TEST_CASE("initial conditions: beyond 2^28 half turns no wall is known by its number") {
    // The dumbbell turns so fast that it is reflected forwards wherever it touches.
    starts::Box box;
    box.lo = box.hi = {0, 1, 1, mpq_class(-1, 10), 100};
    for (const double angle : {9e8, -9e8, 1e18}) {
        FirstReflection<double> reflection(Flight<double>(box), nullptr);
        bool none = false;
        CHECK_FALSE(reflection.behind_first(true, Doubles(angle), none));
        CHECK(std::string(reflection.failed()) == "an angle within reach");
    }
}

TEST_CASE("initial conditions: the log names every wall that rays leave") {
    Log log;
    Departures<double> rays(Doubles(0.1), &log);
    CHECK_FALSE(rays.certify({true, Doubles(0.05), Doubles(0.01)}, 9, 9));
    CHECK(log.text.find("  after 0: light wall, height at the corner 0.05") != std::string::npos);
    CHECK(log.text.find("  after 1: bridge, height at the corner") != std::string::npos);
}

TEST_CASE(
    "initial conditions: a first contact next to a corner, nearer than doubles can tell, has its wall") {
    Big::precision = 200;
    starts::Box box;
    box.lo = box.hi = {0, mpq_class(1, 10), 1, -1, 4};
    const Flight<Big> flight(box);
    const mpq_class near(3.141592653589793), behind(1.2246467991473532e-16), little(1e-20);
    const auto leaves = [&](bool heavy, const mpq_class& angle) {
        bool none = false;
        return FirstReflection<Big>(flight, nullptr)
            .behind_first(heavy, bound(down, angle, Big()), none)
            .has_value();
    };
    CHECK(leaves(true, near - little));            // on the bridge before pi, next to the double below pi
    CHECK(leaves(false, near + behind + little));  // on the light wall behind pi
}
