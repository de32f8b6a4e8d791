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

TEST_CASE("both programs wait for a standard input that says it has nothing yet") {
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
