#include "campaign/merge.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <string>
#include <vector>

#include "base/deadline.hpp"
#include "base/error.hpp"
#include "base/printable.hpp"
#include "cli/campaign/commands.hpp"
#include "cli/terminal/exit_code.hpp"
#include "cli/terminal/jobs_option.hpp"
#include "cli/terminal/messages.hpp"
#include "cli/terminal/out_option.hpp"
#include "cli/terminal/progress.hpp"
#include "cli/terminal/stop_signals.hpp"

namespace dumbbell {
namespace {

constexpr const char* description =
    R"(Verify the result of each shard with the independent verifier, and join them.

The result is the file that the claim's command would have written by itself, byte for byte. One file proves one statement about the adiabatic invariant, so a grid of
them is joined to a table, which names for each the certificate in the folder that dumbbell-verify accepts.)";

struct Options {
    std::string folder;
    std::string out;
    int jobs = all_cores();
    bool unverified = false;
    bool quiet = false;
};

/// What a campaign of this kind is merged to.
Content content_of(std::string_view kind) {
    return kind == "collisions" ? Content::certificate : kind == "verified" ? Content::parts : Content::table;
}

int not_merged(const Options& options, const Merge& merge) {
    if (stop_signal != 0) {
        complain(fmt::format("{}: '{}' is not written; nothing is lost", stopped_by(), options.out));
        return exit_stopped;
    }
    if (merge.unfinished > 0) {
        complain(fmt::format("{} of {} shards are not finished: dumbbell campaign run {} goes on with them",
                             merge.unfinished, merge.shards, shell_file(options.folder)));
    }
    if (!merge.withdrawn.empty()) {
        complain(
            fmt::format("{} of {} results were not verified and are moved to '{}/rejected' (the first: {}); "
                        "dumbbell campaign run {} proves them again",
                        merge.withdrawn.size(), merge.shards, options.folder, merge.withdrawn.front(),
                        shell_file(options.folder)));
    }
    return exit_not_certified;
}

int merge(const Options& options) {
    CampaignFolder folder(options.folder);
    folder.lock();
    if (options.out != "-" && folder.holds(output_target(options.out))) {
        throw InputError(fmt::format(
            "'{}' lies in the campaign's folder, where nothing may lie but its own files: give another place",
            options.out));
    }
    require_name_of(options.out, content_of(folder.plan().whole.kind()));
    std::vector<std::string> results;
    for (const auto& part : folder.parts()) {
        results.push_back(folder.result_file(part.id));
    }
    const Output output(options.out, results);
    MergeOptions how{.jobs = options.jobs,
                     .scrutiny = options.unverified ? Scrutiny::form : Scrutiny::proof,
                     .interrupted = deadline(std::nullopt)};
    Merge merge;
    {
        Progress progress("shards verified", options.quiet ? Loudness::quiet : Loudness::normal);
        how.progress = [&](std::size_t done, std::size_t all) { progress.update(done, all); };
        merge = merge_campaign(folder, how);
    }
    if (!merge.whole) {
        return not_merged(options, merge);
    }
    output.commit(merge.whole->text);
    const char* what = merge.evidence == Evidence::workers ? "as the workers' verifiers say"
                       : options.unverified                ? "NOT verified"
                                                           : "verified";
    fmt::print(output.report(), "{} shards {}; they tile the claim: {}\n", merge.shards, what,
               one_line(folder.plan().claim));
    if (output.file()) {
        fmt::print("written: {}\n", one_line(options.out));
    }
    if (merge.whole->is_open) {
        complain("not everything was decided: the file says which pieces are open");
        return exit_not_certified;
    }
    return exit_done;
}

}  // namespace

void add_campaign_merge(CLI::App& campaign, int& exit_code) {
    auto options = std::make_shared<Options>();
    CLI::App* command = campaign.add_subcommand("merge", description);
    command->add_option("FOLDER", options->folder, "the campaign's folder")->required();
    add_out_option(*command, options->out, {}, "the file to write (FILE.gz: compressed)")->required();
    add_jobs_option(*command, options->jobs, "number of shards that are verified at the same time");
    command->add_flag("--unverified", options->unverified,
                      "only join a certificate: it is still to be verified, for instance by a campaign (plan "
                      "... verify FILE)");
    command->add_flag("--quiet", options->quiet, "no progress");
    command->callback([options, &exit_code] { exit_code = stoppable([&] { return merge(*options); }); });
}

}  // namespace dumbbell
