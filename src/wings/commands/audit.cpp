#include <fmt/core.h>

#include "audit/audit_report.hpp"
#include "cli/commands.hpp"
#include "cli/terminal/common.hpp"
#include "cli/terminal/exit_code.hpp"
#include "cli/terminal/messages.hpp"
#include "cli/terminal/standard_input.hpp"

namespace dumbbell::cli {
namespace {

constexpr const char* audit_description =
    R"(Check by exact geometry that a certificate's boxes neither overlap nor leave a hole.

It derives every leaf's box again as exact rationals, and proves with CGAL's exact arithmetic that no two overlap and
that their areas add up to the root's, whatever the tree says. It does not check what a leaf claims about its box:
dumbbell verify does.

Example: dumbbell audit certificates/stairs-1-100.dbc)";

constexpr const char* audit_footer =
    R"(Exit codes: 0 tiles exactly; 1 internal error; 2 wrong usage or unreadable input; 3 does not tile.)";

constexpr std::array audit_options{
    argument("FILE", "certificates about mass ratios, with covers (-: the standard input)")
        .required()
        .repeated(),
    json_option};

audit::AuditedFile audited(const std::string& path) {
    Progress progress("", Verbosity::normal, "reading");
    const Stopwatch watch;
    audit::AuditedFile file{path, 0, {}};
    file.audit = audit::audit_file(input_file(path), progress);
    file.seconds = watch.seconds();
    return file;
}

int run_audit(const Given& given) {
    std::vector<audit::AuditedFile> files;
    bool all = true;
    for (const std::string& path : given.words("FILE")) {
        const audit::AuditedFile& file = files.emplace_back(audited(path));
        all = all && file.audit.tiles();
        if (!given.has("--json")) {
            fmt::print("{}\n", to_text(file));
            std::fflush(stdout);
        }
        for (const std::string& fault : file.audit.faults) {
            complain(fmt::format("{}: {}", path, fault));
        }
    }
    if (given.has("--json")) {
        fmt::print("{}", json_text(to_json(files)));
    }
    return all ? exit_done : exit_not_certified;
}

}  // namespace

constinit const Command audit_command{"audit",      more_group,    audit_description,
                                      audit_footer, audit_options, run_audit};

}  // namespace dumbbell::cli
