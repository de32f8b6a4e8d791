#include "collisions/check_cost.hpp"

#include <array>

namespace dumbbell {
namespace {

constexpr double units_per_second = 6e9;
constexpr double default_seconds = 30;
constexpr double in_double = 4096;
constexpr double of_a_leaf = 10;         ///< its box, text and inequalities, in collisions
constexpr double of_other_sections = 4;  ///< their collisions are steps of boxes

double of_collision(int bits) {
    const double width = bits + 64;
    return bits > 53 ? in_double + 40 * width * width : in_double;
}

double collisions(const Piece& piece) {
    double sum = 0;
    for (const ChartTree& part : piece.cover.charts) {
        for (const Node& node : part.tree) {
            sum +=
                static_cast<double>(node.leaf.forward) + static_cast<double>(node.leaf.backward) + of_a_leaf;
        }
    }
    return sum + (piece.witness ? static_cast<double>(piece.witness->total()) + of_a_leaf : 0);
}

}  // namespace

double check_seconds(std::span<const Piece* const> pieces, Section section) {
    double units = 0;
    for (const Piece* piece : pieces) {
        units += collisions(*piece) * of_collision(piece->bits);
    }
    return units * (section == Section::turning ? 1 : of_other_sections) / units_per_second;
}

std::optional<std::string> budget_option(double seconds) {
    struct Budget {
        double seconds;
        const char* text;
    };
    constexpr std::array<Budget, 11> budgets{{{60, "1m"},
                                              {120, "2m"},
                                              {300, "5m"},
                                              {600, "10m"},
                                              {1800, "30m"},
                                              {3600, "1h"},
                                              {4 * 3600, "4h"},
                                              {24 * 3600, "24h"},
                                              {168 * 3600, "168h"},
                                              {1000 * 3600, "1000h"},
                                              {99999 * 3600., "99999h"}}};  // it takes five digits
    if (seconds <= default_seconds) {
        return "";
    }
    for (const Budget& budget : budgets) {
        if (seconds <= budget.seconds) {
            return std::string("--budget ") + budget.text + " ";
        }
    }
    return std::nullopt;
}

}  // namespace dumbbell
