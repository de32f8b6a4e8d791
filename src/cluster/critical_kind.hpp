#pragma once

#include "cluster/kind.hpp"
#include "prove/critical_range.hpp"

namespace dumbbell {

/// Critical ratios: what `dumbbell critical N1:N2` encloses. A unit is one of them, a result an enclosure for
/// each, and merged they are the table that `critical --out` writes. There is no certificate of them: a
/// result is checked by the signs of the margin at both ends of each enclosure (certainly_encloses).
class CriticalKind : public Kind {
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

/// Cuts the request's counts; `shards`: how many at most, if the user has a wish. Throws InputError if there
/// is only one.
[[nodiscard]] Plan plan_critical(const CriticalRequest& request, std::optional<std::size_t> shards);

}  // namespace dumbbell
