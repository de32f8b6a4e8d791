#pragma once

#include "cluster/kind.hpp"
#include "prove/certify.hpp"

namespace dumbbell {

/// The greatest number of collisions for a range of mass ratios: what `dumbbell certify LO:HI` proves. A unit
/// is a piece, a result a certificate of a run of pieces, and merged they are the file that `certify --out`
/// writes.
class CollisionsKind : public Kind {
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

/// Cuts the request's range; `shards`: how many at most, if the user has a wish. Throws InputError if it is a
/// single ratio, or beyond reach. Nothing if interrupted. Calls the request's `placed`.
[[nodiscard]] std::optional<Plan> plan_collisions(const CertifyRequest& request,
                                                  std::optional<std::size_t> shards,
                                                  const Interrupted& interrupted);

}  // namespace dumbbell
