#include "dumbbell/mass_ratio.hpp"

#include <tuple>

#include "api/translate.hpp"
#include "number/ratio_argument.hpp"

namespace dumbbell::api {
inline namespace DUMBBELL_ABI {

MassRatio::MassRatio(std::string_view text) {
    std::tie(lo_, hi_) = guarded([&] {
        const RatioArgument ratio = parse_ratio_argument(std::string(text));
        return std::tuple(to_fraction(ratio.lo), to_fraction(ratio.hi));
    });
}

}  // namespace DUMBBELL_ABI
}  // namespace dumbbell::api
