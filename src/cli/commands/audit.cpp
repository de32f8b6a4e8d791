#include "cli/commands/audit.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <memory>

#include "audit/audit_report.hpp"
#include "cli/terminal/exit_code.hpp"
#include "cli/terminal/messages.hpp"
#include "cli/terminal/progress.hpp"
#include "cli/terminal/standard_input.hpp"
#include "words/json_number.hpp"

namespace dumbbell {
namespace {

constexpr const char* description =
    R"(Prove exactly that a certificate's leaves tile the section, and its pieces the range.

Every leaf box is derived again as exact rationals; that no two overlap and that their areas add up to the root's is
proved with CGAL's exact arithmetic, whatever the tree says. What a leaf claims about its box is checked by
dumbbell verify, not here.

Example: dumbbell audit certificates/stairs-1-100.dbc)";

constexpr const char* footer =
    R"(The fields of --json: docs/reference/json.md.

Exit codes: 0 tiles exactly; 1 internal error; 2 wrong usage or unreadable input; 3 does not tile.)";

struct Options {
    std::vector<std::string> files;
    bool json = false;
};

audit::AuditedFile audited(const std::string& path) {
    Progress progress("leaves", Loudness::normal, "auditing");
    const auto start = std::chrono::steady_clock::now();
    audit::AuditedFile file{path, 0, {}};
    file.audit = audit::audit_file(
        input_file(path), [&](std::size_t done, std::size_t total) { progress.update(done, total); });
    file.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return file;
}

int run(const Options& options) {
    std::vector<audit::AuditedFile> files;
    bool all = true;
    for (const std::string& path : options.files) {
        const audit::AuditedFile& file = files.emplace_back(audited(path));
        all = all && file.audit.tiles();
        if (!options.json) {
            fmt::print("{}\n", to_text(file));
            std::fflush(stdout);
        }
        for (const std::string& fault : file.audit.faults) {
            complain(path + ": " + fault);
        }
    }
    if (options.json) {
        fmt::print("{}", json_text(to_json(files)));
    }
    return all ? exit_done : exit_not_certified;
}

}  // namespace

void add_audit_command(CLI::App& app, int& exit_code) {
    auto options = std::make_shared<Options>();
    CLI::App* command = app.add_subcommand("audit", description);
    command->footer(footer);
    command->add_option("FILE", options->files, "certificates (-: the standard input)")->required();
    command->add_flag("--json", options->json, "one JSON object on stdout");
    command->callback([options, &exit_code] { exit_code = run(*options); });
}

}  // namespace dumbbell
