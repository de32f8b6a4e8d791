#include <fcntl.h>
#include <sys/ioctl.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <regex>

#include "catch.hpp"
#include "programs.hpp"

using namespace dumbbell_test;

namespace {

// On a fast machine, too: much more than any test waits for.
const Words long_range{DUMBBELL_BIN, "certify", "1:10000000", "--gap", "1e-9", "--jobs", "1"};

// What a job writes to a terminal of this width (columns) as its stderr, up to the text awaited, for five
// minutes at most; then it is killed.
std::string seen_on_terminal(const Words& job, const std::string& awaited, std::size_t columns = 100) {
    const int terminal = ::posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC);
    const winsize size{24, static_cast<unsigned short>(columns), 0, 0};
    if (terminal < 0 || ::grantpt(terminal) != 0 || ::unlockpt(terminal) != 0) {
        return "";
    }
    const std::string name = ::ptsname(terminal);
    const int other_end =
        ::open(name.c_str(), O_RDWR | O_NOCTTY | O_CLOEXEC);  // or reading fails after the job
    ::ioctl(other_end, TIOCSWINSZ, &size);
    std::string command = "TERM=xterm; export TERM; exec 2>" + name + " >/dev/null; exec";
    for (const std::string& word : job) {
        command += " " + word;
    }
    std::string text;
    {
        const Process process({"sh", "-c", command});
        pollfd ready{terminal, POLLIN, 0};
        std::array<char, 4096> buffer{};
        const auto end = std::chrono::steady_clock::now() + std::chrono::minutes(5);
        while (text.find(awaited) == std::string::npos && std::chrono::steady_clock::now() < end) {
            if (::poll(&ready, 1, 100) == 0) {
                if (process.ended()) {
                    break;
                }
                continue;
            }
            const ssize_t n = ::read(terminal, buffer.data(), buffer.size());
            if (n <= 0) {
                break;
            }
            text.append(buffer.data(), static_cast<std::size_t>(n));
        }
    }
    ::close(other_end);
    ::close(terminal);
    return text;
}

// The longest of the lines that were shown in the place of one another.
std::size_t widest(const std::string& text) {
    std::size_t most = 0;
    for (std::size_t from = 0; from < text.size();) {
        const std::size_t end = std::min(text.find('\r', from), text.size());
        const std::string line = text.substr(from, end - from);
        most = std::max(most, std::min(line.find('\033'), line.size()));
        from = end + 1;
    }
    return most;
}

}  // namespace

TEST_CASE(
    "on a terminal a job of more than a second shows a bar, the time left, the rate and the present N") {
    const std::string text = seen_on_terminal(long_range, "N = ");
    CAPTURE(text);
    CHECK(std::regex_search(
        text, std::regex(R"(\[#*\.*\] \d+/\d+ pieces, about \S+ (s|min|h) left, [0-9.]+/s, N = )")));
}

TEST_CASE("the phases of a long job are named, and what counts nothing says for how long it has been at it",
          "[wings]") {
    const std::string range = seen_on_terminal(long_range, "proving: ");
    CAPTURE(range);
    CHECK(range.find("proving: ") != std::string::npos);
    const std::string steps = seen_on_terminal(
        {DUMBBELL_BIN, "certify", "1:1e12", "--gap", "1e-300", "--jobs", "1"}, "steps, about ");
    CAPTURE(steps);
    CHECK(std::regex_search(steps, std::regex(R"(looking for steps: \[#*\.*\] \d+/\d+ steps, about )")));
    const TemporaryFolder folder;
    const std::string stairs = std::string(DUMBBELL_PROJECT) + "/certificates/stairs-1-100.dbc";
    // A copy with a verifier beside it that is slow on every machine.
    const std::string copy = folder / "dumbbell", slow = folder / "dumbbell-verify";
    std::filesystem::copy_file(DUMBBELL_BIN, copy);
    write_file(slow, "#!/bin/sh\nexec sleep 5\n");
    std::filesystem::permissions(slow, std::filesystem::perms::owner_all);
    for (const auto& [job, phase] : std::vector<std::pair<Words, std::string>>{
             {{copy, "plot", "staircase", stairs, "--out", folder / "x.svg"}, "verifying, "},
             {{DUMBBELL_BIN, "trace", "1e8", "--phi", "1/3", "--phidot", "100", "--y", "3", "--ydot",
               "-1/200", "--digits", "10000"},
              "following the orbit: "},
             {{DUMBBELL_BIN, "adiabatic", "--delta", "0:0.01", "--phi-margin", "0.3,0.2,0.1,0.25,0.15",
               "--jobs", "1"},
              "looking for an orbit with a great error, "}}) {
        const std::string text = seen_on_terminal(job, phase);
        CAPTURE(job, text);
        CHECK(text.find(phase) != std::string::npos);
    }
}

