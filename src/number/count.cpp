#include "number/count.hpp"

#include <fmt/format.h>

#include <ostream>

#include "base/error.hpp"

namespace dumbbell {

Count::operator long() const {
    if (mpz_fits_slong_p(value_.raw()) == 0) {
        throw InputError(fmt::format("{} collisions: only fewer than 2^63 are listed or drawn", str()));
    }
    return value_.convert_to<long>();
}

Count::operator double() const { return mpz_get_d(value_.raw()); }

std::ostream& operator<<(std::ostream& out, const Count& x) { return out << x.integer(); }

}  // namespace dumbbell

fmt::format_context::iterator fmt::formatter<dumbbell::Count>::format(const dumbbell::Count& x,
                                                                      fmt::format_context& context) const {
    return fmt::formatter<fmt::string_view>::format(x.str(), context);
}
