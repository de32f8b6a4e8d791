#include "number/count.hpp"

#include <fmt/format.h>

#include <ostream>
#include <utility>

#include "base/error.hpp"

namespace dumbbell {

std::intptr_t Count::address_of_new(Integer value) {
    static_assert(alignof(Integer) % 2 == 0);
    return reinterpret_cast<std::intptr_t>(new Integer(std::move(value)));  // NOLINT
}
void Count::free_large() const { delete large(); }  // NOLINT(cppcoreguidelines-owning-memory)

Count::Count(Integer value)
    : word_(mpz_fits_slong_p(value.raw()) != 0 && fits(value.convert_to<long>())
                ? tagged(value.convert_to<long>())
                : address_of_new(std::move(value))) {}

Count::Count(double value) {
    Integer integer;
    mpz_set_d(integer.raw(), value);
    *this = Count(std::move(integer));
}

long as_long(const Count& n) {
    if (n.is_small()) {
        return n.small();
    }
    if (mpz_fits_slong_p(n.large()->raw()) == 0) {
        throw InputError(fmt::format("{} collisions: only fewer than 2^63 are listed or drawn", n.str()));
    }
    return n.large()->convert_to<long>();
}

Count::operator double() const { return mpz_get_d(integer().raw()); }

std::ostream& operator<<(std::ostream& out, const Count& x) { return out << x.str(); }

}  // namespace dumbbell

fmt::format_context::iterator fmt::formatter<dumbbell::Count>::format(const dumbbell::Count& x,
                                                                      fmt::format_context& context) const {
    return fmt::formatter<fmt::string_view>::format(x.str(), context);
}
