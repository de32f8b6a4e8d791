#include "file/dyadic.hpp"

#include <fmt/core.h>

#include "base/error.hpp"

namespace dumbbell {

std::string to_dyadic(const Rational& x) {
    Integer m = numerator(x);
    if (m == 0) {
        return "0b0";
    }
    const Integer below = denominator(x);
    const auto down = static_cast<long>(lsb(below));
    require(below == Integer(1) << static_cast<unsigned>(down), "certificate: a coordinate is not dyadic");
    const auto up = static_cast<long>(lsb(m));
    m >>= static_cast<unsigned>(up);
    require(up <= most_binary_places && down <= most_binary_places,
            "certificate: a coordinate has too many places");
    return fmt::format("{}b{}", m.str(), up - down);
}

}  // namespace dumbbell
