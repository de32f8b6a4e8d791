#include "cli/options/usage_error.hpp"

#include <fmt/format.h>

#include "base/fields.hpp"
#include "cli/options/hint.hpp"

namespace dumbbell::cli {

std::string missing_command(const Command& program, const std::vector<std::string>& words) {
    const Command* command = &program;
    std::string called;  // empty: the program itself
    for (const std::string& word : words) {
        const std::string here = called.empty() ? "there is" : called + " has";
        if (const Command* below = command->below(word)) {
            command = below;
            called += (called.empty() ? "" : " ") + word;
        } else if (!word.starts_with('-')) {
            return fmt::format("{} no command '{}'", here, word);
        } else {
            return fmt::format("{} no option '{}'", here, word);
        }
    }
    return fmt::format("{} needs a command: {}", called.empty() ? program.name : called,
                       fmt::join(names_of_commands(*command), ", "));
}

std::string unknown_command(const Command& program, const std::vector<std::string>& words) {
    const Command* command = &program;
    std::vector<std::string> commands;
    for (const std::string& word : words) {
        if (command->run != nullptr || command->become != nullptr) {
            break;
        }
        if (word.starts_with('-')) {
            continue;
        }
        commands.push_back(word);
        command = command->below(word);
        if (command == nullptr) {
            return missing_command(program, commands);
        }
    }
    return "";
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
        if (!option->needed.empty() && !given.has(option->needed)) {
            return fmt::format("{} requires {}", option->name, option->needed);
        }
        for (const std::string_view other : split(option->excluded, ',')) {
            if (!other.empty() && given.has(other)) {
                return fmt::format("{} and {} exclude each other", option->name, other);
            }
        }
    }
    return "";
}

}  // namespace dumbbell::cli
