#include <fmt/format.h>

#include <algorithm>

#include "cli/pages/command_table.hpp"
#include "cli/pages/pages.hpp"

namespace dumbbell::cli::pages {
namespace {

constexpr const char* head = R"(# bash completion for dumbbell and dumbbell-verify
# Generated from the option table: dumbbell generate completion

_dumbbell() {
    local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD - 1]} command=dumbbell
    local i words='' options='' files=''
    # Bash takes = for a word of its own: --section=full is three.
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

/// Of all options; those of the verifier are in its own help only.
std::string names(const Command& command) {
    if (command.become != nullptr) {
        return R"sh("$(dumbbell-verify --help 2> /dev/null | sed -nE 's/^  (-., )?(--[a-z-]+).*/\2/p')")sh";
    }
    return fmt::format("'{}'", fmt::join(command.option_names(), " "));
}

/// The cases in which the word before is an option that takes a value.
void add_values(std::string& script, const Place& place) {
    for (const Option& option : place.command->options) {
        if (option.is_argument() || option.is_flag()) {
            continue;
        }
        const auto choices = option.choices();
        const std::string then = is_file(option)   ? "files=yes"
                                 : choices.empty() ? "return"
                                                   : fmt::format("words='{}'", fmt::join(choices, " "));
        for (const std::string_view name : option.names()) {
            script += fmt::format("        '{} {}') {} ;;\n", place.name, name, then);
        }
    }
    if (!place.command->topics.empty()) {
        script +=
            fmt::format("        '{} --help') words='{}' ;;\n", place.name, place.command->topic_names(" "));
    }
}

/// The case of any other word before.
void add_words(std::string& script, const Place& place) {
    const bool files = std::ranges::any_of(place.command->options,
                                           [](const Option& o) { return o.is_argument() && is_file(o); });
    script +=
        fmt::format("        '{} '*) options={} words='{}' files={} ;;\n", place.name, names(*place.command),
                    fmt::join(place.command->command_names(), " "), files ? "yes" : "");
}

}  // namespace

std::string bash_completion(const Command& program) {
    const auto all = places(program);
    std::string script = head;
    for (const Place& place : std::span(all).subspan(1)) {
        script += fmt::format("            '{0}') command='{0}' ;;\n", place.name);
    }
    script += "        esac\n    done\n    COMPREPLY=()\n    case \"$command $before\" in\n";
    // The case of a command also fits the commands below it, which come first.
    for (auto place = all.rbegin(); place != all.rend(); ++place) {
        add_values(script, *place);
        add_words(script, *place);
    }
    return script + tail;
}

}  // namespace dumbbell::cli::pages
