#pragma once

#include <CLI/App.hpp>
#include <string>
#include <vector>

/// The commands and options of the programs as data, read from the table that parses the command line: what
/// the man page, the completion and the reference are made from.
namespace dumbbell::pages {

struct OptionEntry {
    std::vector<std::string> names;    ///< --out; of an argument its one name, FILE
    std::string value;                 ///< how its value is called: TIME, dumbbell|wedge; empty: a flag
    std::vector<std::string> choices;  ///< all values that there are, if it takes certain words only
    std::string standard;              ///< the value without it; empty: none
    std::string text;                  ///< what it means
    bool argument = false;             ///< no option: its place on the command line says what it is
    bool required = false;
    bool repeated = false;              ///< an argument that takes any number of words
    std::vector<std::string> excluded;  ///< options that cannot be given with it

    /// Is its value the name of a file?
    [[nodiscard]] bool is_file() const;
};

struct CommandEntry {
    std::string name;    ///< dumbbell plot staircase
    std::string called;  ///< as it is typed, with what stands between: dumbbell campaign plan FOLDER verify
    std::string description;  ///< paragraphs; indented lines stand as they are
    std::string footer;       ///< exit codes
    std::vector<OptionEntry> options;
    std::vector<CommandEntry> commands;
};

/// What CLI11 knows about an option.
[[nodiscard]] OptionEntry option_entry(const CLI::Option& option);

/// What CLI11 knows about a program, but for hidden commands and for the help options of its commands.
[[nodiscard]] CommandEntry command_table(const CLI::App& app);

/// The same of dumbbell-verify, which has no table but the text of its --help: paragraphs with its usage, its
/// options, examples, and exit codes. Throws BrokenInvariant if the text has another shape.
[[nodiscard]] CommandEntry verifier_table(const std::string& name, const std::string& help);

/// The last part of the name: staircase.
[[nodiscard]] std::string last_word(const std::string& name);

/// The command and all below it, each before its own commands.
[[nodiscard]] std::vector<const CommandEntry*> with_all_below(const CommandEntry& command);

/// Whether it does something itself, and not only by the commands below it.
[[nodiscard]] bool is_called(const CommandEntry& command);

/// How it is called: the name, [OPTIONS], and the arguments; without arguments COMMAND, if there are any
/// below it.
[[nodiscard]] std::string usage(const CommandEntry& command);

/// The option as it is typed: `--out FILE`.
[[nodiscard]] std::string spelling(const OptionEntry& option);

/// What it means, with what it needs to be known: required, the value without it, what it excludes.
[[nodiscard]] std::string meaning(const OptionEntry& option);

/// A part of a description: lines that are one paragraph, or lines that stand as they are.
struct Block {
    std::vector<std::string> lines;
    bool verbatim = false;
};
[[nodiscard]] std::vector<Block> blocks(const std::string& description);

}  // namespace dumbbell::pages
