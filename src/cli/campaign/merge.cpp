#include "campaign/merge.hpp"

#include <fmt/core.h>

#include <string>
#include <vector>

#include "base/deadline.hpp"
#include "base/error.hpp"
#include "base/printable.hpp"
#include "cli/commands.hpp"
#include "cli/terminal/exit_code.hpp"
#include "cli/terminal/frame.hpp"
#include "cli/terminal/messages.hpp"
#include "cli/terminal/output.hpp"
#include "cli/terminal/stop_signals.hpp"
#include "words/printed.hpp"

namespace dumbbell::cli {
namespace {

constexpr const char* merge_description =
    R"(Verify the result of each shard with the independent verifier, and join them.

The result is the file that the claim's command would have written by itself, byte for byte. One file proves one
statement about the adiabatic invariant, so a grid of them is joined to a table, which names for each the certificate in
the folder that dumbbell-verify accepts.)";

constexpr std::array merge_options{
    argument("FOLDER", "the campaign's folder").required(),
    Option{"--out", "FILE", "the file to write (FILE.gz: compressed); -: the standard output"}
        .checked([](const std::string& name) { return fault_of_name(name, std::nullopt); })
        .required(),
    jobs_option.saying("number of shards that are verified at the same time"),
    flag("--unverified",
         "only join a certificate: it is still to be verified, for instance by a campaign (plan ... "
         "verify FILE)"),
    flag("--quiet", "no progress")};

/// What a campaign of this kind is merged to.
Content content_of(std::string_view kind) {
    return kind == "collisions" ? Content::certificate : kind == "verified" ? Content::parts : Content::table;
}

int not_merged(const std::string& folder, const std::string& out, const campaign::Merge& merge) {
    if (stop_signal != 0) {
        return stopped(fmt::format("'{}' is not written; nothing is lost", out));
    }
    if (merge.unfinished > 0) {
        complain(fmt::format("{} of {} shards are not finished: dumbbell campaign run {} goes on with them",
                             merge.unfinished, merge.shards, shell_file(folder)));
    }
    if (!merge.withdrawn.empty()) {
        complain(fmt::format(
            "{} of {} results were not verified and are moved to '{}/rejected' (the first: {}); "
            "dumbbell campaign run {} proves them again",
            merge.withdrawn.size(), merge.shards, folder, merge.withdrawn.front(), shell_file(folder)));
    }
    return exit_not_certified;
}

int run_merge(const Given& given) {
    const std::string out = given.text("--out");
    const bool unverified = given.has("--unverified");
    campaign::CampaignFolder folder(given.text("FOLDER"));
    folder.lock();
    if (out != "-" && folder.holds(output_target(out))) {
        throw InputError(fmt::format(
            "'{}' lies in the campaign's folder, where nothing may lie but its own files: give another place",
            out));
    }
    require_name_of(out, content_of(folder.plan().whole.kind()));
    std::vector<std::string> results;
    for (const auto& part : folder.parts()) {
        results.push_back(folder.result_file(part.id));
    }
    const Output output(out, results);
    campaign::MergeOptions how{.jobs = jobs_of(given),
                               .scrutiny = unverified ? campaign::Scrutiny::form : campaign::Scrutiny::proof,
                               .interrupted = deadline(std::nullopt)};
    campaign::Merge merge;
    {
        Progress progress("shards", verbosity_of(given), unverified ? "reading" : "verifying");
        how.observer = &progress;
        merge = merge_campaign(folder, how);
    }
    if (!merge.whole) {
        return not_merged(given.text("FOLDER"), out, merge);
    }
    output.commit(merge.whole->text);
    const char* what = merge.evidence == campaign::Evidence::workers ? "as the workers' verifiers say"
                       : unverified                                  ? "NOT verified"
                                                                     : "verified";
    fmt::print(output.report(), "{} {}; they tile the claim: {}\n", plural(merge.shards, "shard"), what,
               one_line(folder.plan().claim));
    if (output.file()) {
        fmt::print("written: {}\n", one_line(out));
    }
    if (merge.whole->is_open) {
        complain("not everything was decided: the file says which pieces are open");
        return exit_not_certified;
    }
    return exit_done;
}

}  // namespace

constinit const Command campaign_merge_command{"merge",   one_group,     merge_description,
                                               inherited, merge_options, stoppable<run_merge>};

}  // namespace dumbbell::cli
