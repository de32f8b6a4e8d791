#include "cli/options/usage_error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <utility>

#include "base/fields.hpp"

namespace dumbbell::cli {
namespace {

/// The number of letters to insert, remove, replace or exchange with their neighbour.
std::size_t distance(std::string_view a, std::string_view b) {
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
std::string meant(std::string_view word, const std::vector<std::string_view>& names) {
    constexpr std::size_t longest = 40, far = 3;
    if (word.size() > longest || names.empty()) {
        return "";
    }
    const auto nearest = std::min_element(names.begin(), names.end(), [&](const auto& a, const auto& b) {
        return distance(word, a) < distance(word, b);
    });
    const std::size_t steps = distance(word, *nearest);
    const bool is_near = steps < far && 2 * steps < nearest->size();
    return steps > 0 && (is_near || word.starts_with(*nearest)) ? fmt::format("did you mean {}? ", *nearest)
                                                                : "";
}

bool excludes(const Option& option, const Option& other) {
    const auto excluded = split(option.excluded, ',');
    return std::ranges::find(excluded, other.name) != excluded.end();
}

}  // namespace

std::string hint(const Command& program, const std::vector<std::string>& words) {
    const Command* command = &program;
    std::string called(program.name), suggestion;
    for (const std::string& word : words) {
        const Command* below = command->below(word);
        if (below != nullptr && !below->group.empty()) {
            command = below;
            called += " " + word;
        } else if (suggestion.empty() && word.starts_with("--")) {
            suggestion = meant(word.substr(0, word.find('=')), command->option_names());
        } else if (suggestion.empty() && !word.starts_with('-')) {
            suggestion = meant(word, command->command_names());
        }
    }
    return fmt::format("{}see {} --help", suggestion, called);
}

std::string wrong_command(const Command& program, const std::vector<std::string>& words, bool asks_help) {
    const Command* command = &program;
    std::string called;  // empty: the program itself
    for (const std::string& word : words) {
        const std::string here = called.empty() ? "there is" : called + " has";
        const bool is_option = word.starts_with('-');
        if (const Command* below = command->below(word)) {
            command = below;
            called += (called.empty() ? "" : " ") + word;
        } else if (command->commands.empty()) {
            return "";
        } else if (!is_option || !asks_help) {
            return fmt::format("{} no {} '{}'", here, is_option ? "option" : "command", word);
        }
    }
    return asks_help ? ""
                     : fmt::format("{} needs a command: {}", called.empty() ? program.name : called,
                                   fmt::join(command->command_names(), ", "));
}

std::string unexpected(const std::vector<std::string>& words) {
    return words.size() == 1 && words[0].size() > 1 && words[0][0] == '-'
               ? fmt::format("there is no option '{}' here", words[0])
               : fmt::format("not expected here: '{}'", fmt::join(words, "', '"));
}

std::string mismatch(const Given& given, const std::string& last_word) {
    for (const auto& [option, words] : given.values()) {
        if (words.size() > 1 && !option->is_repeated) {
            return fmt::format("{} is given {} times: give it once", option->name, words.size());
        }
    }
    return fmt::format("{} needs a value", last_word.substr(0, last_word.find('=')));
}

std::string contradiction(const Given& given) {
    for (const auto& [option, words] : given.values()) {
        if (words.empty()) {
            continue;
        }
        const auto any_of = split(option->needed, ',');
        if (!option->needed.empty() &&
            std::ranges::none_of(any_of, [&](std::string_view other) { return given.has(other); })) {
            return fmt::format("{} requires {}", option->name, fmt::join(any_of, " or "));
        }
        for (const auto& [other, words_of_other] : given.values()) {
            if (!words_of_other.empty() && excludes(*option, *other)) {
                return fmt::format("{} and {} exclude each other: leave one of them out", option->name,
                                   other->name);
            }
        }
    }
    return "";
}

}  // namespace dumbbell::cli
