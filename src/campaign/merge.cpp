#include "campaign/merge.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "base/deadline.hpp"
#include "base/error.hpp"
#include "campaign/judges.hpp"

namespace dumbbell::campaign {
namespace {

using Part = CampaignFolder::Part;

/// False if interrupted.
bool verify_all(const CampaignFolder& folder, const Kind& kind, const std::vector<Part>& parts,
                const MergeOptions& options, Merge& merge) {
    Judges judges(kind, folder.path(), options.jobs, options.scrutiny);
    const auto ahead = 2 * static_cast<std::size_t>(options.jobs);
    std::size_t asked = 0;
    for (std::size_t done = 0; done < parts.size(); ++done) {
        for (; asked < std::min(parts.size(), done + ahead); ++asked) {
            judges.ask({folder.order(parts[asked]), folder.result_file(parts[asked].id), asked});
        }
        const Judges::Answer answer = judges.next_answer();
        if (options.interrupted()) {
            return false;
        }
        if (answer.judgement.verdict == Judgement::Verdict::none) {
            throw InputError(fmt::format("{}: nothing is merged, and nothing is changed; try again",
                                         answer.judgement.reason));
        }
        if (answer.judgement.verdict == Judgement::Verdict::wrong) {
            const std::string& id = parts[answer.number].id;
            folder.withdraw_result(id);
            merge.withdrawn.push_back(fmt::format("{}: {}", id, answer.judgement.reason));
        }
        options.observer->update(done + 1, parts.size(), std::nullopt);
    }
    return true;
}

}  // namespace

Merge merge_campaign(const CampaignFolder& folder, const MergeOptions& options) {
    const auto parts = folder.parts();
    Merge merge;
    merge.shards = parts.size();
    merge.unfinished = static_cast<std::size_t>(
        std::count_if(parts.begin(), parts.end(), [](const Part& part) { return !part.finished; }));
    if (merge.unfinished > 0) {
        return merge;
    }
    const Kind& kind = kind_named(folder.plan().whole.kind());
    merge.evidence = kind.evidence();
    if (options.scrutiny == Scrutiny::form && merge.evidence == Evidence::results) {
        throw InputError("nobody can verify this table later: merge without --unverified");
    }
    if (!verify_all(folder, kind, parts, options, merge) || !merge.withdrawn.empty()) {
        return merge;
    }
    std::vector<std::string> files;
    files.reserve(parts.size());
    for (const Part& part : parts) {
        files.push_back(folder.result_file(part.id));
    }
    options.observer->enter("joining", "");
    merge.whole = kind.merge(folder.plan(), folder.path(), files);
    return merge;
}

}  // namespace dumbbell::campaign
