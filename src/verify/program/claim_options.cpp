#include "verify/program/claim_options.hpp"

#include <algorithm>
#include <array>
#include <string_view>

#include "verify/core/section.hpp"

namespace dumbbell_verify {
namespace {

/// What [0-9]+/[0-9]+ stands for; 0 of other texts, and if the denominator is 0.
mpq_class parse_fraction(std::string_view rest) {
    const std::string top = take_digits(rest);
    const bool is_fraction = take(rest, '/');
    const std::string bottom = take_digits(rest);
    if (top.empty() || !is_fraction || bottom.empty() || !rest.empty()) return 0;
    const mpz_class denominator(bottom, 10);
    return denominator == 0 ? mpq_class(0) : mpq_class(mpz_class(top, 10), denominator);
}

/// RATIO of the command line, exactly.
mpq_class parse_ratio(const std::string& text) {
    mpq_class ratio = 0;
    if (text.size() <= 2100)
        ratio = text.find('/') < text.size() ? parse_fraction(text) : parse_decimal(text).value_or(0);
    if (ratio == 0) throw std::invalid_argument("not a positive ratio: `" + text.substr(0, 60) + "`");
    ratio.canonicalize();
    return ratio;
}

/// The interval of ratios that RATIO or LO:HI stands for, exactly.
Range parse_range(const std::string& text) {
    const std::size_t colon = text.find(':');
    const mpq_class lo = parse_ratio(text.substr(0, colon));
    const mpq_class hi = colon == std::string::npos ? lo : parse_ratio(text.substr(colon + 1));
    if (lo > hi) throw std::invalid_argument("LO:HI needs LO <= HI: " + text.substr(0, 60));
    return {lo, hi};
}

/// The same >= 1: below 1 the masses are swapped.
Range parse_mass_ratios(const std::string& text) {
    const auto [lo, hi] = parse_range(text);
    if (lo < 1 && hi > 1)
        throw std::invalid_argument("a range across 1: split it at 1: " + text.substr(0, 60));
    return lo < 1 ? Range(1 / hi, 1 / lo) : Range(lo, hi);
}

Range parse_rhos(const std::string& text) {
    Range rhos = parse_range(text);
    if (rhos.second > 1) throw std::invalid_argument("--rho is at most 1, not " + text.substr(0, 60));
    return rhos;
}

}  // namespace

bool claim_option(Arguments& given, Settings& settings) {
    constexpr std::array<std::string_view, 7> names{"--ratio",   "--rho",   "--max",  "--min",
                                                    "--exactly", "--scene", "--claim"};
    const std::string& name = given.option;
    if (std::find(names.begin(), names.end(), name) == names.end()) return false;
    given.once();
    if (given.seen("--exactly") && (given.seen("--max") || given.seen("--min")))
        throw std::invalid_argument("--exactly N is --max N and --min N: give it without them");
    Collisions& demand = settings.demand;
    if (name == "--ratio") demand.ratios = parse_mass_ratios(given.value());
    if (name == "--rho") demand.rhos = parse_rhos(given.value());
    if (name == "--max") demand.most = given.count();
    if (name == "--min") demand.least = given.count();
    if (name == "--exactly") demand.most = demand.least = given.count();
    if (name == "--scene") {
        settings.scene = given.value();
        const auto known = sections();
        if (std::none_of(known.begin(), known.end(),
                         [&](const Section* s) { return s->scene == settings.scene; }))
            throw std::invalid_argument("--scene is dumbbell, hybrid, wedge or body, not `" +
                                        settings.scene.substr(0, 60) + "`");
    }
    if (name == "--claim") {
        settings.claim = given.value();
        if (settings.claim != "collisions" && settings.claim != "initial-conditions" &&
            settings.claim != "incoming" && settings.claim != "law" && !adiabatic::kind_named(settings.claim))
            throw std::invalid_argument(
                "--claim is collisions, initial-conditions, incoming, adiabatic-bounce, adiabatic-run, "
                "adiabatic-scattering or law");
    }
    return true;
}

void require_whole(const Settings& settings) {
    const Collisions& demand = settings.demand;
    const bool is_body = settings.scene == "body";
    if (demand.rhos && !is_body) throw std::invalid_argument("--rho is about --scene body: give both");
    if (is_body && (demand.most || demand.least) && !demand.rhos)
        throw std::invalid_argument("a bound for --scene body needs --rho, such as --rho 1");
}

const Collisions& own_demand(const Settings& settings) {
    static const Collisions nothing;
    return settings.together ? nothing : settings.demand;
}

std::string demand_text(const Settings& settings, const Collisions& demand) {
    std::string text;
    if (demand.ratios) text = " demanded-ratio=" + to_string(demand.ratios->first, demand.ratios->second);
    if (demand.rhos) text += " demanded-rho=" + to_string(demand.rhos->first, demand.rhos->second);
    const bool both = demand.most && demand.most == demand.least;
    if (demand.most) text += (both ? " exactly=" : " max=") + demand.most->get_str();
    if (demand.least && !both) text += " min=" + demand.least->get_str();
    if (!settings.scene.empty()) text += " demanded-scene=" + settings.scene;
    if (!settings.claim.empty()) text += " demanded-claim=" + settings.claim;
    return text;
}

}  // namespace dumbbell_verify
