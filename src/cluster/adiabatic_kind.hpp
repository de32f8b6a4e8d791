#pragma once

#include "certificate/adiabatic_certificate.hpp"
#include "cluster/kind.hpp"

namespace dumbbell {

/// Constants of the adiabatic invariant for a grid of hypotheses: what `dumbbell adiabatic` proves. A unit is
/// one statement, a shard of its own, and a result the certificate that `adiabatic --out` writes. One file
/// proves one statement, so they merge to a table of the statements, which names the file of each.
class AdiabaticKind : public Kind {
  public:
    [[nodiscard]] std::optional<std::string> work(const Order& order, const std::string& folder,
                                                  const Interrupted& interrupted) const override;
    [[nodiscard]] Merged merge(const Plan& plan, const std::string& folder,
                               const std::vector<std::string>& files) const override;

  private:
    [[nodiscard]] Judgement form(const Order& order, const std::string& file) const override;
    [[nodiscard]] std::string refutation(const Order& order, const std::string& folder,
                                         const std::string& file) const override;
};

/// A shard for each statement of a grid, which are all of one claim. Throws InputError if there is only one,
/// or one twice. Preconditions: require_sensible for each; 0 < accuracy <= 1.
[[nodiscard]] Plan plan_adiabatic(const std::vector<AdiabaticHypotheses>& grid, const Rational& accuracy);

}  // namespace dumbbell
