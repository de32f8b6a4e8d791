#include <fmt/core.h>

#include <algorithm>
#include <optional>
#include <string>
#include <tuple>

#include "base/deadline.hpp"
#include "base/ended_early.hpp"
#include "base/error.hpp"
#include "base/printable.hpp"
#include "campaign/folder.hpp"
#include "campaign/kinds/kinds.hpp"
#include "cli/claims/adiabatic.hpp"
#include "cli/claims/collisions.hpp"
#include "cli/claims/critical.hpp"
#include "cli/commands.hpp"
#include "cli/terminal/exit_code.hpp"
#include "cli/terminal/messages.hpp"
#include "cli/terminal/progress.hpp"
#include "cli/terminal/stop_signals.hpp"
#include "number/count_argument.hpp"
#include "words/printed.hpp"

namespace dumbbell::cli {
namespace {

constexpr const char* plan_description =
    R"(Cut a claim into shards, in a new folder.

Examples:
  dumbbell campaign plan stairs.campaign 1:1e8 --gap 1e-9
  dumbbell campaign plan full.campaign 1:1000 --section full
  dumbbell campaign plan ratios.campaign critical 3:10000 --digits 30
  dumbbell campaign plan grid.campaign adiabatic --delta 0.001:0.003,0.003:0.01 --phi-margin 0.3,0.5
  dumbbell campaign plan check.campaign verify stairs.dbc       the verification of a large certificate)";

constexpr Option shards_option =
    Option{"--shards", "N", "how many at most; default: 64, or more of about 10 s"}.from(1, 1'000'000);

constexpr std::array plan_options =
    joined(std::array{argument("FOLDER", "the campaign's folder, new or empty").required(), ratio_option},
           claim_options, std::array{shards_option});

constexpr std::array critical_claim_options{
    argument("N1:N2", "range of numbers of collisions, from 3 on").required(), critical_digits_option};

constexpr std::array adiabatic_claim_options = statement_options(Deltas::list);

constexpr std::array verify_claim_options{argument("FILE", "certificate about collisions").required()};

/// The folder comes first. Forgotten, it would be one that has the name of a claim, with another claim
/// in it.
std::string new_folder(const Given& given) {
    const std::string folder = given.text("FOLDER");
    if (campaign_plan_command.below(folder) != nullptr) {
        throw InputError(fmt::format(
            "the folder is missing: dumbbell campaign plan FOLDER {0} ... (one with this name: ./{0})",
            folder));
    }
    campaign::CampaignFolder::require_new(folder);
    return folder;
}

/// The folder of a plan with another claim: the options of the one about a range would mean nothing.
std::string new_folder(const Given& given, const char* claim) {
    const std::string folder = new_folder(given);
    for (const Option& option : plan_options) {
        if (given.has(option.name) && option.name != "FOLDER" && option.name != shards_option.name) {
            throw InputError(
                fmt::format("{} is of the claim about a range of mass ratios: give either that one, or {}",
                            option.name, claim));
        }
    }
    return folder;
}

std::optional<std::size_t> shards_of(const Given& given) {
    return given.has("--shards") ? std::optional(static_cast<std::size_t>(given.number("--shards")))
                                 : std::nullopt;
}

int said_of(const std::string& folder, const campaign::Plan& plan) {
    fmt::print("{}\n{} of {} in '{}'; to process them: dumbbell campaign run {}\n", one_line(plan.claim),
               plural(plan.shards.size(), "shard"), plural(plan.whole.units.size(), "unit"), one_line(folder),
               shell_file(folder));
    return exit_done;
}

int made(const std::string& folder, const campaign::Plan& plan) {
    campaign::CampaignFolder::create(folder, plan);
    return said_of(folder, plan);
}

int nothing_planned() { return stopped("nothing was planned"); }

int plan_range(const Given& given) {
    const std::string folder = new_folder(given);
    if (!given.has("RATIO")) {
        throw InputError(
            "give the claim: a range of mass ratios LO:HI, critical N1:N2, adiabatic --delta ..., or verify "
            "FILE");
    }
    collisions::CertifyRequest request = request_of(given, parse_ratio_argument(given.text("RATIO")));
    std::optional<campaign::Plan> plan;
    {
        Progress progress("steps", Verbosity::normal, "looking for steps");
        request.observer = &progress;
        plan = campaign::plan_collisions(request, shards_of(given), deadline(std::nullopt));
    }
    return plan ? made(folder, *plan) : nothing_planned();
}

int plan_steps(const Given& given) {
    const std::string folder = new_folder(given, "critical");
    staircase::CriticalRequest request;
    std::tie(request.first, request.last) = parse_counts(given.text("N1:N2"));
    request.digits = static_cast<int>(given.number("--digits"));
    return made(folder, campaign::plan_critical(request, shards_of(given)));
}

int plan_statements(const Given& given) {
    const std::string folder = new_folder(given, "adiabatic");
    if (given.has("--shards")) {
        throw InputError("--shards is not for adiabatic: each statement is a shard");
    }
    return made(folder, campaign::plan_adiabatic(statements_of(given, Deltas::list), accuracy_of(given)));
}

int plan_verification(const Given& given) try {
    const std::string folder = new_folder(given, "verify");
    campaign::VerifiedPlan verification;
    {
        const Interrupted interrupted = deadline(std::nullopt);
        Progress progress("pieces", Verbosity::normal, "reading");
        verification = campaign::plan_verified(given.text("FILE"), shards_of(given), interrupted, progress);
        progress.enter("writing the campaign", "");
        campaign::CampaignFolder::create(folder, verification.plan, verification.sources, interrupted);
    }
    return said_of(folder, verification.plan);
} catch (const EndedEarly&) {
    return nothing_planned();
}

constexpr Command critical_claim{"critical",
                                 one_group,
                                 "Critical ratios instead of a range of mass ratios.",
                                 inherited,
                                 critical_claim_options,
                                 stoppable<plan_steps>,
                                 {},
                                 true};
constexpr Command adiabatic_claim{
    "adiabatic",
    one_group,
    "Constants of the adiabatic invariant, a shard for each statement of a grid.",
    inherited,
    adiabatic_claim_options,
    stoppable<plan_statements>,
    {},
    true};
constexpr Command verify_claim{
    "verify",
    one_group,
    "The verification of a certificate, in parts. Merged they are what dumbbell-verify --combine takes.",
    inherited,
    verify_claim_options,
    stoppable<plan_verification>,
    {},
    true};
constexpr std::array claims{&critical_claim, &adiabatic_claim, &verify_claim};

}  // namespace

constinit const Command campaign_plan_command{
    "plan", one_group, plan_description, inherited, plan_options, stoppable<plan_range>, claims};

}  // namespace dumbbell::cli
