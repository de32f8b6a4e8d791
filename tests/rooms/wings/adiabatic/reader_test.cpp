#include "adiabatic/reader.hpp"

#include "adiabatic/writer.hpp"
#include "base/error.hpp"
#include "catch.hpp"
#include "programs/cli/process.hpp"

using namespace dumbbell;
using namespace dumbbell::adiabatic;
using namespace dumbbell_test;

namespace {

Certificate of_claim(Claim claim) {
    const Node outside{std::nullopt, true, 0}, bound{std::nullopt, false, 0}, second{std::nullopt, false, 1};
    Certificate certificate;
    certificate.generator = {"dumbbell", "0.1.0"};
    certificate.hypotheses.claim = claim;
    certificate.hypotheses.delta = {Rational(0), Rational(1, 100)};
    certificate.hypotheses.margin = Rational(3, 10);
    const State state{Rational(1, 2), Rational(1), Rational(1, 100), 63, Rational(31, 2)};
    certificate.attained = {state};
    if (claim == Claim::bounce || claim == Claim::run) {
        certificate.hypotheses.heights = {Rational(0), Rational(9, 10)};
    }
    if (claim == Claim::bounce) {
        certificate.bounds = {Rational(2), Rational(23, 2)};
        certificate.tree = {{Axis::s, false, 0}, bound, outside};
        certificate.hypotheses.exponent = 4;
        certificate.attained.push_back(state);
    } else {
        certificate.bounds = {Rational(17)};
        certificate.classes = {
            {Rational(6, 5), {{Rational(1), Rational(2)}, {Rational(1, 4), Rational(0)}}, {bound}},
            {Rational(7), {}, {{Axis::sigma, false, 0}, outside, bound}}};
        certificate.tree = {{Axis::v, false, 0}, outside, second};
    }
    return certificate;
}

Certificate read_text(const std::string& text) {
    const TemporaryFolder folder;
    write_file(folder / "file.dbc", text);
    return read_certificate(folder / "file.dbc");
}

}  // namespace

TEST_CASE("adiabatic claims of each kind that were written and read are written the same again") {
    for (const Claim claim : {Claim::bounce, Claim::run, Claim::scattering}) {
        const std::string text = render(of_claim(claim)).text;
        CAPTURE(text);
        CHECK(render(read_text(text)).text == text);
    }
}

TEST_CASE("what is no certificate of the adiabatic invariant is refused with file and line") {
    const std::string good = render(of_claim(Claim::run)).text;
    const std::vector<std::pair<std::string, std::string>> changes{
        {"claim adiabatic-run", "claim adiabatic-walk"},
        {"claim adiabatic-run", "claim adiabatic-printed"},
        {"delta 0/1 1/100", "delta 0/1"},
        {"bound 17/1", "bound 17/1 18/1"},
        {"classes 2", "classes 0"},
        {"classes 2", "classes 65"},
        {"class 6/5 2", "class 6/5 5000"},
        {"split v", "split q"},
        {"bound 1\n", "bound\n"},
        {"end\n", "tree\n"},
        {"attained 1/2", "attained x"},
    };
    for (const auto& [from, to] : changes) {
        CAPTURE(from, to);
        CHECK_THROWS_WITH(read_text(replaced(good, from, to)), Contains("file.dbc") && Contains("line"));
    }
}

TEST_CASE("a file about the adiabatic invariant that ends early is refused") {
    const std::string good = render(of_claim(Claim::scattering)).text;
    for (std::size_t length = 0; length < good.find("total"); length += 5) {
        CAPTURE(length);
        CHECK_THROWS_AS(read_text(good.substr(0, length)), InputError);
    }
}
