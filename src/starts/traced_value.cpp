#include "starts/traced_value.hpp"

#include <mpfr.h>

#include <algorithm>
#include <string>

namespace dumbbell::starts {
namespace {

std::string decimal(arf_srcptr x, const char* format, int digits) {
    mpfr_t same;
    mpfr_init2(same,
               std::max(static_cast<mpfr_prec_t>(arf_bits(x)), static_cast<mpfr_prec_t>(MPFR_PREC_MIN)));
    arf_get_mpfr(same, x, MPFR_RNDN);
    char* text = nullptr;
    mpfr_asprintf(&text, format, digits, same);
    mpfr_clear(same);
    std::string result(text);
    mpfr_free_str(text);
    return result;
}

/// The number that `text` is, at the working precision.
BigInterval enclose_text(const std::string& text) {
    BigInterval result;
    mpfr_t bound;
    mpfr_init2(bound, PrecisionScope::current());
    mpfr_set_str(bound, text.c_str(), 10, MPFR_RNDD);
    arf_set_mpfr(result.lower(), bound);
    mpfr_set_str(bound, text.c_str(), 10, MPFR_RNDU);
    arf_set_mpfr(result.upper(), bound);
    mpfr_clear(bound);
    return result;
}

/// The greatest |x - y|, x in X, y in Y.
BigInterval greatest_distance(const BigInterval& x, const BigInterval& y) {
    const BigInterval distance = x - y;
    return high_end(max(distance, -distance));
}

}  // namespace

TracedValue traced_value(const BigInterval& x, int digits) {
    const Interval outward(x.lo(), x.hi());
    const BigInterval middle = midpoint(x);
    const std::string value = decimal(middle.lower(), "%.*RNg", digits);
    const BigInterval distance = greatest_distance(x, enclose_text(value));
    return {outward, value + "+-" + decimal(distance.upper(), "%.*RUe", 1),
            decimal(x.lower(), "%.*RDg", digits), decimal(x.upper(), "%.*RUg", digits)};
}

TracedValue traced_value(const Interval& x, int digits) {
    const PrecisionScope scope(128);
    return traced_value(BigInterval(x.lo(), x.hi()), digits);
}

}  // namespace dumbbell::starts
