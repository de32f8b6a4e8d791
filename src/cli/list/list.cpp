#include "cli/list/list.hpp"

#include <fmt/core.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cstdio>
#include <optional>
#include <string_view>
#include <utility>

#include "base/deadline.hpp"
#include "base/error.hpp"
#include "base/printable.hpp"
#include "cli/list/certificate_folder.hpp"
#include "cli/terminal/common.hpp"
#include "cli/terminal/exit_code.hpp"
#include "cli/terminal/messages.hpp"
#include "cli/terminal/stop_signals.hpp"
#include "file/in_order.hpp"
#include "file/incoming_lines.hpp"
#include "number/decimal.hpp"
#include "words/printed.hpp"

namespace dumbbell::cli {
namespace {

constexpr const char* heading =
    "line\tgiven\tratio_lo\tratio_lo_decimal\tratio_hi\tratio_hi_decimal\tlower\tupper\terror\n";

struct Line {
    long number;
    std::string given;    ///< its first column; if that is not clear, all of it
    std::string fault{};  ///< empty: none
};

struct Answered {
    Line line;
    ListAnswer answer;
};

std::string_view trimmed(std::string_view text, std::string_view blanks) {
    const std::size_t begin = text.find_first_not_of(blanks);
    return begin == std::string_view::npos ? ""
                                           : text.substr(begin, text.find_last_not_of(blanks) + 1 - begin);
}

/// A line of CSV as RFC 4180 has it: in quotes nothing separates, and no comment begins.
struct Columns {
    explicit Columns(std::string_view line);

    std::string_view all;          ///< but for a comment
    std::string_view first;        ///< with its quotes
    std::string separators;        ///< in their order
    bool has_open_quotes = false;  ///< they would go on in the next line
};

Columns::Columns(std::string_view line) : first(line) {
    bool is_begin = true;  // of a column
    std::size_t i = 0;
    for (; i < line.size() && (has_open_quotes || line[i] != '#'); ++i) {
        const bool separates = !has_open_quotes && std::string_view(",;\t").find(line[i]) < 3;
        if (separates) {
            first = separators.empty() ? line.substr(0, i) : first;
            separators += line[i];
        }
        // Two quotes in quotes are one of the text: they end, and begin again.
        if (line[i] == '"' && (has_open_quotes || is_begin || line[i - 1] == '"')) {
            has_open_quotes = !has_open_quotes;
        }
        is_begin = separates || (is_begin && line[i] == ' ');
    }
    all = trimmed(line.substr(0, i), " ");
    first = trimmed(first.substr(0, i), " ");
}

/// Without the quotes around it. Of quotes elsewhere no number is made.
std::string unquoted(std::string_view column) {
    const bool is_quoted = column.size() > 1 && column[0] == '"' && column.find('"', 1) == column.size() - 1;
    return std::string(is_quoted ? trimmed(column.substr(1, column.size() - 2), " ") : column);
}

/// Why the first column of a line is not clear; empty: it is. What other countries and spreadsheets write,
/// 4,6 or 1,000, is no column 4 or 1: between digits a comma separates only where the heading has as many.
std::string unclear(const Columns& columns, const std::string& of_heading) {
    if (columns.has_open_quotes) {
        return "a column in quotes does not end in its line";
    }
    if (!columns.separators.starts_with(',') || columns.first.starts_with('"')) {
        return "";
    }
    if (columns.separators.find_first_of(";\t") != std::string::npos) {
        return "a comma before ; or a tab: write a number with a point, 4.6, and without separators, 1000";
    }
    const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
    const std::size_t comma = columns.all.find(',');
    const bool is_between_digits = comma > 0 && comma + 1 < columns.all.size() &&
                                   is_digit(columns.all[comma - 1]) && is_digit(columns.all[comma + 1]);
    return is_between_digits && columns.separators != of_heading
               ? "one number or two columns? Write a number as 4.6 or 1000, or put the column in double "
                 "quotes"
               : "";
}

/// The first digits, not rounded.
std::string decimal(const Rational& q) {
    constexpr int digits = 17;
    return to_text(without_zeros(cut_down(q, digits)));
}

/// As a field between tabs, which no reader of tables takes for a quoted one.
std::string field(const std::string& text) { return respelled(one_line(text), {{'"', "'"}}); }

std::string table_rows(const Answered& done) {
    const std::string begin = fmt::format("{}\t{}\t", done.line.number, field(done.line.given));
    if (!done.line.fault.empty()) {
        return fmt::format("{}\t\t\t\t\t\t{}\n", begin, field(done.line.fault));
    }
    std::string text;
    for (const ListRow& row : done.answer.rows) {
        text += fmt::format("{}{}\t{}\t{}\t{}\t{}\t{}\t\n", begin, to_fraction(row.q_lo), decimal(row.q_lo),
                            to_fraction(row.q_hi), decimal(row.q_hi), row.lower.str(),
                            row.upper ? row.upper->str() : "");
    }
    return text;
}

std::string json_line(const Answered& done) {
    Json json = done.line.fault.empty() ? done.answer.json : Json::object({{"schema", "dumbbell-list-1"}});
    json.add("line", done.line.number);
    json.add("given", done.line.given);
    if (!done.line.fault.empty()) {
        json.add("error", done.line.fault);
    }
    return json.text() + '\n';
}

void print_at_once(const std::string& text) {
    if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size() || std::fflush(stdout) != 0) {
        throw InputError(not_printed);
    }
}

/// Lines of which the user is told at the end.
struct Tally {
    long number = 0;
    std::string first{};  ///< `line 3`, and what is wrong with it

