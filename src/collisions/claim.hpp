#pragma once

#include <optional>
#include <string>
#include <vector>

#include "collisions/certificate.hpp"

/// What is claimed, the command that makes it, and the demand that checks it. Whatever proves, keeps, joins,
/// shows or lists has a Claim, not its parts.
namespace dumbbell::collisions {

/// A dumbbell whose uniform rod has a mass, in units of that of both ends: a body as its user gives it.
struct Rod {
    Rational ratio, mass;
};

struct Claim {
    Range range = {};  ///< of mass ratios, or of bodies of Q
    System system = {};
    Rational gap = {
        1, 1'000'000};  ///< of ranges: the relative width of a gap around a critical ratio; 0: not known
    std::optional<Rod> rod = {};  ///< if it was given so
};

/// A number or LO:HI as a user writes it: no number of a body changes into its inverse. Throws InputError,
/// which names the option.
[[nodiscard]] Range parse_range(const char* option, const std::string& text);
/// Throws InputError if no body has this rho, as a user writes it.
void require_rho(const Rational& rho);
/// Bodies with this rho, a number, and this inertia Q, a number or LO:HI, as a user writes them. Throws
/// InputError, which names the option, if no body has them.
[[nodiscard]] Claim claim_of_body(const std::string& rho, const std::string& inertia);
/// The same body by plain covers (L71), as the sceptic has it. Throws InputError if Q rho < 1.
[[nodiscard]] Claim by_plain_covers(Claim claim);
/// The massless dumbbell with a rod of that mass as a body (L70 (d)).
[[nodiscard]] Claim claim_of(const Rod& rod);
/// Its gap is the widest that the certificate has; 0: it has none.
[[nodiscard]] Claim claim_of(const Certificate& certificate);
[[nodiscard]] std::vector<const Piece*> pieces_of(const Certificate& certificate);

/// ` --section full --gap 1e-9`: what a command needs besides what moves.
[[nodiscard]] std::string options_of(const Claim& claim);

/// `dumbbell certify 1:100 --section full --gap 1e-6`: what makes a certificate of the claim, but for --out.
[[nodiscard]] std::string command(const Claim& claim);

/// All that these pieces of the claim say, as options of the verifier: a file that says less in any respect
/// fails them.
[[nodiscard]] std::string whole_demand(const Claim& claim, const std::vector<const Piece*>& pieces);

/// The same with the precision that the verifier has to be allowed for it, if that is more than usual.
[[nodiscard]] std::string options_to_check(const Claim& claim, const std::vector<const Piece*>& pieces);

/// Whether they prove that besides the number of collisions (L19).
[[nodiscard]] bool heavy_at_most_once(const Claim& claim, const std::vector<const Piece*>& pieces);

/// Whether a line of a certificate has room for the ends.
[[nodiscard]] bool fits_a_line(const Range& range);

/// Why nothing is tried of the claim, in a line for the user; nothing if it fits the lines of a certificate
/// and is within reach: a single ratio of the dumbbell (turning section) up to 10^100, where one orbit has
/// about 10^50 collisions; others up to 10^36, where a count has 64 bits.
[[nodiscard]] std::optional<std::string> out_of_reach(const Claim& claim);

}  // namespace dumbbell::collisions
