#include "collisions/cell_reader.hpp"

#include <fmt/core.h>

#include <utility>

#include "base/error.hpp"
#include "file/dyadic.hpp"
#include "file/lines.hpp"

namespace dumbbell::collisions {
namespace {

std::vector<Cell> tree_from(Lines& lines, Rectangle root) {
    std::vector<Cell> cells;
    std::vector<Rectangle> waiting{std::move(root)};  // the nodes to come: the next one last
    while (!waiting.empty()) {
        Rectangle box = std::move(waiting.back());
        waiting.pop_back();
        const auto& fields = lines.next();
        if (fields[0] == "cell" && fields.size() > 2) {
            cells.push_back({std::move(box), lines.count(fields[2]), lines.count(fields[1])});
        } else if (fields[0] == "open") {
            cells.push_back({std::move(box), 0, std::nullopt});
        } else if (fields[0] != "beyond") {
            const bool splits = fields[0] == "split" && fields.size() == 2;
            if (!splits || (fields[1] != "q" && fields[1] != "rho")) {
                lines.fail();
            }
            const auto side = fields[1] == "q" ? &Rectangle::q : &Rectangle::rho;
            const Rational middle = ((box.*side).lo + (box.*side).hi) / 2;
            if (msb(denominator(middle)) > most_binary_places) {
                lines.fail();
            }
            waiting.push_back(box);
            (waiting.back().*side).lo = middle;
            (box.*side).hi = middle;
            waiting.push_back(std::move(box));
        }
    }
    return cells;
}

}  // namespace

CellFile read_cells(const NamedFile& file) {
    Lines lines(file);
    if (const Head head = lines.expect_head(); head.scene != "body" || head.section != "cells") {
        throw InputError(
            fmt::format("'{}' is not about a rectangle of bodies, which is needed here (dumbbell certify "
                        "--rho LO:HI --inertia LO:HI --out FILE)",
                        file.path));
    }
    const auto ends = [&lines](const char* word) -> Range {
        const auto& fields = lines.expect(word, 3);
        return {lines.ratio(fields[1]), lines.ratio(fields[2])};
    };
    const Range q = ends("ratio");
    const Range rho = ends("rho");
    (void)lines.expect("bits", 2);
    std::vector<Cell> cells = tree_from(lines, {rho, q});
    return {std::move(cells), lines.digest()};
}

}  // namespace dumbbell::collisions