TEST_CASE("a line appears by time, also while the first box, or the first piece of a range, takes long") {
    for (const auto& [ratio, shown] : std::vector<std::pair<std::string, std::string>>{
             {"1e14", R"(proving: \d+ boxes in \d s)"}, {"2e10:20000000001", R"(proving, \d s)"}}) {
        const std::string awaited = shown.substr(0, shown.find('\\'));
        const std::string text = seen_on_terminal(
            {DUMBBELL_BIN, "certify", ratio, "--section", "full", "--jobs", "1", "--budget", "10s"}, awaited);
        CAPTURE(ratio, text);
        CHECK(std::regex_search(text, std::regex(shown)));  // long before the budget is used up
    }
}

TEST_CASE("that a file is read is a phase of its own, in every command that reads one", "[wings]") {
    const TemporaryFolder folder;
    const std::string pipe = folder / "pipe", out = folder / "out";
    REQUIRE(::mkfifo(pipe.c_str(), 0600) == 0);
    const int writer = ::open(pipe.c_str(), O_RDWR | O_CLOEXEC);  // so that nobody's reading ends by itself
    for (const Words& words : std::vector<Words>{{"audit", "-"},
                                                 {"plot", "staircase", "-", "--out", out + ".svg"},
                                                 {"report", "-", "--out", out + ".html"}}) {
        Words job = with_program(words);
        job.insert(job.end(), {"<", pipe});
        const std::string text = seen_on_terminal(job, "reading");
        CAPTURE(words, text);
        CHECK(std::regex_search(text, std::regex(R"(reading, \d+ (s|min|h))")));
    }
    ::close(writer);
}

TEST_CASE("a terminal that is dumb, or of no known kind, gets no progress: it needs escape codes") {
    for (const Words& kind : {Words{"TERM=dumb"}, Words{"-u", "TERM"}}) {
        Words job{"env"};
        job.insert(job.end(), kind.begin(), kind.end());
        job.insert(job.end(), long_range.begin(), long_range.end());
        job.insert(job.end(), {"--budget", "1.3s"});
        const std::string text = seen_on_terminal(job, "\n");
        CAPTURE(text);
        CHECK(text.find('\033') == std::string::npos);
        CHECK(text.find("not everything was decided") != std::string::npos);
    }
}

TEST_CASE("the progress line is never as wide as the terminal: the bar shrinks, then the end is cut off") {
    for (const std::size_t columns : {60U, 30U, 10U}) {
        const std::string text = seen_on_terminal(long_range, "\033", columns);
        CAPTURE(text, columns);
        CHECK(text.find("/") != std::string::npos);
        CHECK(widest(text) < columns);
        CHECK(std::regex_search(text, std::regex(R"(\[[#.])")) == (columns == 60));
    }
}

TEST_CASE("with --quiet there is no progress on a terminal either") {
    Words job = long_range;
    job.insert(job.end(), {"--budget", "1.3s", "--quiet"});
    const std::string text = seen_on_terminal(job, "\n");
    CAPTURE(text);
    CHECK(text.find("pieces,") == std::string::npos);
    CHECK(text.find("not everything was decided") != std::string::npos);
}

TEST_CASE("the name before an error is red on a terminal, unless NO_COLOR or TERM say otherwise") {
    const auto error = [](const std::string& environment) {
        return seen_on_terminal(
            {"env", "-u", "NO_COLOR", "TERM=xterm", environment, DUMBBELL_BIN, "certify", "ten"}, "\n");
    };
    CHECK(error("TERM=xterm").starts_with("\033[31mdumbbell:\033[0m "));
    CHECK(error("TERM=dumb").starts_with("dumbbell: "));
    CHECK(error("TERM=").starts_with("dumbbell: "));
    CHECK(error("NO_COLOR=1").starts_with("dumbbell: "));
    CHECK(error("NO_COLOR=").starts_with("\033[31m"));
    CHECK(dumbbell({"certify", "ten"}).err.starts_with("dumbbell: "));
}

TEST_CASE("on a terminal a single ratio that takes long shows how many boxes were judged") {
    const std::string text =
        seen_on_terminal({DUMBBELL_BIN, "certify", "100", "--section", "plain", "--jobs", "1"}, "/s");
    CAPTURE(text);
    CHECK(std::regex_search(text, std::regex(R"(\d+ boxes in \d+ s, [0-9.]+/s)")));
}

TEST_CASE("on a terminal a single critical ratio that takes long shows how many flights were enclosed") {
    const std::string text =
        seen_on_terminal({DUMBBELL_BIN, "critical", "20000", "--digits", "1000"}, " flights in ");
    CAPTURE(text);
    CHECK(text.find(" flights in ") != std::string::npos);
}
