// Claims that are not about numbers of collisions. The program knows them by this interface alone: each kind
// is a row of a room that can be left out of a build.
#pragma once
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <utility>

#include "verify/core/settings.hpp"
#include "verify/core/text.hpp"

namespace dumbbell_verify {

/// The numbers of options, by their names without dashes: LO:HI, or A,B; one number stands there twice.
using Numbers = std::map<std::string_view, Range>;

/// What is asked of a file of any kind.
struct Request : Settings {
    Numbers numbers{};  ///< demanded of another claim
};

class OtherClaim {
  public:
    OtherClaim() = default;
    OtherClaim(const OtherClaim&) = default;
    OtherClaim& operator=(const OtherClaim&) = default;
    virtual ~OtherClaim() = default;
    [[nodiscard]] virtual std::string_view kind_name() const = 0;
    [[nodiscard]] virtual std::string_view leaves() const = 0;  ///< as --explain names them
    [[nodiscard]] virtual std::string text() const = 0;         ///< for the verdict
    /// In words, lines that begin with two spaces.
    [[nodiscard]] virtual std::string paragraph() const = 0;
    [[nodiscard]] virtual std::string json() const = 0;
    /// Nothing was demanded, and nothing is proved of all that is in question.
    [[nodiscard]] virtual bool says_nothing(const Collisions& /*demand*/) const { return false; }
};

/// What a file proves: `claim` if it is about numbers of collisions, else `other`.
struct Verified : Proof {
    std::shared_ptr<const OtherClaim> other;

    [[nodiscard]] bool says_nothing(const Collisions& demand) const {
        return other ? other->says_nothing(demand) : claim.says_nothing() && decided.value_or(0) == 0;
    }
};

template <class Claim>
Verified about(std::pair<Proof, Claim> found) {
    return {std::move(found.first), std::make_shared<const Claim>(std::move(found.second))};
}

struct ClaimKind {
    std::string_view name;  ///< on the line `claim`
    /// Reads on after that line; returns only if all that the file and the demand say is certified, else
    /// throws the Failure of the least line.
    Verified (*proof)(Text& text, const Request& request);
    bool is_of_starts = false;   ///< ratios, bounds and shares may be asked for
    bool is_of_section = false;  ///< the file names the dumbbell's section
};

/// The kind with this name, if this build has it.
const ClaimKind* claim_kind(std::string_view name);
/// Behind the name of a kind that this build does not have: what it was built without; empty: nothing.
std::string_view built_without();

}  // namespace dumbbell_verify
