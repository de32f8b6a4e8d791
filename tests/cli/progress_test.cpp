#include <fcntl.h>

#include <catch2/catch.hpp>
#include <cstdlib>

#include "programs.hpp"

using namespace dumbbell_test;

namespace {

const Words two_seconds{DUMBBELL_BIN, "certify", "1:200000", "--gap", "1e-9", "--jobs", "1"};

// What a long job writes to a terminal as its stderr, up to the text awaited; then it is killed.
std::string seen_on_terminal(const Words& job, const std::string& awaited) {
    const int terminal = ::posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC);
    if (terminal < 0 || ::grantpt(terminal) != 0 || ::unlockpt(terminal) != 0) {
        return "";
    }
    const std::string name = ::ptsname(terminal);
    std::string command = "exec 2>" + name + " >/dev/null; exec";
    for (const std::string& word : job) {
        command += " " + word;
    }
    std::string text;
    {
        const Process process({"sh", "-c", command});
        pollfd ready{terminal, POLLIN, 0};
        std::array<char, 4096> buffer{};
        while (text.find(awaited) == std::string::npos && ::poll(&ready, 1, 30'000) > 0) {
            const ssize_t n = ::read(terminal, buffer.data(), buffer.size());
            if (n <= 0) {
                break;
            }
            text.append(buffer.data(), static_cast<std::size_t>(n));
        }
    }
    ::close(terminal);
    return text;
}

}  // namespace

TEST_CASE("in a pipe a long job shows no progress") {
    const Outcome result = run(two_seconds);
    CHECK(result.code == 0);
    CHECK(result.err.empty());
    CHECK(result.out.find('\r') == std::string::npos);
}

TEST_CASE("on a terminal a job of more than a second shows a bar") {
    const std::string text =
        seen_on_terminal({DUMBBELL_BIN, "certify", "1:1000000", "--gap", "1e-9", "--jobs", "1"}, "]");
    CAPTURE(text);
    CHECK(text.find("pieces, about") != std::string::npos);
    CHECK(text.find('[') != std::string::npos);
}

TEST_CASE("on a terminal a single ratio that takes long shows how many boxes were judged") {
    const std::string text = seen_on_terminal(
        {DUMBBELL_BIN, "certify", "100", "--section", "full", "--lemmas", "none", "--jobs", "1"},
        " boxes in ");
    CAPTURE(text);
    CHECK(text.find(" boxes in ") != std::string::npos);
}

TEST_CASE("on a terminal a single critical ratio that takes long shows how many flights were enclosed") {
    const std::string text = seen_on_terminal({DUMBBELL_BIN, "critical", "100000"}, " flights in ");
    CAPTURE(text);
    CHECK(text.find(" flights in ") != std::string::npos);
}
