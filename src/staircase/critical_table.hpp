#pragma once

#include <string>
#include <vector>

namespace dumbbell::staircase {

/// One line of a table of critical ratios, as `dumbbell critical --out` writes it: q_c(n) as the first digits
/// that are proved, and the orbit whose flight is tangent there.
struct CriticalTableRow {
    long n;
    std::string q_c;
    std::string radius;
    long bits;
    std::string orbit;
    long flight;
};

struct CriticalTable {
    std::string sha256;  ///< of the file's text; there is none in the file
    std::vector<CriticalTableRow> rows;

    /// The greatest number of digits of a q_c.
    [[nodiscard]] int digits() const;
};

/// Whether the file (plain or gzip) begins as such a table does; false if it cannot be read.
[[nodiscard]] bool is_critical_table(const std::string& path);

/// Throws InputError (naming file and line) for what is no such table.
[[nodiscard]] CriticalTable read_critical_table(const std::string& path);

}  // namespace dumbbell::staircase
