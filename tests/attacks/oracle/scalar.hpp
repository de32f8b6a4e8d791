// The two number types of the oracle: long double for speed, 80 digits where long double miscounts (at a
// distance e from a corner the walls part only like e^3, and a grazing contact loses half the digits).
#pragma once

#include <boost/math/constants/constants.hpp>
#include <boost/multiprecision/mpfr.hpp>
#include <limits>

namespace dumbbell_oracle {

using Digits80 = boost::multiprecision::number<
    boost::multiprecision::mpfr_float_backend<80, boost::multiprecision::allocate_stack>,
    boost::multiprecision::et_off>;

template <class S>
[[nodiscard]] inline S pi() {
    return boost::math::constants::pi<S>();
}

template <class S>
[[nodiscard]] inline S unit_roundoff() {
    return std::numeric_limits<S>::epsilon();
}

}  // namespace dumbbell_oracle
