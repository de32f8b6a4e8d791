#include "verify/law/claim.hpp"

namespace dumbbell_verify {

std::string Law::text() const {
    return "claim=law steps=" + std::to_string(first_step) + ":" + std::to_string(last_step) +
           " from=" + to_string(step(law_step).lo, step(law_step).hi) + " least=0.980 most=2.115";
}

std::string Law::paragraph() {
    return "  N*(q) is the greatest number of collisions at the mass ratio q, q_c(N) the ratio beyond which "
           "it is\n"
           "  at least N. For every q >= q_c(9):\n"
           "  2 + floor(C sqrt q - c0 q^(-1/4)) <= N*(q) <= 2 + floor(C sqrt q),\n"
           "  C = 0.885595..., c0 = 0.205811...; and 0.980 <= N*(q) - C sqrt q <= 2.115 for every q >= 1.\n";
}

std::string Law::json() const {
    return "{\"kind\":\"law\",\"steps\":{\"first\":" + std::to_string(first_step) +
           ",\"last\":" + std::to_string(last_step) + "},\"from\":{\"lo\":\"" + to_string(step(law_step).lo) +
           "\",\"hi\":\"" + to_string(step(law_step).hi) +
           "\"},\"excess\":{\"lo\":\"49/50\",\"hi\":\"423/200\"}}";
}

std::string LawAtRatio::missing(const Collisions& demand) const {
    if (demand.ratios && (demand.ratios->first != q || demand.ratios->second != q))
        return covered_part(q, q, demand.ratios->first, demand.ratios->second);
    const auto not_proved = [&](const char* bound, const mpz_class& n) {
        return "not proved: at " + std::string(bound) + " " + n.get_str() + " collisions at the mass ratio " +
               to_string(q);
    };
    if (demand.most && upper > *demand.most) return not_proved("most", *demand.most);
    if (demand.least && lower < *demand.least) return not_proved("least", *demand.least);
    return "";
}

std::string LawAtRatio::text() const {
    return "claim=" + std::string(kind) + " ratio=" + to_string(q) + " upper=" + upper.get_str() +
           " lower=" + lower.get_str() + " law=" + law;
}

std::string LawAtRatio::paragraph() {
    return "  This rests on the law for every mass ratio (proofs/law.md), whose certificate, law=, was "
           "verified "
           "first.\n";
}

std::string LawAtRatio::json() const {
    return R"({"kind":")" + std::string(kind) + R"(","ratio":{"lo":")" + to_string(q) + R"(","hi":")" +
           to_string(q) + R"("},"upper":)" + json_count(upper) + R"(,"lower":)" + json_count(lower) +
           R"(,"law":")" + law + "\"}";
}

}  // namespace dumbbell_verify
