#pragma once

#include <chrono>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "base/interrupted.hpp"
#include "base/observer.hpp"
#include "campaign/engine.hpp"
#include "campaign/folder.hpp"
#include "campaign/kind.hpp"

namespace dumbbell::campaign {

struct CampaignOptions {
    /// A shard that takes longer is split, if it can be; nothing: none is.
    std::optional<std::chrono::duration<double>> shard_limit;
    /// Results come from elsewhere: each is looked at before it counts, this number of them at the same time;
    /// 0: they are this program's own, and are looked at when they are merged.
    int verifiers = 0;
    Scrutiny scrutiny = Scrutiny::proof;
    /// This program's own, for shards that an answer from elsewhere leaves undecided: whether they can be
    /// decided is nobody else's word. Needed where results come from elsewhere.
    Engine* own = nullptr;
    Interrupted interrupted = never;
    /// Told of the shards that are finished after each event, of all (there are more after a split); of what
    /// the user should know; and when no worker was there for a while.
    Observer* observer = &nobody;
};

/// What one run did.
struct CampaignRun {
    std::size_t accepted = 0;  ///< results
    std::size_t again = 0;     ///< results that were there already, the same
    std::size_t rejected = 0;
    std::size_t failed = 0;  ///< attempts without a result
    std::size_t split = 0;
    std::size_t given_up = 0;  ///< shards that failed too often
    std::size_t left = 0;      ///< shards that are not finished at the end
    double seconds = 0;
    double worked = 0;       ///< seconds of work of the accepted results, wherever it was done
    double own_seconds = 0;  ///< of this program for bookkeeping: the engine's, and accepting results
    double verifying = 0;    ///< seconds of verification, in addition
    EngineFigures engine;
};

/// Processes what is not finished of a campaign; the folder is locked. Ends when all is, when nothing more
/// can be done, or when interrupted. Whatever comes from elsewhere costs time and nothing else: what it
/// proves is verified, here or when it is merged, and what it leaves undecided is tried here. Throws
/// ResultsDiffer, or InputError if the folder cannot be written.
[[nodiscard]] CampaignRun run_campaign(CampaignFolder& folder, Engine& engine,
                                       const CampaignOptions& options);

/// Takes the results away that leave something undecided, so that the next run tries their shards again; how
/// many they were. The folder is locked.
[[nodiscard]] std::size_t withdraw_open_results(const CampaignFolder& folder);

}  // namespace dumbbell::campaign
