#include "number/integer.hpp"

#include <ostream>

#include "base/error.hpp"

namespace dumbbell {

Integer::Integer(const std::string& digits) {
    require(mpz_init_set_str(z_, digits.c_str(), 10) == 0, "not the digits of an integer");
}

Integer& Integer::operator+=(const Integer& y) {
    mpz_add(z_, z_, y.z_);
    return *this;
}
Integer& Integer::operator-=(const Integer& y) {
    mpz_sub(z_, z_, y.z_);
    return *this;
}
Integer& Integer::operator*=(const Integer& y) {
    mpz_mul(z_, z_, y.z_);
    return *this;
}
Integer& Integer::operator/=(const Integer& y) {
    require(mpz_sgn(y.z_) != 0, "an integer is divided by zero");
    mpz_tdiv_q(z_, z_, y.z_);
    return *this;
}
Integer& Integer::operator%=(const Integer& y) {
    require(mpz_sgn(y.z_) != 0, "an integer is divided by zero");
    mpz_tdiv_r(z_, z_, y.z_);
    return *this;
}
Integer& Integer::operator<<=(unsigned bits) {
    mpz_mul_2exp(z_, z_, bits);
    return *this;
}
Integer& Integer::operator>>=(unsigned bits) {
    mpz_fdiv_q_2exp(z_, z_, bits);
    return *this;
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
