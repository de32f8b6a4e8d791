#pragma once

#include <algorithm>
#include <boost/math/constants/constants.hpp>
#include <boost/multiprecision/mpfr.hpp>

#include "number/big_interval.hpp"
#include "number/interval.hpp"

/// The dumbbell in many digits, straight from lemmas L0 and L4 and by other formulas than src/model: vectors
/// and the reflection in the kinetic metric, roots by Newton's iteration from the safe side.
namespace dumbbell_test {

template <unsigned Digits>
using Decimal = boost::multiprecision::number<
    boost::multiprecision::mpfr_float_backend<Digits, boost::multiprecision::allocate_stack>,
    boost::multiprecision::et_off>;
using Real = Decimal<60>;  // 200 bits

template <class T>
T pi_in() {
    return boost::math::constants::pi<T>();
}

/// A velocity (d psi, d yhat).
template <class T>
struct Vector {
    T angular;
    T vertical;
};

/// Formula (1) of L0 at a wall of slope t.
template <class T>
Vector<T> reflect(const Vector<T>& v, const T& t, const T& r) {
    const T factor = 2 * (v.vertical - t * v.angular) / (t * t + r);
    return {v.angular + factor * t, v.vertical - factor * r};
}

/// The flight of the ray (c, kappa), kappa < 1, to the light wall.
template <class T>
struct Flight {
    bool hits;
    T x;          // the least root of sin x = c + kappa x; where the ray comes closest if it misses
    T clearance;  // the greatest value of sin x - kappa x - c on [0, pi/2]
};

template <class T>
Flight<T> exact_flight(const T& c, const T& kappa) {
    const T top = kappa <= 0 ? T(pi_in<T>() / 2) : T(acos(kappa));
    const T clearance = sin(top) - kappa * top - c;
    if (!(clearance > 0)) {
        return {false, top, clearance};
    }
    // The function is concave and increases up to `top`: Newton's iteration from the left stays left.
    T x = c / (1 - kappa);
    for (int i = 0; i < 2000; ++i) {
        const T step = (c + kappa * x - sin(x)) / (cos(x) - kappa);
        x += step;
        if (!(step > x * 32 * std::numeric_limits<T>::epsilon())) {
            break;
        }
    }
    return {true, x, clearance};
}

/// G(c, kappa, r) of L4, and how far from another number: the least of all quantities whose sign decided.
template <class T>
struct RayCount {
    long hits;
    T margin;
};

template <class T>
RayCount<T> ray_count(T c, T kappa, const T& r, long cap = 1'000'000) {
    RayCount<T> count{0, T(1)};
    const auto decide = [&count](const T& value) { count.margin = std::min(count.margin, T(abs(value))); };
    while (count.hits < cap) {
        decide(1 - kappa);
        if (kappa >= 1) {
            break;
        }
        const auto to_wall = exact_flight(c, kappa);
        decide(to_wall.clearance);
        if (!to_wall.hits) {
            break;
        }
        ++count.hits;
        const auto out = reflect<T>({T(1), kappa}, cos(to_wall.x), r);
        decide(out.angular);
        if (out.angular >= 0) {
            break;  // onwards, out of the cell
        }
        kappa = out.vertical / -out.angular;
        c = sin(to_wall.x) + kappa * (to_wall.x + pi_in<T>());
    }
    return count;
}

template <class T>
bool low_at_most(const dumbbell::Interval& x, const T& v) {
    return T(x.lo()) <= v;
}
template <class T>
bool high_at_least(const dumbbell::Interval& x, const T& v) {
    return v <= T(x.hi());
}
/// The number v, exactly.
template <class T>
dumbbell::BigInterval number_of(const T& v) {
    dumbbell::BigInterval number;
    arf_set_mpfr(number.lower(), v.backend().data());
    arf_set(number.upper(), number.lower());
    return number;
}
/// The number x, rounded to T's digits.
template <class T>
T number_in(arf_srcptr x) {
    T number;
    arf_get_mpfr(number.backend().data(), x, MPFR_RNDN);
    return number;
}
template <class T>
bool low_at_most(const dumbbell::BigInterval& x, const T& v) {
    return arf_cmp(x.lower(), number_of(v).lower()) <= 0;
}
template <class T>
bool high_at_least(const dumbbell::BigInterval& x, const T& v) {
    return arf_cmp(number_of(v).lower(), x.upper()) <= 0;
}
template <class I, class T>
bool encloses(const I& x, const T& v) {
    return low_at_most(x, v) && high_at_least(x, v);
}

template <class T>
T low_of(const dumbbell::Interval& x) {
    return T(x.lo());
}
template <class T>
T low_of(const dumbbell::BigInterval& x) {
    return number_in<T>(x.lower());
}

template <class T>
T high_of(const dumbbell::Interval& x) {
    return T(x.hi());
}
template <class T>
T high_of(const dumbbell::BigInterval& x) {
    return number_in<T>(x.upper());
}

template <unsigned Digits>
std::string show(const Decimal<Digits>& x) {
    return x.str(25);
}

}  // namespace dumbbell_test
