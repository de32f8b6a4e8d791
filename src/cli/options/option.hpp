#pragma once

#include <algorithm>
#include <array>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/fields.hpp"

/// The commands and options of the program as data. The command line is read by them, and help, man page
/// and reference are made from them.
namespace dumbbell::cli {

class Given;

/// An option of a command, or an argument: a word whose place on the command line says what it is.
struct Option {
    std::string_view name;        ///< --out, also -h,--help; of an argument FILE
    std::string_view value;       ///< the name of its value, TIME; or its words: turning|full; empty: a flag
    std::string_view text;        ///< what it means
    std::string_view standard{};  ///< the value without it; empty: none
    long least = 0, most = 0;     ///< of a whole number; both 0: it is none
    /// What is wrong with a value, empty if nothing is; null: nothing can be.
    std::string (*fault)(const std::string& value) = nullptr;
    bool is_required = false;
    bool is_repeated = false;     ///< takes any number of words
    std::string_view needed{};    ///< options, one of which it needs to mean anything, with commas between
    std::string_view excluded{};  ///< options that cannot be given with it, with commas between
    std::string_view topic{};     ///< the topic that it belongs to; empty: none

    /// The same option with another value of a property.
    template <class T>
    [[nodiscard]] constexpr Option with(T Option::*property, T changed) const {
        Option other = *this;
        other.*property = changed;
        return other;
    }
    [[nodiscard]] constexpr Option from(long first, long last) const {
        return with(&Option::least, first).with(&Option::most, last);
    }
    [[nodiscard]] constexpr Option checked(std::string (*check)(const std::string& value)) const {
        return with(&Option::fault, check);
    }
    [[nodiscard]] constexpr Option required() const { return with(&Option::is_required, true); }
    [[nodiscard]] constexpr Option repeated() const { return with(&Option::is_repeated, true); }
    [[nodiscard]] constexpr Option needs(std::string_view options) const {
        return with(&Option::needed, options);
    }
    [[nodiscard]] constexpr Option excludes(std::string_view options) const {
        return with(&Option::excluded, options);
    }
    [[nodiscard]] constexpr Option of(std::string_view which) const { return with(&Option::topic, which); }
    [[nodiscard]] constexpr Option saying(std::string_view words) const { return with(&Option::text, words); }

    [[nodiscard]] bool is_argument() const { return !name.starts_with('-'); }
    [[nodiscard]] bool is_flag() const { return !is_argument() && value.empty(); }
    [[nodiscard]] std::vector<std::string_view> names() const { return split(name, ','); }
    /// All values that there are, if it takes certain words only.
    [[nodiscard]] std::vector<std::string_view> choices() const;
};

[[nodiscard]] constexpr Option flag(std::string_view name, std::string_view text) { return {name, "", text}; }
[[nodiscard]] constexpr Option argument(std::string_view name, std::string_view text) {
    return {name, "", text};
}

/// The options of these parts, one after the other.
template <std::size_t... n>
[[nodiscard]] constexpr std::array<Option, (n + ...)> joined(const std::array<Option, n>&... parts) {
    std::array<Option, (n + ...)> all;
    auto end = all.begin();
    ((end = std::copy(parts.begin(), parts.end(), end)), ...);
    return all;
}

/// What only some users of a command need, by options that belong to it. It has a help of its own: --help
/// NAME.
struct Topic {
    std::string_view name;
    std::string_view text;      ///< paragraphs
    std::string_view examples;  ///< of one command, and what else it alone says
};

struct Command {
    std::string_view name;
    std::string_view group;   ///< the heading over it in a help; empty: it is not shown
    std::string_view text;    ///< paragraphs; the first line says what it is for
    std::string_view footer;  ///< exit codes; empty: those of the command above
    std::span<const Option> options;
    /// Does it, and returns the exit code; null: it is nothing but its commands.
    int (*run)(const Given&);
    std::span<const Command* const> commands{};
    /// Starts another program instead, which reads its own command line: the words after the name.
    void (*become)(const std::vector<std::string>& words) = nullptr;
    std::span<const Topic> topics{};

    /// The command of this name below it, or null.
    [[nodiscard]] const Command* below(std::string_view name) const;
    /// Of those below it that its help shows.
    [[nodiscard]] std::vector<std::string_view> command_names() const;
    /// All names of its options, and --help.
    [[nodiscard]] std::vector<std::string_view> option_names() const;
    /// Of its topics, in one text.
    [[nodiscard]] std::string topic_names(const char* between) const;
};

/// The groups of a help: what most users want, or all if there is but one; and the rest.
inline constexpr const char* first_group = "Commands";
inline constexpr const char* more_group = "More";
/// Of a command below another: the footer, if it is that of the one above.
inline constexpr const char* inherited = "";

/// What every command has, though its table does not say so; --version the program alone.
inline constexpr Option help_option = flag("-h,--help", "Print this help message and exit");
inline constexpr Option version_option = flag("-V,--version", "Display program version information and exit");

/// Options that several commands have.
inline constexpr Option jobs_option =
    Option{"--jobs", "N", "threads; the result does not depend on it", "all cores"}.from(1, 1024);
inline constexpr Option budget_option = Option{"--budget", "TIME", "stop after this time: 30s, 10m, 2h"};
inline constexpr Option part_option =
    Option{"--part", "K/N", "the K-th of N parts of a range, of about equal cost (dumbbell join)"};
inline constexpr Option json_option = flag("--json", "one JSON object on stdout (docs/reference/json.md)");

}  // namespace dumbbell::cli
