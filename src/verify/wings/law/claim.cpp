#include "verify/wings/law/claim.hpp"

namespace dumbbell_verify::law {

std::string Claim::text() const {
    return "claim=law steps=" + std::to_string(first_step) + ":" + std::to_string(last_step) +
           " from=" + to_string(from.first, from.second) + " least=0.980 most=2.115";
}

std::string Claim::paragraph() const {
    return "  N*(q) is the greatest number of collisions at the mass ratio q, q_c(N) the ratio beyond which "
           "it is\n"
           "  at least N. For every q >= q_c(9):\n"
           "  2 + floor(C sqrt q - c0 q^(-1/4)) <= N*(q) <= 2 + floor(C sqrt q),\n"
           "  C = 0.885595..., c0 = 0.205811...; and 0.980 <= N*(q) - C sqrt q <= 2.115 for every q >= 1.\n";
}

std::string Claim::json() const {
    return "{\"kind\":\"law\",\"steps\":{\"first\":" + std::to_string(first_step) +
           ",\"last\":" + std::to_string(last_step) + "},\"from\":{\"lo\":\"" + to_string(from.first) +
           "\",\"hi\":\"" + to_string(from.second) + "\"},\"excess\":{\"lo\":\"49/50\",\"hi\":\"423/200\"}}";
}

}  // namespace dumbbell_verify::law
