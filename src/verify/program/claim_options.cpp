#include "verify/program/claim_options.hpp"

#include <algorithm>
#include <array>
#include <regex>
#include <string_view>

#include "verify/format/section.hpp"

namespace dumbbell_verify {
namespace {

/// RATIO of the command line, exactly.
mpq_class parse_ratio(const std::string& text) {
    static const std::regex decimal("([0-9]+)(?:\\.([0-9]+))?(?:[eE]([+-]?)0*([0-9]{1,4}))?");
    static const std::regex fraction("([0-9]+)/([0-9]+)");
    std::smatch part;
    mpz_class top, bottom = 1;
    if (text.size() <= 1000 && std::regex_match(text, part, fraction)) {
        top = mpz_class(part.str(1), 10);
        bottom = mpz_class(part.str(2), 10);
    } else if (text.size() <= 1000 && std::regex_match(text, part, decimal)) {
        const unsigned long exponent = part[4].matched ? std::stoul(part.str(4)) : 0;
        if (exponent > 1000) throw std::invalid_argument("an exponent beyond 1000: " + text.substr(0, 60));
        top = mpz_class(part.str(1) + part.str(2), 10);
        mpz_class power;
        mpz_ui_pow_ui(power.get_mpz_t(), 10, exponent);
        (part.str(3) == "-" ? bottom : top) *= power;
        mpz_ui_pow_ui(power.get_mpz_t(), 10, static_cast<unsigned long>(part[2].length()));
        bottom *= power;
    }
    if (top == 0 || bottom == 0)
        throw std::invalid_argument("not a mass ratio: `" + text.substr(0, 60) + "`");
    mpq_class ratio(top, bottom);
    ratio.canonicalize();
    return ratio;
}

/// The interval of mass ratios >= 1 that RATIO or LO:HI stands for, exactly; below 1 the masses are swapped.
std::pair<mpq_class, mpq_class> parse_ratios(const std::string& text) {
    const std::size_t colon = text.find(':');
    const mpq_class lo = parse_ratio(text.substr(0, colon));
    const mpq_class hi = colon == std::string::npos ? lo : parse_ratio(text.substr(colon + 1));
    if (lo > hi) throw std::invalid_argument("LO:HI needs LO <= HI: " + text.substr(0, 60));
    if (lo < 1 && hi > 1)
        throw std::invalid_argument("a range across 1: split it at 1: " + text.substr(0, 60));
    return lo < 1 ? std::pair<mpq_class, mpq_class>(1 / hi, 1 / lo) : std::pair(lo, hi);
}

}  // namespace

bool claim_option(Words& words, Settings& settings) {
    constexpr std::array<std::string_view, 6> names{"--ratio",   "--max",   "--min",
                                                    "--exactly", "--scene", "--claim"};
    const std::string& name = words.option;
    if (std::find(names.begin(), names.end(), name) == names.end()) return false;
    words.once();
    if (words.seen("--exactly") && (words.seen("--max") || words.seen("--min")))
        throw std::invalid_argument("--exactly N is --max N and --min N: give it without them");
    constexpr std::uint64_t any = 999'999'999'999'999'999;
    Collisions& demand = settings.demand;
    if (name == "--ratio") demand.ratios = parse_ratios(words.value());
    if (name == "--max") demand.most = words.number(0, any);
    if (name == "--min") demand.least = words.number(0, any);
    if (name == "--exactly") demand.most = demand.least = words.number(0, any);
    if (name == "--scene") {
        settings.scene = words.value();
        const auto known = sections();
        if (std::none_of(known.begin(), known.end(),
                         [&](const Section* s) { return s->scene == settings.scene; }))
            throw std::invalid_argument("--scene is dumbbell, hybrid or wedge, not `" +
                                        settings.scene.substr(0, 60) + "`");
    }
    if (name == "--claim") {
        settings.claim = words.value();
        if (settings.claim != "collisions" && settings.claim != "initial-conditions" &&
            !adiabatic_kind(settings.claim))
            throw std::invalid_argument(
                "--claim is collisions, initial-conditions, adiabatic-bounce, adiabatic-run, "
                "adiabatic-scattering or adiabatic-printed");
    }
    return true;
}

std::string demand_text(const Settings& settings) {
    const Collisions& demand = settings.demand;
    std::string text;
    if (demand.ratios) text = " ratio=" + to_string(demand.ratios->first, demand.ratios->second);
    if (demand.most) text += " max=" + std::to_string(*demand.most);
    if (demand.least) text += " min=" + std::to_string(*demand.least);
    if (settings.check != all_pieces && settings.check != Pieces{})
        text += " pieces=" + std::to_string(settings.check.first) + "-" + std::to_string(settings.check.last);
    return text;
}

}  // namespace dumbbell_verify
