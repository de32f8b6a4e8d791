// The constants of the law, which the verifier computes by series of its own, to any number of digits.
#include "verify/wings/law/constants.hpp"

#include <fstream>
#include <regex>

#include "catch.hpp"
#include "truth.hpp"
#include "verify/functions/exact_value.hpp"
#include "verify/wings/law/claim.hpp"

using dumbbell_verify::Big, dumbbell_verify::Interval, dumbbell_verify::exact_value;

namespace {

mpq_class decimal(const std::string& text) {
    mpz_class power;
    mpz_ui_pow_ui(power.get_mpz_t(), 10, text.size() - 2);
    return {mpz_class(text.substr(2)), power};
}
const mpq_class C = decimal(law_truth::C), c0 = decimal(law_truth::c0);

/// Each decimal and fraction of a file between two texts, as it is written there but for its sign.
std::vector<double> numbers_of(const char* file, const char* from, const char* until) {
    std::ifstream in(std::string(DUMBBELL_PROJECT) + file);
    std::string text{std::istreambuf_iterator<char>(in), {}};
    text = text.substr(text.find(from));
    text = std::regex_replace(text.substr(0, text.find(until)), std::regex(R"(\^\d)"), "");
    const std::regex number(R"((\d+)(\.\d+|/\d+))");
    std::vector<double> found;
    for (std::sregex_iterator at(text.begin(), text.end(), number), end; at != end; ++at)
        found.push_back((*at)[2].str()[0] == '.' ? std::stod(at->str())
                                                 : std::stod((*at)[1]) / std::stod((*at)[2].str().substr(1)));
    return found;
}

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

TEST_CASE("law: the numbers of the conditions are those of the theorem, and of the format") {
    using namespace dumbbell_verify::law;
    const auto says = [](const char* file, const char* from, const char* until, std::vector<Ratio> known) {
        std::vector<double> values;
        for (const Ratio& x : known) values.push_back(std::abs(x.numerator) / double(x.denominator));
        INFO(file << ": " << from);
        CHECK(numbers_of(file, from, until) == values);
    };
    const auto& [p0, p2, p4, p8] = bulk_p;
    const auto& [t0, t1, t2, t3] = bulk_angles;
    const auto& [w0, w8] = bulk_slack;
    const auto& [fall1, fall2, fall3] = most_fall;
    const char *law = "/proofs/law.md", *format = "/docs/reference/format-law.md";
    says(law, "- (C4)", "\n\n", {least_delta, most_delta});
    says(law, "*Layer.*", "\n\n", {layer_U, layer_rho, most_eps, layer_least_Q, layer_most_Q, J_drift});
    says(law, "- (C6)", "- (C8)", {layer_least[0], layer_least[1], layer_most[0], layer_most[1]});
    says(law, "- (C8)", "\n\n", {most_drift});
    says(law, "- (C9)", "- (C10)", {t3, p0, p2, p4, p8, w0, w8});
    says(law, "- (C10)", "\n\n", {fall1, t1, fall2, t1, t2, fall3, t2, t3});
    says(law, "*End.*", "\n\n", {end_d, most_eps, end_least_Q, end_most_Q, J_drift});
    says(law, "- (C11)", "\n\n", {end_surplus, end_slack[0], end_slack[1]});
    says(format, "| 3 to 902", "(C4)", {least_delta, most_delta});
    says(format, "U in [0, 9/10]", "at most 400", {layer_U, layer_rho});
    says(format, "rho U^2 ehat, Q in", "that is", {layer_least_Q, layer_most_Q, J_drift});
    says(format, "is at least -0", "(C7)", {layer_least[0], layer_least[1], layer_most[0], layer_most[1]});
    says(format, "a/(2 ehat^2) <=", "(C8)", {most_drift});
    says(format, "three ranges, [0", "in n1", {t1, t1, t2, t2, t3});
    says(format, "all eps in [0", "With D", {most_eps, bulk_least_Q, bulk_most_Q});
    says(format, "- |M - p(th)|", "(C9)", {w0, w8, p0, p2, p4, p8});
    says(format, "- Lambda is", "(C10)", {fall1, fall2, fall3});
    says(format, "equal parts of [0, 9", "narrowed", {end_d, J_drift, end_least_Q, end_most_Q});
    says(format, "d^2 epsh >", "(C11)", {most_eps, end_surplus, end_slack[0], end_slack[1]});
    CHECK((first_step == 3 && last_step == 902 && law_step == 9 && J_rise.numerator == 1 &&
           J_rise.denominator == 4));
}
