#include "catch.hpp"
#include "reference.hpp"

using namespace dumbbell_test;

namespace {

Outcome help_of(Words command, const Words& topic = {}) {
    command.emplace_back("--help");
    command.insert(command.end(), topic.begin(), topic.end());
    return dumbbell(command);
}

long occurrences(const std::string& text, const std::string& words) {
    long n = 0;
    for (std::size_t at = text.find(words); at != std::string::npos; at = text.find(words, at + 1)) {
        ++n;
    }
    return n;
}

}  // namespace

TEST_CASE("the option --help explains the commands with examples and exit codes, on stdout, and exits 0") {
    for (const char* option : {"--help", "-h"}) {
        const Outcome help = dumbbell({option});
        CHECK(help.code == 0);
        CHECK(help.err.empty());
        CHECK_THAT(help.out, Contains("Examples:") && Contains("dumbbell certify 10") &&
                                 Contains("dumbbell verify") && Contains("Exit codes: 0"));
    }
}

TEST_CASE("every command has a help, of topics too, that says of each option what the reference says",
          "[wings]") {
    const auto commands = listed_commands();
    CHECK(commands.size() > 14);
    for (const ListedCommand& command : commands) {
        std::vector<Outcome> helps{help_of(command.words)};
        for (const std::string& topic : command.topics) {
            helps.push_back(help_of(command.words, {topic}));
        }
        std::string all;
        for (const Outcome& help : helps) {
            CAPTURE(command.words, help.out);
            CHECK(help.code == 0);
            CHECK(help.err.empty());
            CHECK(occurrences(help.out, "Exit code") == 1);
            CHECK(std::ranges::max(lines_of(help.out), {}, &std::string::size).size() <= 120);
            all += help.out;
        }
        for (const ListedOption& option : command.options) {
            const bool is_named_only =
                command.words.empty() || (command.words[0] == "verify" && option.is_argument());
            if (!is_named_only) {
                CHECK_THAT(in_one_line(all), Contains(option.spelling + " " + option.meaning));
            }
        }
    }
}

TEST_CASE("the help of certify fits one screen, and bodies and lists have a help of their own", "[wings]") {
    const std::string help = help_of({"certify"}).out, bodies = help_of({"certify"}, {"bodies"}).out;
    CHECK(count_lines(help) <= 45);
    CHECK(occurrences(help, "not with") == 0);
    CHECK_THAT(help, Contains("\nMore: dumbbell certify --help bodies | lists\n") && !Contains("--coin"));
    CHECK_THAT(bodies, Contains("certify --coin ") && Contains("--rho RHO ") && !Contains("--list"));
    CHECK(dumbbell({"help", "certify", "bodies"}).out == bodies);
    CHECK_THAT(help_of({"law"}, {"lists"}).out, Contains("dumbbell law --list") && Contains("--strict"));
    CHECK_THAT(refused({"certify", "--help", "coins"}),
               Contains("there is no help about 'coins'; see dumbbell certify --help"));
    CHECK_THAT(refused({"help", "audit", "lists"}), Contains("there is no help about 'lists'"));
}

TEST_CASE("the option --version says which build this is: version, compiler, flags") {
    const Outcome version = dumbbell({"--version"});
    CHECK(version.code == 0);
    CHECK(version.err.empty());
    CHECK(count_lines(version.out) == 1);
    CHECK_THAT(version.out, Contains("dumbbell " DUMBBELL_VERSION) && Contains("flags: ") &&
                                Contains("-ffp-contract=off"));
}

TEST_CASE("the help of a command that only has commands fits one screen, a line for each", "[wings]") {
    const std::vector<std::pair<Words, Words>> parents{
        {{}, {"certify", "critical", "trace", "adiabatic", "verify", "audit", "law", "plot", "report"}},
        {{"plot"}, {"staircase", "orbit", "phase", "body"}}};
    for (const auto& [parent, below] : parents) {
        const std::string help = help_of(parent).out;
        CAPTURE(parent, help);
        CHECK(count_lines(help) <= 30);
        CHECK(std::ranges::max(lines_of(help), {}, &std::string::size).size() <= 100);
        for (const std::string& command : below) {
            CHECK(occurrences(help, "\n  " + command + " ") == 1);
        }
        CHECK_THAT(help, Contains("COMMAND --help") && Contains("Examples:\n  dumbbell ") &&
                             Contains("Exit codes: 0"));
        CHECK(occurrences(help, "generate") == 0);
    }
    CHECK_THAT(help_of({}).out, Contains("\nCommands:\n  certify ") && Contains("\nMore:\n  trace "));
}

TEST_CASE("the usual names of help and version work") {
    CHECK(dumbbell({"help"}).out == dumbbell({"--help"}).out);
    CHECK(dumbbell({"help", "plot", "orbit"}).out == help_of({"plot", "orbit"}).out);
    CHECK(dumbbell({"help", "verify"}).out == help_of({"verify"}).out);
    for (const char* version : {"version", "-V"}) {
        CHECK(dumbbell({version}).out == dumbbell({"--version"}).out);
    }
}
