#include "words/text_table.hpp"

#include <algorithm>

namespace dumbbell {

std::string aligned(const std::vector<TableLine>& lines, std::size_t left) {
    std::vector<std::size_t> widths;
    for (const TableLine& line : lines) {
        widths.resize(line.size());
        for (std::size_t i = 0; i < line.size(); ++i) {
            widths[i] = std::max(widths[i], line[i].size());
        }
    }
    std::string text;
    for (const TableLine& line : lines) {
        for (std::size_t i = 0; i < line.size(); ++i) {
            const std::string padding(widths[i] - line[i].size(), ' ');
            text += i == left ? line[i] + padding : padding + line[i];
            text += i + 1 < line.size() ? "  " : "\n";
        }
    }
    return text;
}

}  // namespace dumbbell
