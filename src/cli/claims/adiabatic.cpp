#include "cli/claims/adiabatic.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>

#include "adiabatic/prove.hpp"
#include "base/error.hpp"
#include "number/ratio_argument.hpp"
#include "starts/argument.hpp"

namespace dumbbell {
namespace {

constexpr std::size_t most_statements = 100'000;

std::vector<std::string> split_list(const std::string& text) {
    std::vector<std::string> parts;
    for (std::size_t from = 0; from <= text.size();) {
        const std::size_t comma = std::min(text.find(',', from), text.size());
        parts.push_back(text.substr(from, comma - from));
        from = comma + 1;
    }
    return parts;
}

std::vector<Rational> parse_list(const char* option, const std::string& text) {
    std::vector<Rational> numbers;
    for (const std::string& part : split_list(text)) {
        numbers.push_back(parse_number(option, part));
    }
    return numbers;
}

int parse_exponent(const Rational& k) {
    const Rational sixteenths = k * 16;
    if (k < 0 || k > 1 || denominator(sixteenths) != 1) {
        throw InputError("--k must be a multiple of 1/16 from 0 to 1, for example 1/2 or 0.25");
    }
    return sixteenths.convert_to<int>();
}

std::string default_margin(AdiabaticClaim claim) {
    return claim == AdiabaticClaim::bounce ? "1" : claim == AdiabaticClaim::run ? "3/10" : "1/2";
}

void require_applicable(const AdiabaticWords& words, AdiabaticClaim claim) {
    const auto refuse = [&](const char* option, const char* where) {
        throw InputError(fmt::format("{} is for {} only", option, where));
    };
    if (words.exponents && words.theorem != "cor3.2") {
        refuse("--k", "--theorem cor3.2");
    }
    if (words.y && (claim == AdiabaticClaim::scattering || claim == AdiabaticClaim::printed)) {
        refuse("--y", "lemma3.1, cor3.2 and thm3.3");
    }
}

}  // namespace

AdiabaticClaim claim_of(const AdiabaticWords& claim) {
    return claim.theorem == "thm3.3"    ? AdiabaticClaim::run
           : claim.theorem == "thm3.5"  ? AdiabaticClaim::scattering
           : claim.theorem == "printed" ? AdiabaticClaim::printed
                                        : AdiabaticClaim::bounce;
}

void add_adiabatic_options(CLI::App& command, AdiabaticWords& claim, Deltas deltas) {
    const bool is_list = deltas == Deltas::list;
    command
        .add_option("--delta", claim.delta,
                    is_list ? "square root of the light mass, or closed range D1:D2; or a list of them"
                            : "square root of the light mass, or closed range D1:D2")
        ->required()
        ->type_name(is_list ? "D|D1:D2[,...]" : "D|D1:D2");
    command.add_option("--theorem", claim.theorem, "the statement")
        ->check(CLI::IsMember({"lemma3.1", "cor3.2", "thm3.3", "thm3.5", "printed"}))
        ->capture_default_str();
    command
        .add_option("--y", claim.y,
                    "heights of the centre of mass before the first collision; default 0:1, thm3.3: 0:0.9")
        ->type_name("Y1:Y2");
    command
        .add_option(
            "--phi-margin", claim.margins,
            "distance from the vertical: m of m delta^k (default 1), u_* (thm3.3: 0.3) or c of c sqrt(delta) "
            "(thm3.5, printed: 1/2); or a list of them")
        ->type_name("M[,M...]");
    command
        .add_option("--k", claim.exponents, "cor3.2: the exponent, a multiple of 1/16 from 0 to 1; or a list")
        ->type_name("K[,K...]");
    command.add_option("--accuracy", claim.accuracy, "of the bound over what is attained, relative")
        ->type_name("A")
        ->capture_default_str();
}

std::vector<AdiabaticHypotheses> statements_of(const AdiabaticWords& claim, Deltas deltas) {
    AdiabaticHypotheses of;
    of.claim = claim_of(claim);
    require_applicable(claim, of.claim);
    const auto ranges =
        deltas == Deltas::list ? split_list(claim.delta) : std::vector<std::string>{claim.delta};
    const auto exponents = parse_list("--k", claim.exponents.value_or("1/2"));
    const auto margins = parse_list("--phi-margin", claim.margins.value_or(default_margin(of.claim)));
    // Each list fits on a command line, so the product fits a number.
    if (ranges.size() * exponents.size() * margins.size() > most_statements) {
        throw InputError(
            fmt::format("the lists make more than {} statements: take them in parts", most_statements));
    }
    const char* heights = of.claim == AdiabaticClaim::run ? "0:0.9" : "0:1";
    of.heights = parse_quantity("--y", claim.y.value_or(heights));
    std::vector<AdiabaticHypotheses> result;
    for (const std::string& range : ranges) {
        of.delta = parse_quantity("--delta", range);
        for (const Rational& k : exponents) {
            of.exponent = parse_exponent(k);
            for (const Rational& margin : margins) {
                of.margin = margin;
                require_sensible(of);
                result.push_back(of);
            }
        }
    }
    return result;
}

Rational accuracy_of(const AdiabaticWords& claim) {
    const Rational accuracy = parse_number("--accuracy", claim.accuracy);
    if (accuracy <= 0 || accuracy > 1) {
        throw InputError("--accuracy must be greater than 0 and at most 1, for example 0.1 for 10 %");
    }
    return accuracy;
}

}  // namespace dumbbell
