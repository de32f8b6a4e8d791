#include "cli/pages/command_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <regex>
#include <sstream>

#include "base/error.hpp"

namespace dumbbell::pages {
namespace {

std::vector<std::string> split(const std::string& text, char separator) {
    std::vector<std::string> parts;
    std::istringstream in(text);
    for (std::string part; std::getline(in, part, separator);) {
        parts.push_back(part);
    }
    return parts;
}

std::string joined(const std::vector<std::string>& words, const char* separator) {
    return fmt::format("{}", fmt::join(words, separator));
}

/// CLI11 spells a value and the check of it as one: `TEXT:{turning,full}`, `INT:INT in [1 - 1024]`.
void read_value(const std::string& type, OptionEntry& entry) {
    static const std::regex words(R"(.*:\{(.*)\})");
    static const std::regex range(R"((.*):\w+ in \[(.*) - (.*)\])");
    std::smatch found;
    if (std::regex_match(type, found, words)) {
        entry.choices = split(found[1], ',');
        entry.value = joined(entry.choices, "|");
    } else if (std::regex_match(type, found, range)) {
        entry.value = "N";
        entry.text += fmt::format(" ({} to {})", found[2].str(), found[3].str());
    } else {
        entry.value = type;
    }
}

CommandEntry table_of(const CLI::App& app, const std::string& above, const std::string& before) {
    CommandEntry command{
        above + app.get_name(), before + app.get_name(), app.get_description(), app.get_footer(), {}, {}};
    for (const CLI::Option* option : app.get_options()) {
        const bool help = option == app.get_help_ptr() || option == app.get_help_all_ptr();
        if (!help || app.get_parent() == nullptr) {
            command.options.push_back(option_entry(*option));
        }
    }
    std::string between = " ";
    for (const OptionEntry& option : command.options) {
        between += option.argument && option.required ? spelling(option) + " " : "";
    }
    for (const CLI::App* below :
         app.get_subcommands([](const CLI::App* c) { return !c->get_group().empty(); })) {
        command.commands.push_back(table_of(*below, command.name + " ", command.called + between));
    }
    return command;
}

/// The lines that begin with two blanks and `--`, and those that go on with them.
std::vector<OptionEntry> options_in(const std::string& help) {
    static const std::regex line(R"(  (--[a-z-]+)(?:, (--[a-z-]+))?(?: (\S+)( A B)?)? *(.*))");
    static const std::regex words(R"([a-z0-9.-]+(\|[a-z0-9.-]+)+)");
    std::vector<OptionEntry> options;
    std::smatch found;
    for (const std::string& text : split(help, '\n')) {
        if (!std::regex_match(text, found, line)) {
            options.back().text += " " + text.substr(text.find_first_not_of(' '));
            continue;
        }
        OptionEntry& entry = options.emplace_back();
        entry.names = {found[1]};
        if (found[2].matched) {
            entry.names.push_back(found[2]);
        }
        const std::string value = found[3];
        entry.value = value + found[4].str();
        entry.text = found[5];
        if (std::regex_match(value, words)) {
            entry.choices = split(value, '|');
        }
    }
    return options;
}

void collect(const CommandEntry& command, std::vector<const CommandEntry*>& all) {
    all.push_back(&command);
    for (const CommandEntry& below : command.commands) {
        collect(below, all);
    }
}

}  // namespace

bool OptionEntry::is_file() const { return value.starts_with("FILE") || value == "LIST" || value == "PARTS"; }

OptionEntry option_entry(const CLI::Option& option) {
    OptionEntry entry;
    entry.argument = option.get_positional();
    entry.names =
        entry.argument ? std::vector{option.get_name(true)} : split(option.get_name(false, true), ',');
    entry.text = option.get_description();
    entry.required = option.get_required();
    entry.standard = option.get_default_str();
    entry.repeated = option.get_expected_max() > 1;
    if (entry.argument) {
        entry.value = entry.names.front();
    } else if (option.get_type_size() != 0) {
        read_value(option.get_type_name(), entry);
    }
    for (const CLI::Option* other : option.get_excludes()) {
        entry.excluded.push_back(other->get_name());
    }
    std::ranges::sort(entry.excluded);  // a set of pointers has another order each time
    return entry;
}

CommandEntry command_table(const CLI::App& app) { return table_of(app, "", ""); }

CommandEntry verifier_table(const std::string& name, const std::string& help) {
    std::vector<std::string> parts;
    for (std::size_t from = 0; from < help.size();) {
        const std::size_t end = std::min(help.find("\n\n", from), help.size());
        parts.push_back(help.substr(from, end - from));
        from = end + 2;
    }
    if (parts.size() != 4 || !parts[0].starts_with("usage: ") || !parts[1].starts_with("  --")) {
        throw BrokenInvariant("dumbbell-verify --help has another shape than it had");
    }
    const std::string sentence = parts[0].substr(parts[0].rfind('\n') + 1);
    CommandEntry command{name, name, sentence + "\n\n" + parts[2], parts[3], options_in(parts[1]), {}};
    OptionEntry& files = command.options.emplace_back();
    files.names = {"FILE"};
    files.value = "FILE";
    files.text = "certificates";
    files.argument = true;
    files.repeated = true;
    return command;
}

std::string last_word(const std::string& name) { return name.substr(name.rfind(' ') + 1); }

std::vector<const CommandEntry*> with_all_below(const CommandEntry& command) {
    std::vector<const CommandEntry*> all;
    collect(command, all);
    return all;
}

bool is_called(const CommandEntry& command) {
    return command.commands.empty() || std::any_of(command.options.begin(), command.options.end(),
                                                   [](const OptionEntry& o) { return o.argument; });
}

std::string usage(const CommandEntry& command) {
    std::string text = command.called;
    const bool options = std::any_of(command.options.begin(), command.options.end(),
                                     [](const OptionEntry& o) { return !o.argument; });
    text += options ? " [OPTIONS]" : "";
    text += is_called(command) ? "" : " COMMAND";
    for (const OptionEntry& option : command.options) {
        text += option.argument ? " " + spelling(option) : "";
    }
    return text;
}

std::string spelling(const OptionEntry& option) {
    const std::string name = joined(option.names, ", ") + (option.argument && option.repeated ? "..." : "");
    return option.argument || option.value.empty() ? name : name + " " + option.value;
}

std::string meaning(const OptionEntry& option) {
    return option.text + (option.required && !option.argument ? "; required" : "") +
           (option.standard.empty() ? "" : "; default: " + option.standard) +
           (option.excluded.empty() ? "" : "; not with " + joined(option.excluded, ", "));
}

std::vector<Block> blocks(const std::string& description) {
    std::vector<Block> result;
    bool fresh = true;
    for (const std::string& line : split(description, '\n')) {
        const bool verbatim = line.starts_with("  ");
        if (!line.empty()) {
            if (fresh || result.back().verbatim != verbatim) {
                result.push_back({{}, verbatim});
            }
            result.back().lines.push_back(verbatim ? line.substr(2) : line);
        }
        fresh = line.empty();
    }
    return result;
}

}  // namespace dumbbell::pages
