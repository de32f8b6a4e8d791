// One certificate file of any claim kind.
#pragma once
#include <optional>
#include <string>
#include <type_traits>
#include <variant>

#include "verify/adiabatic/demand.hpp"
#include "verify/core/settings.hpp"
#include "verify/core/text.hpp"
#include "verify/law/claim.hpp"
#include "verify/starts/demand.hpp"

namespace dumbbell_verify {

/// What is asked of a file of any kind.
struct Request : Settings {
    starts::Numbers numbers{};  ///< demanded of starts, or of the adiabatic invariant
};

/// What a file proves: `claim` if it is about numbers of collisions, else what it is about instead.
struct Verified : Proof {
    std::variant<std::monostate, starts::Claim, adiabatic::Claim, law::Claim> other;

    /// What `say` has to say of it; nothing if the file is about numbers of collisions.
    template <class Say>
    [[nodiscard]] std::optional<std::string> of_other(Say say) const {
        return std::visit(
            [&]<class Claim>(const Claim& it) -> std::optional<std::string> {
                if constexpr (std::is_same_v<Claim, std::monostate>)
                    return std::nullopt;
                else
                    return std::string(say(it));
            },
            other);
    }
    /// Nothing was demanded, and nothing is proved of all that is in question.
    [[nodiscard]] bool says_nothing(const Collisions& demand) const {
        const auto* starts = std::get_if<starts::Claim>(&other);
        return starts ? starts->says_nothing(demand) : other.index() == 0 && claim.says_nothing();
    }
};

/// Returns only if all that the file and the demand say is certified; else throws the Failure of the least
/// line. With `together` the demand itself is left to the caller, and only files of the kind `collisions` may
/// be asked for.
Verified verify(Source& bytes, const Request& request);
Verified verify(const std::string& path, const Request& request);

}  // namespace dumbbell_verify
