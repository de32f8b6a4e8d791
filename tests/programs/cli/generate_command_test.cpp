// The man page and the reference: all options are there.
#include "catch.hpp"
#include "reference.hpp"

using namespace dumbbell_test;

namespace {

std::string generated(const std::string& what) {
    const Outcome made = dumbbell({"generate", what});
    CHECK(made.code == 0);
    CHECK(made.err.empty());
    return made.out;
}

// A minus is \- in a manual page.
std::string without_backslashes(std::string page) {
    page.erase(std::remove(page.begin(), page.end(), '\\'), page.end());
    return page;
}

}  // namespace

TEST_CASE("docs/reference/commands.md is what the program generates", "[wings]") {
    CHECK(contents(DUMBBELL_PROJECT "/docs/reference/commands.md") == generated("reference"));
}

TEST_CASE("every option of every command is in the man page") {
    const std::string man = without_backslashes(generated("man"));
    for (const ListedCommand& command : listed_commands()) {
        CAPTURE(command.words);
        for (const ListedOption& option : command.options) {
            CAPTURE(option.spelling);
            CHECK_THAT(man, Contains(".TP\nfB" + option.spelling + "fR\n"));
        }
    }
}

TEST_CASE("what is said of the verifier is where its options are, and its own help says it") {
    CHECK(dumbbell({"verify", "--help"}).out == verifier({"--help"}).out);
    const auto commands = listed_commands();
    const auto verify = std::find_if(commands.begin(), commands.end(),
                                     [](const auto& command) { return command.words == Words{"verify"}; });
    REQUIRE(verify != commands.end());
    CHECK(verify->options.size() == 1);
    CHECK_THAT(verify->text, Contains("dumbbell verify --help, or man dumbbell-verify"));
}

TEST_CASE("generate refuses what it does not know") {
    CHECK(dumbbell({"generate", "pdf"}).code == 2);
    CHECK(dumbbell({"generate"}).code == 2);
}
