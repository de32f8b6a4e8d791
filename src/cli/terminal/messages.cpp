#include "cli/terminal/messages.hpp"

#include <fmt/core.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <string_view>

#include "base/printable.hpp"
#include "cli/terminal/standard_input.hpp"

namespace dumbbell::cli {
namespace {

std::string_view environment(const char* name) {
    const char* value = std::getenv(name);
    return value == nullptr ? "" : value;
}

bool is_coloured() { return stderr_is_terminal() && environment("NO_COLOR").empty(); }

}  // namespace

// Not fmt::print, which throws where it cannot write: in a handler of exceptions that would be the end.
void say(const std::string& text) { (void)std::fwrite(text.data(), 1, text.size(), stderr); }

void complain(const std::string& text) {
    say(fmt::format("{} {}\n",
                    is_coloured() ? "\033[31mdumbbell:\033[0m" : "dumbbell:", one_line(as_named(text))));
}

bool stderr_is_terminal() {
    return ::isatty(STDERR_FILENO) == 1 && !environment("TERM").empty() && environment("TERM") != "dumb";
}

bool is_printed() { return std::cout.flush() && std::fflush(stdout) == 0 && std::ferror(stdout) == 0; }

void remark(const std::string& text) { say(fmt::format("dumbbell: {}\n", one_line(text))); }

}  // namespace dumbbell::cli
