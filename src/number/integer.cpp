#include "number/integer.hpp"

#include <ostream>

#include "base/error.hpp"

namespace dumbbell {

Integer::Integer(const std::string& digits) {
    require(mpz_init_set_str(z_, digits.c_str(), 10) == 0, "not the digits of an integer");
}

Integer& Integer::with(void (*operation)(mpz_ptr, mpz_srcptr, mpz_srcptr), const Integer& y) {
    operation(z_, z_, y.z_);
    return *this;
}
Integer& Integer::with(void (*operation)(mpz_ptr, mpz_srcptr, mp_bitcnt_t), unsigned bits) {
    operation(z_, z_, bits);
    return *this;
}
Integer& Integer::operator/=(const Integer& y) {
    require(mpz_sgn(y.z_) != 0, "an integer is divided by zero");
    return with(mpz_tdiv_q, y);
}
Integer& Integer::operator%=(const Integer& y) {
    require(mpz_sgn(y.z_) != 0, "an integer is divided by zero");
    return with(mpz_tdiv_r, y);
}

std::ostream& operator<<(std::ostream& out, const Integer& x) { return out << x.str(); }

std::string Integer::str() const {
    std::string text(mpz_sizeinbase(z_, 10) + 2, '\0');
    mpz_get_str(text.data(), 10, z_);
    text.resize(text.find('\0'));
    return text;
}

Integer pow(const Integer& base, unsigned exponent) {
    Integer power;
    mpz_pow_ui(power.raw(), base.raw(), exponent);
    return power;
}

std::size_t lsb(const Integer& x) { return mpz_scan1(x.raw(), 0); }
std::size_t msb(const Integer& x) { return mpz_sizeinbase(x.raw(), 2) - 1; }

}  // namespace dumbbell
