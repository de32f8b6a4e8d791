#pragma once

#include <string>
#include <vector>

#include "collisions/certificate.hpp"

namespace dumbbell::collisions {

/// All that a certificate with these pieces says, as options of the verifier: a file that says less in any
/// respect fails them. `rod`: `--ratio 10 --rod-mass 1/100`, if the body of the frame was given so.
[[nodiscard]] std::string whole_demand(const Certificate& frame, const std::vector<const Piece*>& pieces,
                                       const std::string& rod = {});

/// The same with the precision that the verifier has to be allowed for it, if that is more than usual.
[[nodiscard]] std::string options_to_check(const Certificate& frame, const std::vector<const Piece*>& pieces,
                                           const std::string& rod = {});

/// What a cover of the full section proves besides the count (its chart `again`, L19).
[[nodiscard]] bool heavy_at_most_once(const Certificate& frame, const std::vector<const Piece*>& pieces);

}  // namespace dumbbell::collisions
