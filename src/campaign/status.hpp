#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>

#include "campaign/folder.hpp"

namespace dumbbell::campaign {

/// How far a campaign has got: from its finished shards, and, for all that concerns the time, from its
/// journal.
struct CampaignStatus {
    struct Worker {
        std::size_t done = 0;
        std::size_t failed = 0;  ///< attempts without a result, or with one that was rejected
        double seconds = 0;      ///< of work for what is done
        double last_heard = 0;   ///< seconds ago
    };
    std::string claim;
    std::size_t shards = 0;
    std::size_t done = 0;
    std::size_t split = 0;
    std::size_t failed = 0;           ///< attempts, of all runs
    std::size_t rejected = 0;         ///< results, of all runs
    bool is_running = false;          ///< a run is at work now
    std::size_t running = 0;          ///< shards on workers, as far as the journal knows
    std::size_t connected = 0;        ///< workers, the same
    double share = 0;                 ///< of the estimated cost that is done
    std::optional<double> rate;       ///< shards a minute, in the last run
    std::optional<double> remaining;  ///< seconds, at that rate
    std::map<std::string, Worker> workers;

    [[nodiscard]] bool is_complete() const { return done == shards; }
};

[[nodiscard]] CampaignStatus campaign_status(const CampaignFolder& folder);

}  // namespace dumbbell::campaign
