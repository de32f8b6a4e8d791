// The constants of the law, which the verifier computes by series of its own, to any number of digits.
#include "verify/law/constants.hpp"

#include "catch.hpp"
#include "truth.hpp"
#include "verify/functions/exact_value.hpp"

using dumbbell_verify::Big, dumbbell_verify::Interval, dumbbell_verify::exact_value;

namespace {

mpq_class decimal(const std::string& text) {
    mpz_class power;
    mpz_ui_pow_ui(power.get_mpz_t(), 10, text.size() - 2);
    return {mpz_class(text.substr(2)), power};
}
const mpq_class C = decimal(law_truth::C), c0 = decimal(law_truth::c0);

template <class N>
void check(const Interval<N>& found, const mpq_class& known, int places) {
    mpz_class power;
    mpz_ui_pow_ui(power.get_mpz_t(), 10, static_cast<unsigned long>(places));
    const mpq_class lo = exact_value(found.lo), hi = exact_value(found.hi), width(1, power);
    INFO(lo.get_d() << " " << hi.get_d() << " places " << places);
    CHECK((lo <= known + mpq_class(1, power)));
    CHECK((known - mpq_class(1, power) <= hi));
    CHECK((hi - lo <= width));
}

}  // namespace

TEST_CASE("law: C and c0 are enclosed as narrowly as the precision allows") {
    check(dumbbell_verify::law::growth_constant<double>(), C, 13);
    check(dumbbell_verify::law::law_constant<double>(), c0, 14);
    for (const int bits : {53, 100, 200, 360}) {
        Big::precision = bits;
        const int places = bits * 3 / 10 - 4;
        check(dumbbell_verify::law::growth_constant<Big>(), C, places);
        check(dumbbell_verify::law::law_constant<Big>(), c0, places);
    }
}

TEST_CASE("law: more bits enclose what fewer bits do") {
    for (const auto constant :
         {dumbbell_verify::law::growth_constant<Big>, dumbbell_verify::law::law_constant<Big>}) {
        Big::precision = 400;
        const Interval<Big> coarse = constant();
        const mpq_class lo = exact_value(coarse.lo), hi = exact_value(coarse.hi);
        Big::precision = 3600;
        const Interval<Big> fine = constant();
        CHECK((lo <= exact_value(fine.lo)));
        CHECK((exact_value(fine.hi) <= hi));
        CHECK((exact_value(fine.hi) - exact_value(fine.lo) < mpq_class(1, mpz_class(1) << 3550)));
    }
}
