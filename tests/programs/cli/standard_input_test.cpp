// The standard input where a neighbour has left it without waiting, or signals come in between.

#include "programs.hpp"

using namespace dumbbell_test;

namespace {

const std::string ten = DUMBBELL_PROJECT "/certificates/q-10.dbc";

// A command with a pipe as its standard input, of which each half of the certificate comes late.
Outcome fed_by(const std::string& prepare, const std::string& command) {
    const std::string late = "{ sleep 0.2; head -c 200 " + ten + "; sleep 0.2; tail -c +201 " + ten + "; }";
    const std::string start = "import os, signal, sys; " + prepare + "; os.execv(sys.argv[1], sys.argv[1:])";
    return run({"sh", "-c", late + " | python3 -c '" + start + "' " + command});
}

}  // namespace

TEST_CASE("both programs wait for a standard input that says it has nothing yet", "[wings]") {
    const std::string no_wait = "os.set_blocking(0, False)";
    for (const std::string command : {DUMBBELL_VERIFY_BIN " -", DUMBBELL_VERIFY_BIN " /dev/stdin",
                                      DUMBBELL_BIN " verify -", DUMBBELL_BIN " audit -"}) {
        CAPTURE(command);
        const Outcome result = fed_by(no_wait, command);
        CAPTURE(result.out, result.err);
        CHECK(result.code == 0);
    }
    const Outcome listed = run({"sh", "-c",
                                "{ sleep 0.2; printf '" + ten +
                                    "\\t--ratio 10 --max 4\\n'; } | python3 -c '"
                                    "import os, sys; os.set_blocking(0, False); os.execv(sys.argv[1], "
                                    "sys.argv[1:])' " DUMBBELL_VERIFY_BIN " --claims -"});
    CHECK(listed.code == 0);
}

TEST_CASE("a packed file is one, however few of its bytes a pipe has at first") {
    const std::string packed = DUMBBELL_PROJECT "/certificates/full-100.dbc.gz";
    const Outcome result = run(
        {"sh", "-c", "(printf '\\037'; sleep 0.3; tail -c +2 " + packed + ") | " DUMBBELL_VERIFY_BIN " -"});
    CAPTURE(result.out);
    CHECK(result.code == 0);
}

TEST_CASE("the certificates of a list that is an open file are looked for in the current folder") {
    const TemporaryFolder folder;
    std::filesystem::copy_file(ten, folder / "ten.dbc");
    write_file(folder / "list", "ten.dbc\t--ratio 10 --exactly 4\n");
    for (const std::string& name : Words{"-", "/dev/stdin", "/dev/fd/0", "/proc/self/fd/0"}) {
        CAPTURE(name);
        const std::string command = DUMBBELL_VERIFY_BIN " --claims " + name;
        CHECK(run({"sh", "-c", command + " < list"}, folder.path()).code == 0);
        CHECK(run({"sh", "-c", "cat list | " + command}, folder.path()).code == 0);
    }
    std::filesystem::create_directory(folder / "below");
    std::filesystem::create_symlink("/dev/stdin", folder / "below/link");
    CHECK(run({"sh", "-c", DUMBBELL_VERIFY_BIN " --claims below/link < list"}, folder.path()).code == 0);
}
