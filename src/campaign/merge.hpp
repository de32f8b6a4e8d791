#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/interrupted.hpp"
#include "base/observer.hpp"
#include "campaign/folder.hpp"
#include "campaign/kind.hpp"

namespace dumbbell::campaign {

struct MergeOptions {
    int jobs = 1;
    Scrutiny scrutiny = Scrutiny::proof;
    Interrupted interrupted = never;
    Observer* observer = &nobody;  ///< told of the shards that are verified
};

/// What came of it: either the whole, or what stands in its way.
struct Merge {
    std::optional<Kind::Merged> whole;
    Evidence evidence = Evidence::workers;
    std::size_t shards = 0;
    std::size_t unfinished = 0;
    /// Results that did not stand up to verification, with the reason; they are no longer among the finished
    /// ones.
    std::vector<std::string> withdrawn;
};

/// Looks at the result of every shard, and only then joins them. The folder is locked. Throws InputError if
/// they do not tile the claim, if a result could not be looked at, or if only their form was to be looked at
/// and nobody could verify the whole.
[[nodiscard]] Merge merge_campaign(const CampaignFolder& folder, const MergeOptions& options);

}  // namespace dumbbell::campaign
