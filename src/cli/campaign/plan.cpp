#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <optional>
#include <string>
#include <tuple>

#include "base/deadline.hpp"
#include "base/error.hpp"
#include "base/printable.hpp"
#include "campaign/folder.hpp"
#include "campaign/kinds/adiabatic.hpp"
#include "campaign/kinds/collisions.hpp"
#include "campaign/kinds/critical.hpp"
#include "campaign/kinds/verified.hpp"
#include "cli/campaign/commands.hpp"
#include "cli/claims/adiabatic.hpp"
#include "cli/claims/collisions.hpp"
#include "cli/terminal/exit_code.hpp"
#include "cli/terminal/messages.hpp"
#include "cli/terminal/progress.hpp"
#include "cli/terminal/stop_signals.hpp"
#include "number/count_argument.hpp"

namespace dumbbell {
namespace {

constexpr const char* description =
    R"(Cut a claim into shards, in a new folder.

Examples:
  dumbbell campaign plan stairs.campaign 1:1e8 --gap 1e-9
  dumbbell campaign plan full.campaign 1:1000 --section full
  dumbbell campaign plan ratios.campaign critical 3:10000 --digits 30
  dumbbell campaign plan grid.campaign adiabatic --delta 0.001:0.003,0.003:0.01 --phi-margin 0.3,0.5
  dumbbell campaign plan check.campaign verify stairs.dbc       the verification of a large certificate)";

struct Options {
    std::string folder;
    CertifyClaim claim;
    std::string certificate;
    std::string counts;
    int digits = CriticalRequest{}.digits;
    AdiabaticWords adiabatic;
    std::optional<std::size_t> shards;
};

int made(const std::string& folder, const Plan& plan, const std::vector<std::string>& sources = {}) {
    CampaignFolder::create(folder, plan, sources);
    fmt::print("{}\n{} shards of {} units in '{}'; to work them off: dumbbell campaign run {}\n",
               one_line(plan.claim), plan.shards.size(), plan.whole.units.size(), one_line(folder),
               shell_file(folder));
    return exit_done;
}

int plan_certify(const Options& options) {
    CertifyRequest request = request_of(options.claim, parse_ratio_argument(options.claim.ratio));
    Progress progress("steps");
    request.placed = [&](std::size_t done, std::size_t all) { progress.update(done, all); };
    const auto plan = plan_collisions(request, options.shards, deadline(std::nullopt));
    if (!plan) {
        complain(fmt::format("{}: nothing was planned", stopped_by()));
        return exit_stopped;
    }
    return made(options.folder, *plan);
}

int plan_critical(const Options& options) {
    CriticalRequest request;
    std::tie(request.first, request.last) = parse_counts(options.counts);
    request.digits = options.digits;
    return made(options.folder, plan_critical(request, options.shards));
}

int plan_verify(const Options& options) {
    const VerifiedPlan made_of = plan_verified(options.certificate, options.shards);
    return made(options.folder, made_of.plan, made_of.sources);
}

int plan_adiabatic(const Options& options) {
    if (options.shards) {
        throw InputError("--shards is not for adiabatic: each statement is a shard");
    }
    const auto statements = statements_of(options.adiabatic, Deltas::list);
    return made(options.folder, plan_adiabatic(statements, accuracy_of(options.adiabatic)));
}

bool is_claim(const CLI::App& plan, const std::string& word) {
    const auto claims = plan.get_subcommands([&](const CLI::App* c) { return c->get_name() == word; });
    return !claims.empty();
}

/// With a subcommand the options of the other claim would mean nothing.
void require_one_claim(const CLI::App& plan) {
    for (const CLI::Option* option : plan.get_options()) {
        const std::string name = option->get_name();
        if (option->count() > 0 && name != "FOLDER" && name != "--shards") {
            throw InputError(
                fmt::format("{} is of the claim about a range of mass ratios: give either that one, or {}",
                            name, plan.get_subcommands().front()->get_name()));
        }
    }
}

/// The folder comes first. Whoever forgot it would get one that has the name of a claim, with another claim
/// in it.
void require_folder(const CLI::App& plan, const std::string& folder) {
    if (is_claim(plan, folder)) {
        throw InputError(fmt::format(
            "the folder is missing: dumbbell campaign plan FOLDER {0} ... (one with this name: ./{0})",
            folder));
    }
}

using Mode = CLI::AppFormatMode;

/// The help of a claim's command has the folder where it is typed.
void show_folder(CLI::App& claim) {
    claim.formatter_fn([plain = claim.get_formatter()](const CLI::App* app, std::string name, Mode mode) {
        return plain->make_help(app, name.insert(name.rfind(' '), " FOLDER"), mode);
    });
}

/// Where a claim's name stands instead of the folder, its help is the one that is wanted.
void help_without_folder(CLI::App& plan) {
    plan.formatter_fn([plain = plan.get_formatter()](const CLI::App* app, std::string name, Mode mode) {
        const auto folder = app->get_option("FOLDER")->results();
        return !folder.empty() && is_claim(*app, folder.front())
                   ? app->get_subcommand(folder.front())->help(name)
                   : plain->make_help(app, name, mode);
    });
}

}  // namespace

void add_campaign_plan(CLI::App& campaign, int& exit_code) {
    auto options = std::make_shared<Options>();
    CLI::App* command = campaign.add_subcommand("plan", description);
    command->add_option("FOLDER", options->folder, "the campaign's folder, new or empty")->required();
    add_claim_options(*command, options->claim);
    command->add_option("--shards", options->shards, "how many at most; default: 64, or more of about 10 s")
        ->check(CLI::Range(1, 1'000'000))
        ->type_name("N");
    CLI::App* critical =
        command->add_subcommand("critical", "Critical ratios instead of a range of mass ratios.");
    critical->add_option("N1:N2", options->counts, "range of numbers of collisions, from 3 on")->required();
    critical->add_option("--digits", options->digits, "significant digits, all of them proved")
        ->check(CLI::Range(1, most_critical_digits))
        ->capture_default_str();
    CLI::App* adiabatic = command->add_subcommand(
        "adiabatic", "Constants of the adiabatic invariant, a shard for each statement of a grid.");
    add_adiabatic_options(*adiabatic, options->adiabatic, Deltas::list);
    CLI::App* verify = command->add_subcommand(
        "verify",
        "The verification of a certificate, in parts. Merged they are what dumbbell-verify --combine takes.");
    verify->add_option("FILE", options->certificate, "certificate about collisions")->required();
    command->require_subcommand(0, 1);
    for (CLI::App* claim : {critical, adiabatic, verify}) {
        claim->fallthrough();  // --shards may stand behind it, too
        show_folder(*claim);
    }
    help_without_folder(*command);
    command->callback([options, command, critical, adiabatic, verify, &exit_code] {
        exit_code = stoppable([&] {
            require_folder(*command, options->folder);
            CampaignFolder::require_new(options->folder);
            if (critical->parsed() || adiabatic->parsed() || verify->parsed()) {
                require_one_claim(*command);
                return critical->parsed()    ? plan_critical(*options)
                       : adiabatic->parsed() ? plan_adiabatic(*options)
                                             : plan_verify(*options);
            }
            if (options->claim.ratio.empty()) {
                throw InputError(
                    "give the claim: a range of mass ratios LO:HI, critical N1:N2, adiabatic --delta ..., or "
                    "verify FILE");
            }
            return plan_certify(*options);
        });
    });
}

}  // namespace dumbbell
