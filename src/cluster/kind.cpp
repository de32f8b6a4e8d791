#include "cluster/kind.hpp"

#include <fmt/format.h>

#include "arith/error.hpp"
#include "arith/printable.hpp"
#include "cluster/adiabatic_kind.hpp"
#include "cluster/collisions_kind.hpp"
#include "cluster/critical_kind.hpp"
#include "cluster/verified_kind.hpp"
#include "cluster/verifier_program.hpp"

namespace dumbbell {

Judgement Kind::judge(const Order& order, const std::string& folder, const std::string& file,
                      Scrutiny scrutiny) const {
    try {
        const std::string reason = scrutiny == Scrutiny::proof ? refutation(order, folder, file) : "";
        return reason.empty() ? form(order, file) : Judgement{Judgement::Verdict::wrong, reason};
    } catch (const NoVerdict& error) {
        return {Judgement::Verdict::none, error.what()};
    } catch (const InputError& error) {
        return {Judgement::Verdict::wrong, error.what()};
    }
}

void Kind::require_tiling(bool tiles) {
    if (!tiles) {
        throw InputError("the results do not tile the claim: run the campaign again, and merge then");
    }
}

const Kind& kind_named(std::string_view name) {
    if (name == "adiabatic") {
        return adiabatic_kind();
    }
    if (name == "collisions") {
        return collisions_kind();
    }
    if (name == "critical") {
        return critical_kind();
    }
    if (name == "verified") {
        return verified_kind();
    }
    throw InputError(fmt::format("there are no campaigns of the kind '{}'", printable(name, 40)));
}

}  // namespace dumbbell
