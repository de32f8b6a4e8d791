#include <fmt/core.h>

#include "cli/commands.hpp"
#include "cli/options/given.hpp"
#include "cli/pages/pages.hpp"
#include "cli/terminal/exit_code.hpp"

namespace dumbbell::cli {
namespace {

constexpr const char* generate_description =
    "Print what is made from the table of commands and options: man page, or docs/reference/commands.md.";

constexpr std::array generate_options{Option{"WHAT", "man|reference", "man or reference"}.required()};

int run_generate(const Given& given) {
    const std::string what = given.text("WHAT");
    fmt::print("{}", what == "man" ? pages::man_page(dumbbell_command) : pages::reference(dumbbell_command));
    return exit_done;
}

}  // namespace

constinit const Command generate_command{
    "generate",           "",
    generate_description, "Exit codes: 0 done; 1 internal error; 2 wrong usage.",
    generate_options,     run_generate};

}  // namespace dumbbell::cli
