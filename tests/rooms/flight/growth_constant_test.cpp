#include "flight/growth_constant.hpp"

#include <boost/math/quadrature/gauss.hpp>

#include "catch.hpp"
#include "rooms/flight/reference.hpp"

using namespace dumbbell;
using dumbbell_test::Decimal;
using dumbbell_test::pi_in;

namespace {

/// Composite Gauss quadrature in 120 digits, of an analytic function: the same number by other means.
Decimal<120> reference() {
    using T = Decimal<120>;
    const auto integrand = [](const T& theta) { return T(sin(pi_in<T>() / (2 * cos(theta)))); };
    T sum = 0;
    constexpr int parts = 40;
    for (int i = 0; i < parts; ++i) {
        sum += boost::math::quadrature::gauss<T, 60>::integrate(integrand, T(pi_in<T>() * i / (3 * parts)),
                                                                T(pi_in<T>() * (i + 1) / (3 * parts)));
    }
    return sum;
}

}  // namespace

TEST_CASE("C is enclosed, as narrowly as the precision asks for") {
    const auto c = reference();
    CHECK(c.convert_to<double>() == Approx(0.8855951294527139).epsilon(1e-15));
    for (const int bits : {53, 128, 256, 350}) {
        CAPTURE(bits);
        const PrecisionScope scope(bits);
        const BigInterval enclosure = flight::growth_constant();
        CHECK(dumbbell_test::encloses(enclosure, c));
        CHECK(width(enclosure) < std::ldexp(1.0, 2 - bits));
    }
}
