// dumbbell-verify as a WebAssembly module: what the page, and the tests under node, call. The file that it
// reads is the standard input, the function fd_read of module.js.
#include "system.hpp"
#include "verify/machine/environment.hpp"
#include "verify/machine/meter.hpp"
#include "verify/program/claim_options.hpp"
#include "verify/program/escape.hpp"
#include "verify/program/json.hpp"
#include "verify/program/sentence.hpp"
#include "verify/program/summary.hpp"

namespace dumbbell_verify {
namespace {

/// Of the page: how much was done so far, in seconds of a core, and how many pieces of all that there are.
extern "C" __attribute__((import_module("page"), import_name("progress"))) void show_progress(double seconds,
                                                                                              double read,
                                                                                              double pieces);
void progress() {
    show_progress(static_cast<double>(Watched::work) / units_per_second, static_cast<double>(Watched::read),
                  static_cast<double>(Watched::pieces));
}

/// The options that state a claim, and those for what it may cost, as of the program.
Request settings_of(std::vector<std::string> words) {
    Request settings;
    Arguments given(std::move(words));
    ClaimWords claim;
    while (given.next()) {
        if (claim_option(given, claim)) continue;
        given.once();
        if (given.option == "--budget")
            settings.budget = given.time();
        else if (given.option == "--precision")
            settings.precision = static_cast<unsigned>(given.number(53, 4096));
        else if (given.option == "--max-bits")
            settings.max_bits = static_cast<unsigned>(given.number(53, 4096));
        else
            throw std::invalid_argument("unknown option " + given.word.substr(0, 60));
    }
    state_claim(claim, settings);
    return settings;
}

std::string answer_to(std::vector<std::string> words) try {
    const Job job{"/dev/stdin", settings_of(std::move(words))};
    const Result result = examine(job);
    return R"({"line":)" + json_string(verdict_line(result)) + R"(,"sentence":)" +
           json_string(result.is_right() ? sentence(result) : "") + R"(,"result":)" + json(result) + "}";
} catch (const std::invalid_argument& error) {
    return R"({"usage":)" + json_string(error.what()) + "}";
}

}  // namespace
}  // namespace dumbbell_verify

extern "C" {
/// Verifies the file, once; the room has the options.
__attribute__((export_name("verify"))) const char* verify() {
    const dumbbell_verify::DefaultEnvironment environment;
    dumbbell_verify::Shares::watch = dumbbell_verify::progress;
    return answered([] { return dumbbell_verify::answer_to(words_given()); });
}
}
