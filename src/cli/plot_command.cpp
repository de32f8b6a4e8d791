#include "cli/plot_command.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "arith/error.hpp"
#include "certificate/atomic_file.hpp"
#include "certificate/names.hpp"
#include "certificate/reader.hpp"
#include "cli/exit_code.hpp"
#include "cli/verify_command.hpp"
#include "model/paper_bound.hpp"
#include "report/staircase_plot.hpp"

namespace dumbbell {
namespace {

constexpr const char* footer =
    "Exit codes: 0 done; 1 internal error; 2 wrong usage, or a file that is not verified.";

struct Options {
    std::string file;
    std::string out;
};

int plot_staircase(const Options& options) {
    AtomicFile out(options.out);
    const Certificate certificate = read_certificate(options.file);
    if (certificate.q_lo() == certificate.q_hi()) {
        throw InputError("a staircase needs a range of mass ratios: this certificate holds a single one");
    }
    if (certificate.q_hi() > paper_bound_limit()) {
        throw InputError(
            fmt::format("'{}' reaches beyond the mass ratio 3e31: no picture of that", options.file));
    }
    (void)verified(options.file, name(certificate.scene));  // a picture of proved values only
    out.commit(staircase_svg(certificate.pieces, certificate.scene));
    return exit_done;
}

}  // namespace

void add_plot_command(CLI::App& app, int& exit_code) {
    auto options = std::make_shared<Options>();
    CLI::App* plot = app.add_subcommand("plot", "Draw pictures (SVG) from certificates.");
    plot->footer(footer);  // of its subcommands, too
    plot->require_subcommand(1);
    CLI::App* staircase = plot->add_subcommand(
        "staircase",
        "The proved maximum N(q) of a scene; of the dumbbell against the source paper's bound.\n\n"
        "Example: dumbbell plot staircase stairs.dbc --out stairs.svg");
    staircase->add_option("FILE", options->file, "certificate over a range of mass ratios")->required();
    staircase->add_option("--out", options->out, "the SVG file to write")->required()->type_name("FILE");
    staircase->callback([options, &exit_code] { exit_code = plot_staircase(*options); });
}

}  // namespace dumbbell
