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

/// Of a gap, 0 <= REL < 1.
mpq_class parse_width(const std::string& text) {
    if (text == "0") return 0;
    mpq_class width = parse_ratio(text);
    if (width >= 1) throw std::invalid_argument("--gap is a width below 1, not " + text.substr(0, 60));
    return width;
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
void state_body(const ClaimWords& words, Settings& settings) {
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
        const auto body = rod(q.first, *mass == "0" ? mpq_class(0) : parse_ratio(*mass));
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
        throw std::invalid_argument("a bound for a body needs --rho and --inertia, or --coin");
}

bool is_about(const std::string& claim, std::string_view option) {
    if (option == "--scene" || option == "--claim") return true;
    if (claim == "initial-conditions" || claim == "incoming")
        return option == "--ratio" || option == "--max" || option == "--min" || option == "--exactly";
    return claim.empty() || claim == "collisions";
}

}  // namespace

bool claim_option(Arguments& given, ClaimWords& words) {
    constexpr std::array<std::string_view, 13> names{
        "--ratio", "--max",     "--min",  "--exactly",  "--gap",   "--gaps", "--heavy-at-most",
        "--rho",   "--inertia", "--coin", "--rod-mass", "--scene", "--claim"};
    const std::string& name = given.option;
    if (std::find(names.begin(), names.end(), name) == names.end()) return false;
    given.once();
    words[name] = name == "--coin" && given.word == name ? "" : given.value();
    if (name == "--coin" && given.word != name) throw std::invalid_argument("--coin has no value");
    return true;
}

void state_claim(const ClaimWords& words, Settings& settings) {
    Collisions& demand = settings.demand;
    if (const auto* scene = find(words, "--scene")) {
        settings.scene = *scene;
        const auto known = sections();
        if (std::none_of(known.begin(), known.end(), [&](const Section* s) { return s->scene == *scene; }))
            throw std::invalid_argument("--scene is dumbbell, hybrid, wedge or body, not `" +
                                        scene->substr(0, 60) + "`");
    }
    if (const auto* claim = find(words, "--claim")) {
        settings.claim = *claim;
        if (*claim != "collisions" && *claim != "initial-conditions" && *claim != "incoming" &&
            *claim != "law" && !adiabatic::kind_named(*claim))
            throw std::invalid_argument(
                "--claim is collisions, initial-conditions, incoming, adiabatic-bounce, adiabatic-run, "
                "adiabatic-scattering or law");
    }
    for (const auto& [option, value] : words)
        if (!is_about(settings.claim, option))
            throw std::invalid_argument(option + " does not fit --claim " + settings.claim);
    if (words.contains("--exactly") && (words.contains("--max") || words.contains("--min")))
        throw std::invalid_argument("--exactly N is --max N and --min N: give it without them");
    for (const char* option : {"--max", "--min", "--exactly"})
        if (const auto* text = find(words, option)) {
            const std::string_view name = option;
            const mpz_class number = parse_count(option, *text);
            if (name != "--min") demand.most = number;
            if (name != "--max") demand.least = number;
        }
    if (const auto* gap = find(words, "--gap")) demand.gap = parse_width(*gap);
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
}

const Collisions& own_demand(const Settings& settings) {
    static const Collisions nothing;
    return settings.together ? nothing : settings.demand;
}

std::string demand_text(const Settings& settings, const Collisions& demand) {
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
    return text;
}

std::string not_demanded(const Settings& settings, const Proof& proof) {
    const Collisions& demand = settings.demand;
    if (!proof.section || demand_text(settings, demand).empty()) return "";
    const auto [from, to] = proof.claim.question();
    const bool is_body = proof.claim.rho.has_value(), exact = demand.most && demand.most == demand.least;
    std::string names;
    const auto add = [&](bool lacks, const char* name) {
        if (lacks) names += (names.empty() ? "" : ",") + std::string(name);
    };
    add(!demand.ratios, is_body ? "inertia" : "ratio");
    add(is_body && !demand.rhos, "rho");
    add(!demand.most, "max");
    add(!demand.least, "min");
    add(!demand.gap && !exact && from < to, "gap");
    add(!demand.gaps_at_most && !exact && from < to, "gaps");
    add(proof.heavy_once && !settings.heavy_once, "heavy-at-most");
    return names;
}

}  // namespace dumbbell_verify
