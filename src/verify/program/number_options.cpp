#include "verify/program/number_options.hpp"

#include <algorithm>

namespace dumbbell_verify {
namespace {

/// An option, the kinds of claims that it is for, and what stands between two numbers of its value.
struct Row {
    std::string_view name, kinds, between;
};
constexpr std::string_view box = "initial-conditions",
                           shares = "collisions (of bodies), initial-conditions or incoming",
                           maximum = "collisions", counts = "collisions, initial-conditions or incoming",
                           invariant = "adiabatic-bounce, adiabatic-run or adiabatic-scattering";
/// In the order in which they are named where they are missing.
constexpr Row table[] = {{"phi", box, ":"},
                         {"phidot", box, ":"},
                         {"y", box, ":"},
                         {"ydot", box, ":"},
                         {"ratio", counts, ""},
                         {"inertia", maximum, ""},
                         {"rho", maximum, ""},
                         {"max", counts, ""},
                         {"min", counts, ""},
                         {"gap", maximum, ""},
                         {"gaps", maximum, ""},
                         {"heavy-at-most", maximum, ""},
                         {"decided", shares, ""},
                         {"delta", invariant, ":"},
                         {"heights", "adiabatic-bounce or adiabatic-run", ":"},
                         {"margin", invariant, ""},
                         {"exponent", "adiabatic-bounce", ""},
                         {"constant", invariant, ","},
                         {"attained", invariant, ","}};

/// Its value goes into Request::numbers.
bool is_number(const Row& row) { return row.kinds != counts && row.kinds != maximum; }

bool is_demanded(const Row& row, const Request& request) {
    const Collisions& of = request.demand;
    const bool is_body = request.scene == "body";
    return row.name == "ratio"           ? of.ratios && !is_body
           : row.name == "inertia"       ? of.ratios && is_body
           : row.name == "rho"           ? of.rhos.has_value()
           : row.name == "max"           ? of.most.has_value()
           : row.name == "min"           ? of.least.has_value()
           : row.name == "gap"           ? of.gap.has_value()
           : row.name == "gaps"          ? of.gaps_at_most.has_value()
           : row.name == "heavy-at-most" ? request.heavy_once
                                         : request.numbers.contains(row.name);
}

/// Could it have been demanded of this file, with something left to say?
bool has_more(const Row& row, const Verified& proof, const Request& request) {
    const bool is_body = proof.claim.rho.has_value(),
               exact = request.demand.most && request.demand.most == request.demand.least;
    if (row.name == "decided") return !exact && (proof.other || proof.decided);
    if (!proof.section) return true;
    const auto [from, to] = proof.claim.question();
    return row.name == "ratio"                          ? !is_body
           : row.name == "inertia" || row.name == "rho" ? is_body
           : row.name == "gap" || row.name == "gaps"    ? !exact && from < to
           : row.name == "heavy-at-most"                ? proof.heavy_once
                                                        : true;
}

/// -1.5, 0 or 2/3, exactly.
mpq_class parse_signed(std::string_view text) {
    const bool is_negative = take(text, '-');
    const auto number = parse_rational(std::string(text));
    if (!number) throw std::invalid_argument("not a number: `" + std::string(text.substr(0, 60)) + "`");
    return is_negative ? mpq_class(-*number) : *number;
}

}  // namespace

bool is_claim_option(std::string_view option) {
    return option.starts_with("--") && std::any_of(std::begin(table), std::end(table), [&](const Row& row) {
               return row.name == option.substr(2);
           });
}

Numbers numbers_of(const ClaimWords& words) {
    Numbers numbers;
    for (const Row& row : table) {
        const auto word = words.find("--" + std::string(row.name));
        if (!is_number(row) || word == words.end()) continue;
        const std::string& text = word->second;
        const std::size_t at = row.between.empty() ? std::string::npos : text.find(row.between);
        const mpq_class first = parse_signed(text.substr(0, at)),
                        second = at == std::string::npos ? first : parse_signed(text.substr(at + 1));
        if (row.between == ":" && first > second)
            throw std::invalid_argument("LO:HI needs LO <= HI: " + text.substr(0, 60));
        if (row.name == "decided" && (first < 0 || first > 1))
            throw std::invalid_argument("--decided is a share from 0 to 1, not " + text.substr(0, 60));
        numbers[row.name] = {first, second};
    }
    return numbers;
}

void require_fitting_kind(const Request& request) {
    const std::string kind = request.claim.empty() ? "collisions" : request.claim;
    for (const Row& row : table) {
        if (!is_demanded(row, request)) continue;
        const auto refuse = [&](std::string_view kinds) {
            throw std::invalid_argument("--" + std::string(row.name) + " is for --claim " +
                                        std::string(kinds));
        };
        if (row.kinds.find(kind) == std::string_view::npos) refuse(row.kinds);
        if (row.between == "," && kind != "adiabatic-bounce") {
            const auto& [first, second] = request.numbers.at(row.name);
            if (first != second) refuse("adiabatic-bounce where it has two numbers");
        }
    }
}

std::string numbers_text(const Numbers& numbers) {
    std::string text;
    for (const Row& row : table) {
        const auto found = numbers.find(row.name);
        if (found == numbers.end()) continue;
        const auto& [first, second] = found->second;
        text += " demanded-" + std::string(row.name) + "=" + to_string(first);
        if (row.between == ":" || first != second) text += std::string(row.between) + to_string(second);
    }
    return text;
}

std::string not_demanded(const Verified& proof, const Request& request, std::string_view between) {
    const std::string_view kind = proof.other ? proof.other->kind_name() : "collisions";
    std::string names;
    bool is_any = !request.claim.empty() || !request.scene.empty();
    for (const Row& row : table) {
        if (row.kinds.find(kind) == std::string_view::npos) continue;
        if (is_demanded(row, request))
            is_any = true;
        else if (has_more(row, proof, request))
            names += std::string(names.empty() ? "" : between) + std::string(row.name);
    }
    return is_any ? names : "";
}

}  // namespace dumbbell_verify
