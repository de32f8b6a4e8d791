#include "collisions/check_cost.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace dumbbell::collisions {
namespace {

constexpr double units_per_second = 6e9;
constexpr double default_seconds = 30;
constexpr double in_double = 4096;
constexpr double of_a_leaf = 10;         ///< its box, text and inequalities, in collisions
constexpr double of_other_sections = 4;  ///< their collisions are steps of boxes

double of_collision(int bits) {
    const double width = bits + 64;
    return bits > 53 ? in_double + 10 * width * width : in_double;
}

/// A ray with so many collisions. With many of them most are left to macro steps (L42): at most about so many
/// for a doubling of the collisions, each as much as so many sweeps over polynomials with this many terms,
/// which is two to three times what is needed; the last collisions go one by one.
double of_ray(const Count& collisions, int bits) {
    const auto count = static_cast<double>(collisions);
    if (count < 20'000) {
        return count * of_collision(bits);
    }
    constexpr double steps_a_doubling = 2;
    constexpr double sweeps = 4;
    const double doublings = std::log2(count);
    const double resolution = 2 * (doublings + 2) + std::max(12., bits / 8. - 20) + 1;
    const double terms = resolution / 2.2 + 4;
    const double sweep = terms * terms * 17 * (66 + resolution / 4);
    return steps_a_doubling * doublings * sweeps * sweep + 8 * (40 + terms) * of_collision(bits);
}

double of_piece(const Piece& piece) {
    const auto rays = [&](const Count& forward, const Count& backward) {
        // In double first: what it certifies needs no more.
        const double once = of_ray(forward, 53) + of_ray(backward, 53) + of_a_leaf * in_double;
        return piece.bits > 53 ? once + of_ray(forward, piece.bits) + of_ray(backward, piece.bits) : once;
    };
    double sum = 0;
    for (const ChartTree& part : piece.cover.charts) {
        for (const Node& node : part.tree) {
            sum += rays(node.leaf.forward, node.leaf.backward);
        }
    }
    return piece.witness ? sum + rays(piece.witness->forward, piece.witness->backward) : sum;
}

}  // namespace

double check_seconds(std::span<const Piece* const> pieces, Section section) {
    double units = 0;
    for (const Piece* piece : pieces) {
        units += of_piece(*piece);
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

}  // namespace dumbbell::collisions
