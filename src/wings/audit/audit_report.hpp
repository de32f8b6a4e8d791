#pragma once

#include <string>
#include <vector>

#include "audit/audit.hpp"
#include "words/json.hpp"

namespace dumbbell::audit {

struct AuditedFile {
    std::string path;
    double seconds = 0;
    Audit audit;
};

/// One line, without its line feed; what is wrong is left to `Audit::faults`.
[[nodiscard]] std::string to_text(const AuditedFile& file);

[[nodiscard]] Json to_json(const std::vector<AuditedFile>& files);

}  // namespace dumbbell::audit
