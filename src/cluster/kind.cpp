#include "cluster/kind.hpp"

#include <fmt/format.h>

#include "arith/error.hpp"
#include "arith/printable.hpp"
#include "cluster/adiabatic_kind.hpp"
#include "cluster/collisions_kind.hpp"
#include "cluster/critical_kind.hpp"
#include "cluster/verified_kind.hpp"

namespace dumbbell {

Judgement Kind::judge(const Order& order, const std::string& folder, const std::string& file,
                      Scrutiny scrutiny) const {
    try {
        const std::string reason = scrutiny == Scrutiny::proof ? refutation(order, folder, file) : "";
        return reason.empty() ? form(order, file) : Judgement{Judgement::Verdict::wrong, reason};
    } catch (const InputError& error) {
        return {Judgement::Verdict::wrong, error.what()};
    }
}

const Kind& kind_named(std::string_view name) {
    static const AdiabaticKind adiabatic;
    static const CollisionsKind collisions;
    static const CriticalKind critical;
    static const VerifiedKind verified;
    if (name == "adiabatic") {
        return adiabatic;
    }
    if (name == "collisions") {
        return collisions;
    }
    if (name == "critical") {
        return critical;
    }
    if (name == "verified") {
        return verified;
    }
    throw InputError(fmt::format("there are no campaigns of the kind '{}'", printable(name, 40)));
}

}  // namespace dumbbell
