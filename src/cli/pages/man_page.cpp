#include <fmt/core.h>

#include "base/printable.hpp"
#include "cli/pages/command_table.hpp"
#include "cli/pages/pages.hpp"

namespace dumbbell::cli::pages {
namespace {

/// Text as groff prints it unchanged: a minus is one that can be copied, and no line is taken for a request.
std::string groff(std::string_view text) {
    const bool is_request = text.starts_with('.') || text.starts_with('\'');
    return (is_request ? "\\&" : "") + respelled(text, {{'\\', "\\e"},
                                                        {'-', "\\-"},
                                                        {'^', "\\(ha"},
                                                        {'~', "\\(ti"},
                                                        {'`', "\\(ga"},
                                                        {'\'', "\\(aq"}});
}

std::string bold(std::string_view text) { return "\\fB" + groff(text) + "\\fR"; }

void add_groff(std::string& page, std::string_view text) {
    for (const Block& block : blocks(text)) {
        page += block.verbatim ? ".PP\n.RS 2\n.nf\n" : ".PP\n";
        for (const std::string& line : block.lines) {
            page += groff(line) + "\n";
        }
        page += block.verbatim ? ".fi\n.RE\n" : "";
    }
}

void add_groff_options(std::string& page, std::span<const Option> options) {
    for (const Option& option : options) {
        page += fmt::format(".TP\n{}\n{}\n", bold(spelling(option)), groff(meaning(option)));
    }
}

void add_groff_command(std::string& page, const Place& place) {
    for (const Section& section : sections(place)) {
        page += ".SS " + groff(section.heading) + "\n";
        add_groff(page, section.text);
        add_groff_options(page, section.options);
        add_groff(page, section.footer);
    }
}

}  // namespace

std::string man_page(const Command& program) {
    const auto all = places(program);
    std::string page = fmt::format(
        ".\\\" Generated from the option table: dumbbell generate man\n"
        ".TH DUMBBELL 1 \"\" \"dumbbell {}\" \"User Commands\"\n"
        ".SH NAME\ndumbbell \\- prove how often a bouncing dumbbell can hit the floor\n"
        ".SH SYNOPSIS\n.nf\n",
        DUMBBELL_VERSION);
    for (const Place& place : all) {
        page += is_called(*place.command) ? bold(usage(place)) + "\n" : "";
    }
    page += ".fi\n.SH DESCRIPTION\n";
    add_groff(page, description(program));
    page += ".SH OPTIONS\n";
    add_groff_options(page, std::array{help_option});
    add_groff_options(page, program.options);
    page += ".SH COMMANDS\nEach has a \\fB\\-\\-help\\fR of its own.\n";
    for (const Place& place : std::span(all).subspan(1)) {
        add_groff_command(page, place);
    }
    page += ".SH EXIT STATUS\n";
    add_groff(page, program.footer);
    page +=
        ".SH ENVIRONMENT\n.TP\n\\fBNO_COLOR\\fR\nIf set and not empty, nothing is coloured. What does not go "
        "to "
        "a terminal never is.\n"
        ".SH SEE ALSO\n\\fBdumbbell\\-verify\\fR(1)\n";
    return page;
}

}  // namespace dumbbell::cli::pages
