#include "dumbbell/mass_ratio.hpp"

#include "api/translate.hpp"
#include "number/ratio_argument.hpp"

namespace dumbbell::api {
inline namespace DUMBBELL_ABI {

MassRatio::MassRatio(std::string_view text) {
    guarded([&] {
        const RatioArgument ratio = parse_ratio_argument(std::string(text));
        lo_ = to_fraction(ratio.lo);
        hi_ = to_fraction(ratio.hi);
        const auto r = hull(enclose<dumbbell::Interval>(Rational(1) / ratio.hi),
                            enclose<dumbbell::Interval>(Rational(1) / ratio.lo));
        light_over_heavy_ = {r.lo(), r.hi()};
    });
}

}  // namespace DUMBBELL_ABI
}  // namespace dumbbell::api
