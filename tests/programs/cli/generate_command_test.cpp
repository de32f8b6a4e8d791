// The man pages, the completion and the reference: all options are there, and the tools that read them agree.
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

// What bash would offer for the last of the words.
Words offered(const Words& words, const std::string& folder = ".") {
    const std::string bin = std::filesystem::path(DUMBBELL_BIN).parent_path().string();
    std::string script =
        "PATH=" + bin + ":$PATH; source <(" DUMBBELL_BIN " generate completion); COMP_WORDS=(";
    for (const std::string& word : words) {
        script += "'" + word + "' ";
    }
    script += ");  COMP_CWORD=" + std::to_string(words.size() - 1) +
              "; _dumbbell; ((${#COMPREPLY[@]} == 0)) || printf '%s\\n' \"${COMPREPLY[@]}\"";
    const Outcome result = run({"bash", "-c", script}, folder);
    CHECK(result.code == 0);
    CHECK(result.err.empty());
    return lines_of(result.out);
}

}  // namespace

TEST_CASE("docs/reference/commands.md is what the program generates", "[wings]") {
    CHECK(contents(DUMBBELL_PROJECT "/docs/reference/commands.md") == generated("reference"));
}

TEST_CASE("every option of every command is in the man page and the completion") {
    const std::string man = without_backslashes(generated("man")), completion = generated("completion");
    for (const ListedCommand& command : listed_commands()) {
        CAPTURE(command.words);
        for (const ListedOption& option : command.options) {
            CAPTURE(option.spelling);
            CHECK_THAT(man, Contains(".TP\nfB" + option.spelling + "fR\n"));
            for (const std::string& name : option.names()) {
                CHECK_THAT(completion, Contains(name));
            }
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

TEST_CASE("bash completes commands, and hides the one that is for packagers", "[wings]") {
    CHECK(offered({"dumbbell", "cert"}) == Words{"certify"});
    CHECK(offered({"dumbbell", "plot", "sta"}) == Words{"staircase"});
    CHECK(offered({"dumbbell", "gen"}).empty());
    const auto all = offered({"dumbbell", ""});
    CHECK(std::find(all.begin(), all.end(), "verify") != all.end());
}

TEST_CASE("bash completes options, and the words that an option takes", "[wings]") {
    CHECK(offered({"dumbbell", "certify", "10", "--sec"}) == Words{"--section"});
    CHECK(offered({"dumbbell", "certify", "10", "--section", ""}) == Words{"turning", "full", "plain"});
    CHECK(offered({"dumbbell", "certify", "--section", "=", "f"}) == Words{"full"});
    CHECK(offered({"dumbbell", "certify", "--jobs", ""}).empty());
    CHECK(offered({"dumbbell", "certify", "--help", ""}) == Words{"bodies", "lists"});
    CHECK(offered({"dumbbell", "adiabatic", "--theorem", "thm"}) == Words{"thm3.3", "thm3.5"});
}

TEST_CASE("bash completes file names where a file is wanted", "[wings]") {
    const TemporaryFolder folder;
    write_file(folder / "ten.dbc", "");
    write_file(folder / "my stairs.dbc", "");
    CHECK(offered({"dumbbell", "audit", "te"}, folder.path()) == Words{"ten.dbc"});
    CHECK(offered({"dumbbell", "audit", "my"}, folder.path()) == Words{"my stairs.dbc"});
    CHECK(offered({"dumbbell", "certify", "10", "--out", "te"}, folder.path()) == Words{"ten.dbc"});
    CHECK(offered({"dumbbell", "certify", "te"}, folder.path()).empty());
}

TEST_CASE("bash completes the verifier, by either of its names") {
    const TemporaryFolder folder;
    write_file(folder / "ten.dbc", "");
    for (const Words& name : {Words{"dumbbell", "verify"}, Words{"dumbbell-verify"}}) {
        const auto with = [&](const Words& more) {
            Words words = name;
            words.insert(words.end(), more.begin(), more.end());
            return offered(words, folder.path());
        };
        CHECK(with({"te"}) == Words{"ten.dbc"});
        CHECK(with({"--exa"}) == Words{"--exactly"});
        CHECK(with({"--hel"}) == Words{"--help"});
        CHECK(with({"--claims", "t"}) == Words{"ten.dbc"});
    }
}

TEST_CASE("generate refuses what it does not know") {
    CHECK(dumbbell({"generate", "pdf"}).code == 2);
    CHECK(dumbbell({"generate"}).code == 2);
}
