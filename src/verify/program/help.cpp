#include "verify/program/help.hpp"

#include <algorithm>

#include "verify/program/option_table.hpp"

namespace dumbbell_verify {
namespace {

constexpr std::string_view
    usage = R"(dumbbell-verify [options] FILE...
       dumbbell-verify [options] --claims LIST
)",
    purpose = R"(Checks certificates (docs/reference/format.md) independently of the program that wrote them.
)",
    examples = R"(  dumbbell-verify --ratio 10 --exactly 4 ten.dbc       is N*(10) = 4 proved?
  dumbbell-verify --ratio 2:5/2 --max 3 stairs.dbc     at most 3 collisions on a part of the file's range?
  dumbbell-verify ten.dbc                              what does this file prove?
  dumbbell-verify --explain 1:bridge ten.dbc           one leaf, in numbers
  dumbbell-verify --claim initial-conditions --min 1 falling.dbc    at least one collision from every start?
  dumbbell-verify --claims certificates/claims.tsv     in CI: every certificate, its own claim
  dumbbell-verify --ratio 3 --max 3 *.dbc | tail -n 1               how many files prove this?
  dumbbell-verify --budget 10m huge.dbc                a staircase up to 10^8
  dumbbell-verify --jobs 1 --precision 200 --max-bits 4096 ten.dbc  slowly, in multiple precision, on one thread
)",
    verdicts =
        R"(FILE `-` is the standard input. For one file a sentence says what is proved, and the last line is the verdict: s VERIFIED,
s OPEN, s REJECTED, s UNSUPPORTED, s UNREADABLE or s LIMIT. Each of several files has one such line with its name, in
the given order, and a line of totals ends them: c files=3 verified=2 ...
)",
    exit_codes =
        R"(Exit codes: 0 verified and proved; 1 rejected; 2 usage or unreadable; 3 unsupported, or open (no claim is stated, and no
bound is proved for all that is in question); 4 resource limit. If files differ: the first of 1, 4, 3, 2, 0.
)";

constexpr std::size_t width = 118, column = 24;

/// The option, and what it means in lines that begin at the column.
std::string entry(const Option& option) {
    std::string line = "  " + std::string(option.name), text;
    if (!option.value.empty()) line += " " + std::string(option.value);
    line.resize(std::max(line.size() + 2, column), ' ');
    for (std::string_view rest = option.text; !rest.empty();) {
        const std::string_view word = rest.substr(0, rest.find(' '));
        if (line.size() + 1 + word.size() > width) {
            text += line + "\n";
            line.assign(column, ' ');
        }
        line += (line.ends_with(' ') ? "" : " ") + std::string(word);
        rest.remove_prefix(std::min(rest.size(), word.size() + 1));
    }
    return text + line + "\n";
}

/// Text as groff prints it unchanged: a minus is one that can be copied.
std::string groff(std::string_view text) {
    std::string page;
    for (const char c : text)
        page += c == '\\'   ? "\\e"
                : c == '-'  ? "\\-"
                : c == '^'  ? "\\(ha"
                : c == '`'  ? "\\(ga"
                : c == '\'' ? "\\(aq"
                            : std::string(1, c);
    return page;
}

std::string section(const std::string& name, std::string_view text, bool verbatim = false) {
    return ".SH " + name + "\n" + (verbatim ? ".nf\n" + groff(text) + ".fi\n" : groff(text));
}

}  // namespace

std::string help() {
    std::string text = "usage: " + std::string(usage) + std::string(purpose) + "\n";
    for (const Option& option : option_table()) text += entry(option);
    for (const std::string_view part : {examples, verdicts}) text += "\n" + std::string(part);
    return text + std::string(exit_codes);
}

std::string man_page() {
    std::string page = ".TH DUMBBELL\\-VERIFY 1 \"\" \"dumbbell\" \"User Commands\"\n";
    page += section("NAME", "dumbbell-verify - check certificates of the bouncing dumbbell independently\n");
    page += section("SYNOPSIS", "       " + std::string(usage), true);
    page += section("DESCRIPTION", purpose) + ".PP\n" + groff(verdicts) + ".SH OPTIONS\n";
    for (const Option& option : option_table())
        page += ".TP\n\\fB" + groff(option.name) + "\\fR \\fI" + groff(option.value) + "\\fR\n" +
                groff(option.text) + "\n";
    return page + section("EXIT STATUS", exit_codes) + section("EXAMPLES", examples, true) +
           section("SEE ALSO", "dumbbell(1)\n");
}

}  // namespace dumbbell_verify
