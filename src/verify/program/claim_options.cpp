#include "verify/program/claim_options.hpp"

#include <algorithm>
#include <array>
#include <string_view>

#include "verify/core/section.hpp"
#include "verify/program/number_options.hpp"

namespace dumbbell_verify {
namespace {

/// Of the format, whether this build has them or not.
constexpr std::array<std::string_view, 7> kinds{
    "collisions",    "initial-conditions",   "incoming", "adiabatic-bounce",
    "adiabatic-run", "adiabatic-scattering", "law"};

/// RATIO of the command line, exactly.
mpq_class parse_ratio(const std::string& text) {
    const auto ratio = parse_rational(text);
    if (!ratio || *ratio == 0)
        throw std::invalid_argument("not a positive ratio: `" + text.substr(0, 60) + "`");
    return *ratio;
}

/// The interval of ratios that RATIO or LO:HI stands for, exactly.
Range parse_range(const std::string& text) {
    const std::size_t colon = text.find(':');
    const mpq_class lo = parse_ratio(text.substr(0, colon));
    const mpq_class hi = colon == std::string::npos ? lo : parse_ratio(text.substr(colon + 1));
    if (lo > hi) throw std::invalid_argument("LO:HI needs LO <= HI: " + text.substr(0, 60));
    return {lo, hi};
}

/// The same >= 1: below 1 the masses are swapped, which would change the starts of a box, too.
Range parse_mass_ratios(const std::string& text, bool of_starts) {
    const auto [lo, hi] = parse_range(text);
    if (lo < 1 && hi > 1)
        throw std::invalid_argument("a range across 1: split it at 1: " + text.substr(0, 60));
    if (lo < 1 && of_starts)
        throw std::invalid_argument("starts need a mass ratio of at least 1, heavy/light, not " +
                                    text.substr(0, 60));
    return lo < 1 ? Range(1 / hi, 1 / lo) : Range(lo, hi);
}

mpz_class parse_count(const std::string& option, const std::string& text) {
    if (is_natural(text, longest_integer)) return mpz_class(text);
    throw std::invalid_argument(option + " needs a number of at most 2100 digits, not `" +
                                text.substr(0, 60) + "`");
}

/// A relative width, of a gap below 1, or a rod's share of the mass.
mpq_class parse_number(const std::string& option, const std::string& text) {
    const auto number = parse_rational(text);
    if (!number) throw std::invalid_argument(option + " needs a number, not `" + text.substr(0, 60) + "`");
    if (option == "--gap" && *number >= 1)
        throw std::invalid_argument("--gap is a width below 1, not " + text.substr(0, 60));
    return *number;
}

/// rho and Q = (d1/k)^2 of the dumbbell with mass ratio q whose rod has mu times the mass of its ends: L70
/// (d).
std::pair<mpq_class, mpq_class> rod(const mpq_class& q, const mpq_class& mu) {
    const mpq_class d1 = (2 * q / (1 + q) + mu) / (2 * (1 + mu));
    const mpq_class rho = (2 + mu * (1 + q)) / (2 * q + mu * (1 + q));
    return {rho, d1 * d1 / (d1 * d1 * rho - mu / (6 * (1 + mu)))};
}

const std::string* find(const ClaimWords& words, const char* option) {
    const auto found = words.find(option);
    return found == words.end() ? nullptr : &found->second;
}

/// The options that say which bodies are meant.
void state_body(const ClaimWords& words, Request& settings) {
    Collisions& demand = settings.demand;
    if (!settings.scene.empty() && settings.scene != "body")
        throw std::invalid_argument("--rho, --inertia, --coin and --rod-mass are about bodies, not --scene " +
                                    settings.scene);
    settings.scene = "body";
    const auto *ratio = find(words, "--ratio"), *mass = find(words, "--rod-mass"),
               *rho = find(words, "--rho"), *inertia = find(words, "--inertia");
    const bool coin = words.contains("--coin");
    if (coin + (mass != nullptr) + (rho || inertia) > 1)
        throw std::invalid_argument(
            "state one body: --rho and --inertia, or --coin, or --ratio and --rod-mass");
    if (mass) {
        const Range q = ratio ? parse_mass_ratios(*ratio, false) : Range(1, 2);
        if (q.first != q.second)
            throw std::invalid_argument("--rod-mass needs one mass ratio: --ratio RATIO");
        const auto body = rod(q.first, parse_number("--rod-mass", *mass));
        demand.rhos = Range(body.first, body.first);
        demand.ratios = Range(body.second, body.second);
    } else if (ratio) {
        throw std::invalid_argument("bodies have no --ratio: their Q is --inertia");
    }
    if (coin) demand.rhos = Range(1, 1), demand.ratios = Range(4, 4);
    if (rho) demand.rhos = parse_range(*rho);
    if (inertia) demand.ratios = parse_range(*inertia);
    if (demand.rhos && demand.rhos->second > 1)
        throw std::invalid_argument("--rho is at most 1, not " + rho->substr(0, 60));
    if ((demand.most || demand.least || demand.gap || demand.gaps_at_most) && !(demand.rhos && demand.ratios))
        throw std::invalid_argument(
            "a bound for a body needs --rho and --inertia, or --coin, or --ratio with --rod-mass");
}

}  // namespace

bool claim_option(Arguments& given, ClaimWords& words) {
    constexpr std::array<std::string_view, 5> others{"--exactly", "--coin", "--rod-mass", "--scene",
                                                     "--claim"};
    const std::string& name = given.option;
    if (!is_claim_option(name) && std::find(others.begin(), others.end(), name) == others.end()) return false;
    given.once();
    words[name] = name == "--coin" && given.word == name ? "" : given.value();
    if (name == "--coin" && given.word != name) throw std::invalid_argument("--coin has no value");
    return true;
}

void state_claim(const ClaimWords& words, Request& settings) {
    Collisions& demand = settings.demand;
    if (const auto* scene = find(words, "--scene")) {
        settings.scene = *scene;
        const auto known = sections();
        if (std::none_of(known.begin(), known.end(), [&](const Section* s) { return s->scene == *scene; }))
            throw std::invalid_argument("--scene is dumbbell or body, not `" + scene->substr(0, 60) + "`");
    }
    if (const auto* claim = find(words, "--claim")) {
        settings.claim = *claim;
        if (std::find(kinds.begin(), kinds.end(), *claim) == kinds.end())
            throw std::invalid_argument(
                "--claim is collisions, initial-conditions, incoming, adiabatic-bounce, adiabatic-run, "
                "adiabatic-scattering or law");
    }
    if (words.contains("--exactly") && (words.contains("--max") || words.contains("--min")))
        throw std::invalid_argument("--exactly N is --max N and --min N: give it without them");
    for (const char* option : {"--max", "--min", "--exactly"})
        if (const auto* text = find(words, option)) {
            const std::string_view name = option;
            const mpz_class number = parse_count(option, *text);
            if (name != "--min") demand.most = number;
            if (name != "--max") demand.least = number;
        }
    if (const auto* gap = find(words, "--gap")) demand.gap = parse_number("--gap", *gap);
    if (const auto* gaps = find(words, "--gaps")) demand.gaps_at_most = parse_count("--gaps", *gaps);
    if (const auto* heavy = find(words, "--heavy-at-most")) {
        if (*heavy != "1") throw std::invalid_argument("--heavy-at-most is 1: no other number is proved");
        settings.heavy_once = true;
    }
    const bool is_body = settings.scene == "body" || words.contains("--rho") || words.contains("--inertia") ||
                         words.contains("--coin") || words.contains("--rod-mass");
    if (is_body)
        state_body(words, settings);
    else if (const auto* ratio = find(words, "--ratio"))
        demand.ratios = parse_mass_ratios(*ratio, settings.claim == "initial-conditions");
    settings.numbers = numbers_of(words);
    require_fitting_kind(settings);
}

std::string demand_text(const Request& settings) {
    const Collisions& demand = settings.demand;
    std::string text;
    const bool both = demand.most && demand.most == demand.least;
    if (demand.ratios)
        text = (settings.scene == "body" ? " demanded-inertia=" : " demanded-ratio=") +
               to_string(demand.ratios->first, demand.ratios->second);
    if (demand.rhos) text += " demanded-rho=" + to_string(demand.rhos->first, demand.rhos->second);
    if (demand.most) text += (both ? " exactly=" : " max=") + demand.most->get_str();
    if (demand.least && !both) text += " min=" + demand.least->get_str();
    if (demand.gap) text += " demanded-gap=" + to_string(*demand.gap);
    if (demand.gaps_at_most) text += " demanded-gaps=" + demand.gaps_at_most->get_str();
    if (settings.heavy_once) text += " demanded-heavy-at-most=1";
    if (!settings.scene.empty()) text += " demanded-scene=" + settings.scene;
    if (!settings.claim.empty()) text += " demanded-claim=" + settings.claim;
    return text + numbers_text(settings.numbers);
}

}  // namespace dumbbell_verify
