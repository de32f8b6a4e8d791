#pragma once

#include <mpfr.h>

#include <bit>
#include <cinttypes>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <string>
#include <string_view>

/// Fixed evaluations of an interval layer in double, for comparing builds: a hash of the bits of all results
/// for each function, and how many of them MPFR refutes. Shared by the program's layer and the verifier's,
/// which each say what `lo` and `hi` of their intervals are.
namespace dumbbell_test {

/// Bits from integer arithmetic alone (splitmix64): no compiler and no library changes the arguments.
class Bits {
  public:
    std::uint64_t next() {
        std::uint64_t z = state_ += 0x9e3779b97f4a7c15;
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
        z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
        return z ^ (z >> 31);
    }
    /// A double of either sign with an exponent of [least, least + range).
    double number(int least, unsigned range) {
        const std::uint64_t bits = next();
        const auto exponent = static_cast<std::uint64_t>(1023 + least) + (next() >> 33) % range;
        return std::bit_cast<double>((bits & 0x800fffffffffffff) | (exponent << 52));
    }
    /// Of any size, subnormal and huge ones included, or ordinary.
    double any() { return next() % 4 == 0 ? number(-1023, 2046) : number(-20, 40); }

  private:
    std::uint64_t state_ = 0;
};

struct Exact {
    mpfr_t value;
    Exact() { mpfr_init2(value, 200); }
    Exact(const Exact&) = delete;
    Exact& operator=(const Exact&) = delete;
    ~Exact() { mpfr_clear(value); }
};

inline bool contain = false;
inline long refuted = 0;

/// The results of one function: hashed, and compared with MPFR if asked for.
class Record {
  public:
    explicit Record(const char* name) : name_(name) {}
    Record(const Record&) = delete;
    Record& operator=(const Record&) = delete;
    ~Record() {
        std::printf("%-16s %6d results %016" PRIx64 "\n", name_, count_, hash_);
        if (refuted_ > 0) {
            std::printf("%-16s %6d refuted\n", name_, refuted_);
        }
        refuted += refuted_;
    }

    /// compute(to, rounding) makes an MPFR number that the result must hold.
    template <class I, class Compute>
    void add(const I& result, const Compute& compute) {
        for (const double end : {lo(result), hi(result)}) {
            hash_ = (hash_ ^ std::bit_cast<std::uint64_t>(end)) * 0x100000001b3;
            hash_ ^= hash_ >> 29;
        }
        ++count_;
        if (contain) {
            static Exact exact;
            compute(exact.value, MPFR_RNDD);
            const bool above = mpfr_cmp_d(exact.value, lo(result)) >= 0;
            compute(exact.value, MPFR_RNDU);
            const bool below = mpfr_cmp_d(exact.value, hi(result)) <= 0;
            refuted_ += above && below ? 0 : 1;
        }
    }

  private:
    const char* name_;
    int count_ = 0;
    int refuted_ = 0;
    std::uint64_t hash_ = 0xcbf29ce484222325;
};

inline constexpr int samples = 40'000;

using Binary = int (*)(mpfr_ptr, mpfr_srcptr, mpfr_srcptr, mpfr_rnd_t);
using Unary = int (*)(mpfr_ptr, mpfr_srcptr, mpfr_rnd_t);

/// x op y for an interval x, of which the exact result at one end is compared.
template <class I, class Operation>
void binary(const char* name, Binary exact, const Operation& operation) {
    Bits bits;
    Record record(name);
    Exact a;
    Exact b;
    for (int i = 0; i < samples; ++i) {
        const double x = bits.any();
        const double y = bits.any();
        const double z = bits.any();
        mpfr_set_d(a.value, x, MPFR_RNDN);
        mpfr_set_d(b.value, y, MPFR_RNDN);
        const I wide = i % 2 == 0 ? I(x, x) : x < z ? I(x, z) : I(z, x);
        record.add(operation(wide, I(y, y)),
                   [&](mpfr_ptr to, mpfr_rnd_t rounding) { exact(to, a.value, b.value, rounding); });
    }
}

template <class I, class Draw, class Operation>
void unary(const char* name, Unary exact, const Draw& draw, const Operation& operation) {
    Bits bits;
    Record record(name);
    Exact a;
    for (int i = 0; i < samples; ++i) {
        const double x = draw(bits);
        const double width = i % 2 == 0 ? 0 : std::abs(bits.number(-50, 53));
        mpfr_set_d(a.value, x, MPFR_RNDN);
        record.add(operation(I(x, x + width)),
                   [&](mpfr_ptr to, mpfr_rnd_t rounding) { exact(to, a.value, rounding); });
    }
}

template <class I>
void arithmetic(const char* const (&names)[4]) {
    binary<I>(names[0], mpfr_add, [](const I& x, const I& y) { return x + y; });
    binary<I>(names[1], mpfr_sub, [](const I& x, const I& y) { return x - y; });
    binary<I>(names[2], mpfr_mul, [](const I& x, const I& y) { return x * y; });
    binary<I>(names[3], mpfr_div, [](const I& x, const I& y) { return x / y; });
}

/// What a program of this folder does: `refusal` is the self-test's message, if any.
/// Options: --contain counts what MPFR refutes; --contracted does so without the self-test. Exit codes: 0; 1
/// if results are refuted; 3 if the self-test refuses to compute.
template <class SelfTest, class Evaluate>
int run(int argc, char** argv, const SelfTest& refusal, const Evaluate& evaluate) {
    const std::string_view option = argc > 1 ? argv[1] : "";
    contain = !option.empty();
    if (option != "--contracted" && !refusal().empty()) {
        std::fprintf(stderr, "%s\n", refusal().c_str());
        return 3;
    }
    evaluate();
    return refuted == 0 ? 0 : 1;
}

}  // namespace dumbbell_test
