#include "cli/options/hint.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <numeric>
#include <utility>

namespace dumbbell::cli {
namespace {

/// The number of letters to insert, remove, replace or exchange with their neighbour.
std::size_t distance(const std::string& a, const std::string& b) {
    std::vector<std::size_t> last, before, now(b.size() + 1);
    std::iota(now.begin(), now.end(), 0);
    for (std::size_t i = 1; i <= a.size(); ++i) {
        last = std::exchange(before, now);
        now[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            now[j] =
                std::min({before[j] + 1, now[j - 1] + 1, before[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1)});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) {
                now[j] = std::min(now[j], last[j - 2] + 1);
            }
        }
    }
    return now[b.size()];
}

/// `did you mean X? ` for the nearest of the names, if it is near.
std::string meant(const std::string& word, const std::vector<std::string>& names) {
    constexpr std::size_t longest = 40, far = 3;
    if (word.size() > longest || names.empty()) {
        return "";
    }
    const auto nearest = std::min_element(names.begin(), names.end(), [&](const auto& a, const auto& b) {
        return distance(word, a) < distance(word, b);
    });
    const std::size_t steps = distance(word, *nearest);
    return steps > 0 && steps < far && 2 * steps < nearest->size()
               ? fmt::format("did you mean {}? ", *nearest)
               : "";
}

std::vector<std::string> names_of_options(const Command& command) {
    std::vector<std::string> names{"--help", "--help-all"};
    for (const Option& option : command.options) {
        names.push_back(option.names().back());
    }
    return names;
}

}  // namespace

std::vector<std::string> names_of_commands(const Command& command) {
    std::vector<std::string> names;
    for (const Command* below : command.commands) {
        if (!below->group.empty()) {
            names.emplace_back(below->name);
        }
    }
    return names;
}

std::string hint(const Command& program, const std::vector<std::string>& words) {
    const Command* command = &program;
    std::string called(program.name), suggestion;
    for (const std::string& word : words) {
        const Command* below = command->below(word);
        if (below != nullptr && !below->group.empty()) {
            command = below;
            called += " " + word;
        } else if (suggestion.empty() && word.starts_with("--")) {
            suggestion = meant(word.substr(0, word.find('=')), names_of_options(*command));
        } else if (suggestion.empty() && !word.starts_with('-')) {
            suggestion = meant(word, names_of_commands(*command));
        }
    }
    return fmt::format("{}see {} --help", suggestion, called);
}

}  // namespace dumbbell::cli
