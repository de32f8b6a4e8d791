#include "verify/program/number_options.hpp"

namespace dumbbell_verify {
namespace {

/// An option, the kinds of claims that it is for, and what stands between two numbers of its value.
struct Row {
    std::string_view name, kinds, between;
};
constexpr std::string_view box = "initial-conditions", starts = "initial-conditions or incoming",
                           counts = "collisions, initial-conditions or incoming",
                           invariant = "adiabatic-bounce, adiabatic-run or adiabatic-scattering";
/// In the order in which they are named where they are missing.
constexpr Row table[] = {{"phi", box, ":"},
                         {"phidot", box, ":"},
                         {"y", box, ":"},
                         {"ydot", box, ":"},
                         {"ratio", counts, ""},
                         {"max", counts, ""},
                         {"min", counts, ""},
                         {"decided", starts, ""},
                         {"delta", invariant, ":"},
                         {"heights", "adiabatic-bounce or adiabatic-run", ":"},
                         {"margin", invariant, ""},
                         {"exponent", "adiabatic-bounce", ""},
                         {"constant", invariant, ","},
                         {"attained", invariant, ","}};

bool is_demanded(const Row& row, const Request& request) {
    const Collisions& of = request.demand;
    return row.name == "ratio" ? of.ratios.has_value()
           : row.name == "max" ? of.most.has_value()
           : row.name == "min" ? of.least.has_value()
                               : request.numbers.contains(row.name);
}

/// -1.5, 0 or 2/3, exactly.
mpq_class parse_signed(std::string_view text) {
    const bool is_negative = take(text, '-');
    const auto number = parse_rational(std::string(text));
    if (!number) throw std::invalid_argument("not a number: `" + std::string(text.substr(0, 60)) + "`");
    return is_negative ? mpq_class(-*number) : *number;
}

}  // namespace

bool number_option(Arguments& given, starts::Numbers& numbers) {
    for (const auto& [name, kinds, between] : table) {
        if (given.option != "--" + std::string(name) || kinds == counts) continue;
        given.once();
        const std::string text = given.value();
        const std::size_t at = between.empty() ? std::string::npos : text.find(between);
        const mpq_class first = parse_signed(text.substr(0, at)),
                        second = at == std::string::npos ? first : parse_signed(text.substr(at + 1));
        if (between == ":" && first > second)
            throw std::invalid_argument("LO:HI needs LO <= HI: " + text.substr(0, 60));
        if (name == "decided" && (first < 0 || first > 1))
            throw std::invalid_argument("--decided is a share from 0 to 1, not " + text.substr(0, 60));
        numbers[name] = {first, second};
        return true;
    }
    return false;
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

std::string numbers_text(const starts::Numbers& numbers) {
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
    const std::string kind = proof.of_other([](const auto& it) { return it.kind_name(); }).value_or("none");
    const Collisions& of = request.demand;
    std::string names;
    bool is_any = !request.claim.empty() || !request.scene.empty();
    for (const Row& row : table) {
        if (row.kinds.find(kind) == std::string_view::npos) continue;
        const bool is_whole = row.name == "decided" && of.most && of.most == of.least;
        if (is_demanded(row, request))
            is_any = true;
        else if (!is_whole)
            names += std::string(names.empty() ? "" : between) + std::string(row.name);
    }
    return is_any ? names : "";
}

}  // namespace dumbbell_verify
