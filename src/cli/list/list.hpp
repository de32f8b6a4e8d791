#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "cli/options/given.hpp"
#include "cli/terminal/output.hpp"
#include "number/count.hpp"
#include "number/ratio_argument.hpp"
#include "words/json.hpp"

/// `--list FILE`: what a command says of one mass ratio, for many, in the same way for every command.
namespace dumbbell::cli {

inline constexpr Option list_option =
    Option{"--list", "FILE", "the ratios that FILE has, one a line (-: the standard input)"}.of("lists");
inline constexpr Option strict_option =
    flag("--strict", "stop at the first line that is no mass ratio").needs("--list").of("lists");
/// What every command says of them, which ends with examples of its own.
inline constexpr const char* lists_text =
    R"(Answer each line of a file: a table with tabs, or with --json a line of JSON each.

A line is a mass ratio, a range where the command takes one, or the first column of CSV. # begins a comment. A line that
is wrong does not stop the others: its row says what is wrong with it.)";
/// --out of a command that writes certificates and takes --list.
inline constexpr Option certificates_option = certificate_option.checked([](const std::string& name) {
    return name.empty() ? fault_of_name(name, std::nullopt) : std::string();  // it may be a folder's
});

/// Bounds of the number of collisions, for every mass ratio of [q_lo, q_hi].
struct ListRow {
    Rational q_lo, q_hi;
    Count lower;
    std::optional<Count> upper;  ///< nothing: none is proved
};

/// What a command says of a line.
struct ListAnswer {
    std::vector<ListRow> rows{};  ///< one or more, in ascending order
    bool is_decided = true;
    Json json{};                ///< with --json
    std::string certificate{};  ///< with --out
    std::string claim{};        ///< that it proves, as options of the verifier; only if `is_decided`
};

/// Answers one line, of which `number` is the first column, on any thread, and on it alone. `out`: the name
/// under which the certificate will be kept; empty: none is wanted. An InputError is that of the line.
using AnswerLine = std::function<ListAnswer(const std::string& number, const std::string& out)>;

/// Answers the lines of --list on --jobs threads, and prints what is said in their order, as it comes.
/// Returns the exit code: that of a bad line if there is one, else that of one that is not decided. Throws
/// InputError if the list cannot be read or has no ratio, and with --strict for the first bad line.
/// `claims_of`: as CertificateFolder has it.
[[nodiscard]] int answer_list(const Given& given, const AnswerLine& answer,
                              const std::string& claims_of = "");

/// Throws InputError if --out, where one certificate is written, is no name for one.
void require_certificate_name(const Given& given);

/// RATIO of a command that takes --list instead, and was not given it. Throws InputError if there is none, or
/// --out names no certificate.
[[nodiscard]] RatioArgument given_ratio(const Given& given);

}  // namespace dumbbell::cli
