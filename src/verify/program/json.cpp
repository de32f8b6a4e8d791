#include "verify/program/json.hpp"

#include <algorithm>
#include <optional>

#include "verify/core/section.hpp"
#include "verify/machine/decimals.hpp"
#include "verify/machine/integer.hpp"
#include "verify/program/claim_options.hpp"
#include "verify/program/escape.hpp"

namespace dumbbell_verify {

std::string json_count(const mpz_class& n) { return fits(n, 53) ? n.get_str() : '"' + n.get_str() + '"'; }

namespace {

struct Member {
    std::string_view name;
    std::string value;  ///< JSON
};
std::string object(const std::vector<Member>& members) {
    std::string text;
    for (const Member& member : members)
        text += (text.empty() ? "" : ",") + json_string(member.name) + ":" + member.value;
    return "{" + text + "}";
}
std::string number(const std::optional<std::uint64_t>& n) {
    return n ? json_count(mpz_class(std::to_string(*n))) : "null";
}
std::string count(const std::optional<mpz_class>& n) { return n ? json_count(*n) : "null"; }
std::string string_unless(bool absent, const std::string& text) {
    return absent ? "null" : json_string(text);
}
std::string range(const mpq_class& lo, const mpq_class& hi) {
    return object({{"lo", json_string(to_string(lo))}, {"hi", json_string(to_string(hi))}});
}
std::string range(const std::optional<Range>& x) { return x ? range(x->first, x->second) : "null"; }

/// In seconds of a core.
std::string work(bool known, const Proof& proof) {
    constexpr std::uint64_t per_millisecond = units_per_second / 1000;
    if (!known) return "null";
    const std::uint64_t n = (proof.work + per_millisecond - 1) / per_millisecond;
    const std::string rest = std::to_string(1000 + n % 1000);
    return std::to_string(n / 1000) + "." + rest.substr(1);
}
std::string fraction(const std::optional<mpq_class>& x) { return x ? json_string(to_string(*x)) : "null"; }
std::string demand(const Request& settings) {
    const Collisions& d = settings.demand;
    const bool is_body = settings.scene == "body";
    std::vector<Member> numbers;
    for (const auto& [name, both] : settings.numbers)
        numbers.push_back({name, range(both.first, both.second)});
    return object({{"ratio", is_body ? "null" : range(d.ratios)},
                   {"inertia", is_body ? range(d.ratios) : "null"},
                   {"rho", range(d.rhos)},
                   {"max", count(d.most)},
                   {"min", count(d.least)},
                   {"gap", fraction(d.gap)},
                   {"gaps", count(d.gaps_at_most)},
                   {"heavy_at_most", settings.heavy_once ? "1" : "null"},
                   {"scene", string_unless(settings.scene.empty(), settings.scene)},
                   {"claim", string_unless(settings.claim.empty(), settings.claim)},
                   {"numbers", object(numbers)}});
}

std::string claim(const Result& result) {
    if (!result.is_right()) return "null";
    if (result.proof.other) return result.proof.other->json();
    const Collisions& c = result.proof.claim;
    const auto [from, to] = c.question();
    const auto& share = result.proof.decided;
    std::vector<Member> members{{"scene", json_string(result.proof.section->scene)},
                                {"ratio", range(c.lo, c.hi)},
                                {"rho", range(c.rho)},
                                {"upper", count(c.upper)},
                                {"lower", json_count(c.lower)},
                                {"pieces", number(c.pieces)},
                                {"gaps", number(c.gaps)},
                                {"open", number(c.open)},
                                {"widest_gap", from < to ? fraction(c.whole().widest) : "null"},
                                {"heavy_at_most", result.proof.heavy_once ? "1" : "null"}};
    if (share) members.push_back({"decided", json_string(decimals(*share, false))});
    return object(members);
}

}  // namespace

std::string json(const Result& result) {
    const Failure& why = result.why;
    const Request& settings = result.job->settings;
    const bool right = result.is_right(), verified = why.verdict == Verdict::verified;
    std::vector<Member> leaves, coverage;
    for (const Tally& tally : right ? result.proof.tallies : std::vector<Tally>()) {
        leaves.push_back({tally.name, number(tally.lines)});
        coverage.push_back({tally.name, std::to_string(tally.covered / std::max(1.0, result.proof.roots))});
    }
    return object({{"file", json_string(result.job->file)},
                   {"verdict", json_string(verdict_name(why.verdict))},
                   {"claim", claim(result)},
                   {"sha256", string_unless(!right, result.proof.digest)},
                   {"schema", json_string("dumbbell-verify-1")},
                   {"demand", demand(settings)},
                   {"leaves", object(leaves)},
                   {"coverage", object(coverage)},
                   {"work", work(right, result.proof)},
                   {"line", why.line > 0 ? number(why.line) : "null"},
                   {"code", string_unless(verified, why.code)},
                   {"reason", string_unless(verified, why.text)}});
}

}  // namespace dumbbell_verify
