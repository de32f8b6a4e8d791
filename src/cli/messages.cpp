#include "cli/messages.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <string_view>

namespace dumbbell {
namespace {

std::string_view environment(const char* name) {
    const char* value = std::getenv(name);
    return value == nullptr ? "" : value;
}

bool is_coloured() {
    return ::isatty(STDERR_FILENO) == 1 && environment("NO_COLOR").empty() && environment("TERM") != "dumb";
}

}  // namespace

// Not fmt::print, which throws where it cannot write: in a handler of exceptions that would be the end.
void say(const std::string& text) { (void)std::fwrite(text.data(), 1, text.size(), stderr); }

void complain(const std::string& text) {
    say(fmt::format("{} {}\n", is_coloured() ? "\033[31mdumbbell:\033[0m" : "dumbbell:", text));
}

void remark(const std::string& text) { say(fmt::format("dumbbell: {}\n", text)); }

}  // namespace dumbbell
