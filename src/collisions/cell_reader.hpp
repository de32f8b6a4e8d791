#pragma once

#include <optional>
#include <string>
#include <vector>

#include "collisions/cells.hpp"
#include "file/file_contents.hpp"

namespace dumbbell::collisions {

/// All bodies of a rectangle have from `lower` to `upper` collisions; without `upper` nothing is said.
struct Cell {
    Rectangle bodies;
    Count lower;
    std::optional<Count> upper;

    [[nodiscard]] bool is_exact() const { return upper == lower; }
};

struct CellFile {
    std::vector<Cell> cells;
    std::string sha256;  ///< as its last line has it, if that is right
};

/// Reads a certificate of the section cells (format-sections.md, section 6); what is `beyond` is no cell.
/// This is no verification. Throws InputError (naming file and line) if it is none.
[[nodiscard]] CellFile read_cells(const NamedFile& file);

}  // namespace dumbbell::collisions
