#include "dumbbell/mass_ratio.hpp"

#include <tuple>

#include "api/translate.hpp"
#include "number/ratio_argument.hpp"

namespace dumbbell::api {
inline namespace DUMBBELL_ABI {

MassRatio::MassRatio(std::string_view text) {
    std::tie(lo_, hi_, light_over_heavy_) = guarded([&] {
        const RatioArgument ratio = parse_ratio_argument(std::string(text));
        const auto r = hull(enclose<dumbbell::Interval>(Rational(1) / ratio.hi),
                            enclose<dumbbell::Interval>(Rational(1) / ratio.lo));
        return std::tuple(to_fraction(ratio.lo), to_fraction(ratio.hi), Interval{r.lo(), r.hi()});
    });
}

}  // namespace DUMBBELL_ABI
}  // namespace dumbbell::api