    void add(const std::string& line) { first = number++ == 0 ? line : first; }
};

class ListRun {
  public:
    ListRun(const Given& given, const AnswerLine& answer, const std::string& claims_of)
        : given_(given),
          answer_(answer),
          lines_(given.text("--list")),
          folder_(given.text("--out"), claims_of),
          progress_("lines", ::isatty(STDOUT_FILENO) == 1 ? Verbosity::quiet : Verbosity::normal,
                    "answering") {}

    int run();

  private:
    std::optional<Line> next_line(const Interrupted& in_vain);
    [[nodiscard]] Answered answered(Line line) const;
    bool hand_on(const Answered& done);
    Work next(const Interrupted& in_vain);

    const Given& given_;
    const AnswerLine& answer_;
    IncomingLines lines_;
    CertificateFolder folder_;
    Progress progress_;
    bool begun_ = false;   ///< a line with content has come
    std::string heading_;  ///< its separators, if that was one
    std::atomic<bool> cut_ = false;
    long printed_ = 0, last_ = 0;  ///< lines, and the number of the last
    Tally bad_{}, undecided_{};
};

std::optional<Line> ListRun::next_line(const Interrupted& in_vain) {
    while (const auto line = lines_.next([&] { return stop_signal != 0 || in_vain(); })) {
        const Columns columns(*line);
        if (columns.all.empty()) {
            continue;
        }
        std::string fault = unclear(columns, heading_);
        std::string column = fault.empty() ? unquoted(columns.first) : std::string(columns.all);
        const bool is_heading = !begun_ && fault.empty() && !column.empty() &&
                                column.find_first_of("0123456789") == std::string::npos;
        begun_ = true;
        if (!is_heading) {
            return Line{lines_.number(), std::move(column), std::move(fault)};
        }
        heading_ = columns.separators;
    }
    return std::nullopt;
}

Answered ListRun::answered(Line line) const {
    Answered done{std::move(line), {}};
    try {
        if (done.line.fault.empty()) {
            done.answer = answer_(done.line.given, folder_.file(done.line.number));
        }
    } catch (const InputError& error) {
        done.line.fault = error.what();
    }
    return done;
}

bool ListRun::hand_on(const Answered& done) {
    if (stop_signal != 0) {  // it may have ended the work on this line
        cut_ = true;
        return false;
    }
    const std::string line = fmt::format("line {}", done.line.number);
    if (!done.line.fault.empty()) {
        bad_.add(fmt::format("{}: {}", line, done.line.fault));
        if (given_.has("--strict")) {
            throw InputError(fmt::format("'{}', {}", lines_.path(), bad_.first));
        }
    } else if (!done.answer.is_decided) {
        undecided_.add(line);
    }
    if (!done.answer.certificate.empty()) {
        folder_.keep(done.line.number, done.answer.certificate, done.answer.claim);
    }
    const bool json = given_.has("--json");
    print_at_once(json ? json_line(done) : (printed_ == 0 ? heading : "") + table_rows(done));
    ++printed_;
    last_ = done.line.number;
    progress_.advance(1);
    return true;
}

Work ListRun::next(const Interrupted& in_vain) {
    auto line = next_line(in_vain);
    if (!line) {
        cut_ = cut_ || stop_signal != 0;
        return {};
    }
    return [this, line = std::move(*line)]() -> HandOn {
        return [this, done = answered(line)] { return hand_on(done); };
    };
}

int ListRun::run() {
    in_order(jobs_of(given_), [this](const Interrupted& in_vain) { return next(in_vain); });
    folder_.finish(!cut_ && printed_ > 0 && bad_.number == 0 && undecided_.number == 0);
    if (cut_) {
        return stopped(printed_ == 0 ? "nothing is printed"
                                     : fmt::format("what is printed is about the lines up to {}", last_));
    }
    if (printed_ == 0) {
        throw InputError(
            fmt::format("'{}' has no mass ratio: write one, or a range LO:HI, a line", lines_.path()));
    }
    if (undecided_.number > 0) {
        complain(fmt::format("not decided: {} of {}; the first is {}", undecided_.number,
                             plural(printed_, "line"), undecided_.first));
    }
    if (bad_.number > 0) {
        complain(
            fmt::format("bad: {} of {}; the first is {}", bad_.number, plural(printed_, "line"), bad_.first));
    }
    return bad_.number > 0 ? exit_bad_input : undecided_.number > 0 ? exit_not_certified : exit_done;
}

}  // namespace

int answer_list(const Given& given, const AnswerLine& answer, const std::string& claims_of) {
    return ListRun(given, answer, claims_of).run();
}

void require_certificate_name(const Given& given) {
    if (given.has("--out")) {
        require_name_of(given.text("--out"), Content::certificate);
    }
}

RatioArgument given_ratio(const Given& given) {
    if (!given.has("RATIO")) {
        throw InputError("RATIO is required, or --list FILE");
    }
    require_certificate_name(given);
    return parse_ratio_argument(given.text("RATIO"));
}

}  // namespace dumbbell::cli
