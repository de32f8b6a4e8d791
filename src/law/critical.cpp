#include "law/critical.hpp"

#include "base/error.hpp"
#include "law/at_ratio.hpp"
#include "law/certificate.hpp"
#include "law/constants.hpp"

namespace dumbbell::law {

BigInterval critical_ratio(const Integer& n) {
    require(n > Integer(last_step), "the law encloses critical ratios beyond its steps only");
    const PrecisionScope scope(2 * static_cast<int>(msb(n)) + 128);
    const BigInterval place = enclose<BigInterval>(Rational(n - 2)) + delta_bounds(n);
    return sqr(place / Constants().C);
}

}  // namespace dumbbell::law
