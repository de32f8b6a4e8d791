#include "number/flint.hpp"
#include "peers.hpp"

namespace dumbbell_bench {
namespace {

slong bits() { return dumbbell::PrecisionScope::current(); }

/// A ball of Arb as its user writes it: a class around arb_t, and Arb's own sine and cosine, both at once.
class Ball {
  public:
    Ball() { arb_init(value_); }
    explicit Ball(double point) : Ball() { arb_set_d(value_, point); }
    explicit Ball(const dumbbell::BigInterval& x) : Ball() {
        arb_set_interval_arf(value_, x.lower(), x.upper(), bits());
    }
    Ball(const Ball& other) : Ball() { arb_set(value_, other.value_); }
    Ball(Ball&& other) noexcept : Ball() { arb_swap(value_, other.value_); }
    Ball& operator=(const Ball& other) {
        arb_set(value_, other.value_);
        return *this;
    }
    Ball& operator=(Ball&& other) noexcept {
        arb_swap(value_, other.value_);
        return *this;
    }
    ~Ball() { arb_clear(value_); }

    [[nodiscard]] arb_srcptr raw() const { return value_; }
    [[nodiscard]] arb_ptr raw() { return value_; }

  private:
    arb_t value_;
};

Ball result_of(void (*operation)(arb_ptr, arb_srcptr, arb_srcptr, slong), const Ball& a, const Ball& b) {
    Ball result;
    operation(result.raw(), a.raw(), b.raw(), bits());
    return result;
}
Ball operator+(const Ball& a, const Ball& b) { return result_of(arb_add, a, b); }
Ball operator-(const Ball& a, const Ball& b) { return result_of(arb_sub, a, b); }
Ball operator*(const Ball& a, const Ball& b) { return result_of(arb_mul, a, b); }
Ball operator/(const Ball& a, const Ball& b) { return result_of(arb_div, a, b); }
Ball hull(const Ball& a, const Ball& b) { return result_of(arb_union, a, b); }
Ball max(const Ball& a, const Ball& b) { return result_of(arb_max, a, b); }
Ball sqr(const Ball& a) { return a * a; }
Ball operator-(const Ball& a) {
    Ball result;
    arb_neg(result.raw(), a.raw());
    return result;
}
dumbbell::SinCos<Ball> sin_cos(const Ball& a) {
    dumbbell::SinCos<Ball> result;
    arb_sin_cos(result.sin.raw(), result.cos.raw(), a.raw(), bits());
    return result;
}

Ball end_of(void (*end)(arf_ptr, arb_srcptr, slong), const Ball& a) {
    Ball result;
    end(arb_midref(result.raw()), a.raw(), bits());
    return result;
}
Ball low_end(const Ball& a) { return end_of(arb_get_lbound_arf, a); }
Ball high_end(const Ball& a) { return end_of(arb_get_ubound_arf, a); }
bool certainly_less(const Ball& a, const Ball& b) { return arb_lt(a.raw(), b.raw()) != 0; }
bool certainly_at_most(const Ball& a, const Ball& b) { return arb_le(a.raw(), b.raw()) != 0; }
bool certainly_positive(const Ball& a) { return arb_is_positive(a.raw()) != 0; }
double approximate(const Ball& a) { return arf_get_d(arb_midref(a.raw()), ARF_RND_NEAR); }
dumbbell::BigInterval as_big(const Ball& a) {
    dumbbell::BigInterval result;
    arb_get_interval_arf(result.lower(), result.upper(), a.raw(), bits());
    return result;
}
dumbbell::flight::ContactGuess<Ball> guess_contact(const Ball& c, const Ball& kappa, double start) {
    return guess_for(c, kappa, start);
}

}  // namespace
}  // namespace dumbbell_bench

using namespace dumbbell_bench;

template <>
Ball dumbbell::pi() {
    Ball result;
    arb_const_pi(result.raw(), PrecisionScope::current());
    return result;
}
template <>
Ball dumbbell::half_pi() {
    Ball result = pi<Ball>();
    arb_mul_2exp_si(result.raw(), result.raw(), -1);
    return result;
}
template <>
Ball dumbbell::flight::detail::least_step() {
    return Ball(two_to(-1000 - PrecisionScope::current()));
}

Arithmetic dumbbell_bench::arb() { return arithmetic<Ball, NoScope>("Arb"); }
