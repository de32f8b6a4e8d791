// A folder to work in, and the results of a whole plan in it.
#pragma once

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "campaign/kind.hpp"
#include "campaign/plan.hpp"

namespace dumbbell_test {

/// A new folder for a campaign, removed at the end.
struct Place {
    std::filesystem::path path =
        std::filesystem::temp_directory_path() / ("dumbbell-campaign-" + std::to_string(::getpid()));
    Place() { std::filesystem::remove_all(path); }
    ~Place() { std::filesystem::remove_all(path); }
    Place(const Place&) = delete;
    Place& operator=(const Place&) = delete;

    [[nodiscard]] std::string string() const { return path.string(); }
};

/// The results of all shards as files, in order.
inline std::vector<std::string> results(const dumbbell::campaign::Kind& kind,
                                        const dumbbell::campaign::Plan& plan, const Place& place) {
    std::filesystem::create_directory(place.path);
    std::vector<std::string> files;
    for (const dumbbell::campaign::Plan::Shard& shard : plan.shards) {
        files.push_back(place.string() + "/" + std::to_string(files.size()));
        std::ofstream(files.back()) << *kind.work(plan.order(shard.first, shard.end), ".", dumbbell::never);
    }
    return files;
}

}  // namespace dumbbell_test
