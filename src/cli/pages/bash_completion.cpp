#include "cli/pages/bash_completion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

namespace dumbbell::pages {
namespace {

constexpr const char* head = R"(# bash completion for dumbbell and dumbbell-verify
# Generated from the option table: dumbbell generate completion

_dumbbell() {
    local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD - 1]} command=dumbbell
    local i words='' options='' files=''
    # Bash takes = for a word of its own: --scene=wedge is three.
    if [[ $before == = ]]; then
        before=${COMP_WORDS[COMP_CWORD - 2]}
    elif [[ $word == = ]]; then
        word=''
    fi
    [[ ${COMP_WORDS[0]##*/} != dumbbell-verify ]] || command='dumbbell verify'
    for ((i = 1; i < COMP_CWORD; i++)); do
        case "$command ${COMP_WORDS[i]}" in
)";

constexpr const char* tail = R"(    esac
    if [[ -n $files && $word != -* ]]; then
        compopt -o filenames 2> /dev/null
        mapfile -t COMPREPLY < <(compgen -f -- "$word")
        return
    fi
    [[ $word != -* ]] || words=$options
    mapfile -t COMPREPLY < <(compgen -W "$words" -- "$word")
}

complete -F _dumbbell dumbbell dumbbell-verify
)";

/// Of all options; every command has --help, though its table does not say so.
std::string names(const std::vector<OptionEntry>& options) {
    std::vector<std::string> all;
    for (const OptionEntry& option : options) {
        if (!option.argument) {
            all.insert(all.end(), option.names.begin(), option.names.end());
        }
    }
    if (std::find(all.begin(), all.end(), "--help") == all.end()) {
        all.emplace_back("--help");
    }
    return fmt::format("{}", fmt::join(all, " "));
}

/// The cases in which the word before is an option that takes a value.
void add_values(std::string& script, const CommandEntry& command) {
    for (const OptionEntry& option : command.options) {
        if (option.argument || option.value.empty()) {
            continue;
        }
        const std::string then = option.is_file() ? "files=yes"
                                 : option.choices.empty()
                                     ? "return"
                                     : fmt::format("words='{}'", fmt::join(option.choices, " "));
        for (const std::string& name : option.names) {
            fmt::format_to(std::back_inserter(script), "        '{} {}') {} ;;\n", command.name, name, then);
        }
    }
}

/// The case of any other word before.
void add_words(std::string& script, const CommandEntry& command) {
    std::vector<std::string> words;
    words.reserve(command.commands.size());
    for (const CommandEntry& below : command.commands) {
        words.push_back(last_word(below.name));
    }
    bool files = false;
    for (const OptionEntry& option : command.options) {
        if (option.argument) {
            files = files || option.is_file();
            words.insert(words.end(), option.choices.begin(), option.choices.end());
        }
    }
    fmt::format_to(std::back_inserter(script), "        '{} '*) options='{}' words='{}' files={} ;;\n",
                   command.name, names(command.options), fmt::join(words, " "), files ? "yes" : "");
}

}  // namespace

std::string bash_completion(const CommandEntry& program) {
    auto commands = with_all_below(program);
    std::string script = head;
    for (const CommandEntry* command : commands) {
        if (command != &program) {
            fmt::format_to(std::back_inserter(script), "            '{0}') command='{0}' ;;\n",
                           command->name);
        }
    }
    script += "        esac\n    done\n    COMPREPLY=()\n    case \"$command $before\" in\n";
    // The case of a command also fits the commands below it, which come first.
    std::reverse(commands.begin(), commands.end());
    for (const CommandEntry* command : commands) {
        add_values(script, *command);
        add_words(script, *command);
    }
    return script + tail;
}

}  // namespace dumbbell::pages
