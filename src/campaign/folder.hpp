#pragma once

#include <stdexcept>
#include <string>
#include <vector>

#include "base/interrupted.hpp"
#include "campaign/journal.hpp"
#include "campaign/plan.hpp"
#include "file/folder_lock.hpp"

namespace dumbbell::campaign {

/// Two results of one order that differ, and nothing tells which is true: one of the machines, or the
/// program, is not to be relied on.
class ResultsDiffer : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// A campaign as plain files:
///
///     plan            the claim and its shards (plan.hpp)
///     results/ID      what is finished: of order ID, complete and durable
///     splits/ID       order ID turned out too big: its halves are processed instead
///     rejected/ID     the last result of order ID that was not accepted, for a look at it
///     arrived/ID      a result that is being verified
///     journal         what happened when, for `status` (journal.hpp)
///     password        Work Queue's shared secret
///
/// All that is finished is in `results` and `splits`: a program that is killed at any time loses the shards
/// under way and nothing else. All functions throw InputError where a file cannot be written.
class CampaignFolder {
  public:
    /// Throws InputError unless `path` is not there yet, or an empty folder.
    static void require_new(const std::string& path);

    /// Makes the folder, which is not there yet or empty. `sources`: the files that become the plan's inputs,
    /// in their order. Throws EndedEarly if it is interrupted. If it fails, nothing is left in it.
    static void create(const std::string& path, const Plan& plan,
                       const std::vector<std::string>& sources = {}, const Interrupted& interrupted = never);

    /// Opens it. Throws InputError, and changes nothing, if it is no campaign, one of another version, if its
    /// plan was changed after the start, if it cannot be read, or if it holds a file that is not of its
    /// making.
    explicit CampaignFolder(std::string path);

    /// For a program that changes it: throws InputError if another program does. Ends with this object.
    void lock();
    [[nodiscard]] bool is_locked_by_another() const { return FolderLock::is_taken(path_); }

    /// Whether a file of this path, there or not, lies in the folder or below it.
    [[nodiscard]] bool holds(const std::string& file) const;

    [[nodiscard]] const Plan& plan() const { return plan_; }
    [[nodiscard]] const std::string& plan_digest() const { return plan_digest_; }
    [[nodiscard]] const std::string& path() const { return path_; }

    /// A shard, or a part of one that was split, with its share of the shard's cost.
    struct Part {
        std::size_t first = 0;
        std::size_t end = 0;
        double cost = 0;
        std::string id;
        bool finished = false;
    };
    /// All of them, in order: their units are those of the plan, each once.
    [[nodiscard]] std::vector<Part> parts() const;
    [[nodiscard]] Order order(const Part& part) const { return plan_.order(part.first, part.end); }
    /// The halves of a part with several units.
    [[nodiscard]] std::vector<Part> halves(const Part& part) const;

    [[nodiscard]] std::string result_file(const std::string& id) const { return path_ + "/results/" + id; }
    [[nodiscard]] bool has_result(const std::string& id) const;
    enum class Kept {
        now,     ///< for good
        before,  ///< the same bytes
        other    ///< is there, and this one is not kept
    };
    [[nodiscard]] Kept keep_result(const std::string& id, const std::string& bytes) const;

    void split(const std::string& id) const;

    /// A result that comes from elsewhere as a file that can be looked at, until it is kept or rejected.
    [[nodiscard]] std::string arrived(const std::string& id, const std::string& bytes) const;
    void forget_arrived(const std::string& id) const;
    void reject(const std::string& id, const std::string& bytes) const;
    /// A result that does not stand up to a second look: away from the finished ones.
    void withdraw_result(const std::string& id) const;

    [[nodiscard]] Journal& journal() { return journal_; }
    [[nodiscard]] const Journal& journal() const { return journal_; }

  private:
    void require_own_files() const;
    void require_known_results() const;
    void add_parts(const Part& part, std::vector<Part>& all) const;

    std::string path_;
    Plan plan_;
    std::string plan_digest_;
    std::vector<std::string> ids_;  ///< of the plan's shards
    Journal journal_;
    FolderLock lock_;
};

}  // namespace dumbbell::campaign
