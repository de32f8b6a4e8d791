#include "file/dyadic.hpp"

#include <fmt/core.h>

#include <cstdlib>

#include "base/error.hpp"

namespace dumbbell {

Dyadic dyadic(const Rational& x) {
    Integer m = numerator(x);
    if (m == 0) {
        return {};
    }
    const Integer below = denominator(x);
    const auto down = static_cast<long>(lsb(below));
    require(below == Integer(1) << static_cast<unsigned>(down), "certificate: a coordinate is not dyadic");
    const auto up = static_cast<long>(lsb(m));
    return {m >>= static_cast<unsigned>(up), up - down};
}

std::string to_dyadic(const Rational& x) {
    const auto [odd, places] = dyadic(x);
    require(std::abs(places) <= most_binary_places, "certificate: a coordinate has too many places");
    return fmt::format("{}b{}", odd.str(), places);
}

}  // namespace dumbbell
