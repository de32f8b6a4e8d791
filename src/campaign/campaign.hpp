#pragma once

#include <chrono>
#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "base/interrupted.hpp"
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
    /// Called after each event with the numbers of finished and of all shards (which grows with splits).
    std::function<void(std::size_t, std::size_t)> progress = [](std::size_t, std::size_t) {};
    /// Called with what the user should know: a line.
    std::function<void(const std::string&)> note = [](const std::string&) {};
    /// Called when no worker was there for a while, with the seconds since the last one.
    std::function<void(double)> no_workers = [](double) {};
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
