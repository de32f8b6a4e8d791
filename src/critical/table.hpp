#pragma once

#include <string>

#include "base/interrupted.hpp"
#include "critical/report.hpp"

/// Tables of critical ratios, as `dumbbell critical --out` writes them, read back and checked.
namespace dumbbell::critical {

/// Whether the file (plain or gzip) begins as such a table does; false if it cannot be read.
[[nodiscard]] bool is_table(const std::string& path);

/// Its rows, for consecutive N, with the enclosures that it states, and its digits, 0 if no row tells. Throws
/// InputError (naming file and line) for what is not, byte by byte, such a table.
[[nodiscard]] Report read_table(const std::string& path);

/// Why the rows are not certain; empty if each ratio is certain to lie where it says, by
/// `certainly_encloses`, or says nothing.
[[nodiscard]] std::string objection(const Report& table, const Interrupted& interrupted);

}  // namespace dumbbell::critical
