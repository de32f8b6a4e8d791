#include "audit/audit_report.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "base/printable.hpp"
#include "words/printed.hpp"

namespace dumbbell::audit {
std::string to_text(const AuditedFile& file) {
    const Audit& a = file.audit;
    std::string boxless;
    if (a.equal_masses > 0) {
        boxless += fmt::format(" ({} by lemma L7, without boxes)", a.equal_masses);
    }
    if (a.without_cover > 0) {
        boxless += fmt::format(" ({} without upper bound)", a.without_cover);
    }
    return fmt::format(
        "{}: {}: {}{}, {}, {}, {} checked, area {}, {:.2f} s", one_line(file.path),
        a.tiles() ? "tiles exactly" : "does NOT tile", plural(a.pieces, "piece"), boxless,
        plural(a.charts, "chart"), fmt::format("{} {}", a.leaves, a.leaves == 1 ? "leaf" : "leaves"),
        plural(a.pairs, "candidate pair"), a.tiles() ? "exact" : "not confirmed", file.seconds);
}

Json to_json(const std::vector<AuditedFile>& files) {
    Json rows = Json::array();
    for (const AuditedFile& file : files) {
        const Audit& a = file.audit;
        rows.add(Json::object({{"file", file.path},
                               {"tiles", a.tiles()},
                               {"pieces", a.pieces},
                               {"pieces_equal_masses", a.equal_masses},
                               {"pieces_without_upper_bound", a.without_cover},
                               {"charts", a.charts},
                               {"leaves", a.leaves},
                               {"candidate_pairs", a.pairs},
                               {"area_exact", a.tiles()},
                               {"faults", Json::array(a.faults)},
                               {"seconds", file.seconds}}));
    }
    const bool all = std::ranges::all_of(files, [](const AuditedFile& file) { return file.audit.tiles(); });
    return Json::object({{"schema", "dumbbell-audit-1"}, {"tiles", all}, {"files", rows}});
}

}  // namespace dumbbell::audit
