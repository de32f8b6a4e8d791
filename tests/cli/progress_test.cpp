#include <fcntl.h>

#include <catch2/catch.hpp>
#include <cstdlib>

#include "programs.hpp"

using namespace dumbbell_test;

namespace {

const Words two_seconds{DUMBBELL_BIN, "certify", "1:200000", "--gap", "1e-9", "--jobs", "1"};

// What a long job writes to a terminal as its stderr, up to the first progress bar; then it is killed.
std::string seen_on_terminal() {
    const int terminal = ::posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC);
    if (terminal < 0 || ::grantpt(terminal) != 0 || ::unlockpt(terminal) != 0) {
        return "";
    }
    const std::string name = ::ptsname(terminal);
    std::string command = "exec 2>" + name + " >/dev/null; exec";
    for (const std::string& word : two_seconds) {
        command += " " + word;
    }
    command.replace(command.find("1:200000"), 8, "1:1000000");
    std::string text;
    {
        const Process process({"sh", "-c", command});
        pollfd ready{terminal, POLLIN, 0};
        std::array<char, 4096> buffer{};
        while (text.find(']') == std::string::npos && ::poll(&ready, 1, 30'000) > 0) {
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
    const std::string text = seen_on_terminal();
    CAPTURE(text);
    CHECK(text.find("pieces, about") != std::string::npos);
    CHECK(text.find('[') != std::string::npos);
}
