#include "starts/traced_value.hpp"

#include <fmt/core.h>

namespace dumbbell::starts {
namespace {

std::string decimal(mpfr_srcptr x, const char* format, int digits) {
    char* text = nullptr;
    mpfr_asprintf(&text, format, digits, x);
    std::string result(text);
    mpfr_free_str(text);
    return result;
}

/// The greatest |x - y|, x in X, y in Y, without a sign even if it is 0.
BigInterval greatest_distance(const BigInterval& x, const BigInterval& y) {
    BigInterval result;
    mpfi_mag(&result.raw()->right, (x - y).raw());
    mpfr_abs(&result.raw()->right, &result.raw()->right, MPFR_RNDU);
    return result;
}

}  // namespace

TracedValue traced_value(const BigInterval& x, int digits) {
    const Interval outward(x.lo(), x.hi());
    const BigInterval middle = midpoint(x);
    const std::string value = decimal(&middle.raw()->left, "%.*RNg", digits);
    BigInterval written;
    mpfi_set_str(written.raw(), value.c_str(), 10);
    const BigInterval distance = greatest_distance(x, written);
    return {outward, value + "+-" + decimal(&distance.raw()->right, "%.*RUe", 1),
            decimal(&x.raw()->left, "%.*RDg", digits), decimal(&x.raw()->right, "%.*RUg", digits)};
}

TracedValue traced_value(const Interval& x, int digits) {
    const PrecisionScope scope(128);
    return traced_value(BigInterval(x.lo(), x.hi()), digits);
}

}  // namespace dumbbell::starts
