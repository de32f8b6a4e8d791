#include "cli/list/list.hpp"

#include <fmt/core.h>
#include <unistd.h>

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
    std::string given;    ///< without a comment
    std::string fault{};  ///< empty: none
};

struct Answered {
    Line line;
    ListAnswer answer;
};

/// Without a comment.
std::string content_of(std::string_view line) {
    line = line.substr(0, line.find('#'));
    const std::size_t begin = line.find_first_not_of(" \t");
    return begin == std::string_view::npos
               ? ""
               : std::string(line.substr(begin, line.find_last_not_of(" \t") + 1 - begin));
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
    std::atomic<bool> cut_ = false;
    long printed_ = 0, last_ = 0;  ///< lines, and the number of the last
    Tally bad_{}, undecided_{};
};

std::optional<Line> ListRun::next_line(const Interrupted& in_vain) {
    while (const auto line = lines_.next([&] { return stop_signal != 0 || in_vain(); })) {
        if (std::string content = content_of(*line); !content.empty()) {
            return Line{lines_.number(), std::move(content)};
        }
    }
    return std::nullopt;
}

Answered ListRun::answered(Line line) const {
    Answered done{std::move(line), {}};
    try {
        done.answer = answer_(done.line.given, folder_.file(done.line.number));
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

}  // namespace dumbbell::cli
