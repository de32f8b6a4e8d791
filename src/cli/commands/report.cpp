#include "cli/commands/report.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "cli/terminal/exit_code.hpp"
#include "cli/terminal/out_option.hpp"
#include "cli/terminal/progress.hpp"
#include "cli/terminal/standard_input.hpp"
#include "page/data.hpp"
#include "page/page.hpp"

namespace dumbbell {
namespace {

constexpr const char* description =
    R"(Make one HTML page from certificates, to be opened in any browser.

It needs no network and no other file. It shows the staircase against the source paper's bound, the boxes of a cover with their reasons, the witness orbits
bounce by bounce (and any initial condition typed into the page), and tables of what is claimed, by which lemmas.
Certificates of every kind can stand in one page, and tables of critical ratios (dumbbell critical --out).

The page does not verify: it shows what the files claim, each with the command that verifies it. Files whose checksum
is wrong are refused. Moving pictures are computed in double precision in the browser; they illustrate, they prove
nothing.

Examples:
  dumbbell report certificates/stairs-1-100.dbc --out report.html
  dumbbell report stairs.dbc full-100.dbc falling.dbc --out report.html
  dumbbell report certificates/full-1000.dbc.gz --max-boxes 5000 --out small.html)";

constexpr const char* footer =
    "Exit codes: 0 the page is written; 1 internal error; 2 wrong usage, or a file that cannot be read.";

constexpr std::size_t most_boxes_in_any_page = 2'000'000;

struct Options {
    std::vector<std::string> files;
    std::string out;
    std::size_t most_boxes = default_most_boxes;
};

int run(const Options& options) {
    const Output out(options.out, options.files);
    Progress progress("", Loudness::normal, "making the page");
    std::vector<ReportedFile> files;
    std::size_t boxes = 0;
    for (const std::string& path : options.files) {
        files.push_back(read_reported(input_file(path)));
        files.back().path = path;
        boxes += leaves_of(files.back().content);
    }
    out.commit(html_page(page_data(files, options.most_boxes)));
    if (boxes > options.most_boxes) {
        progress.note(
            fmt::format("{} boxes are drawn as {} or fewer, as the page says; for more of them: --max-boxes",
                        boxes, options.most_boxes));
    }
    return exit_done;
}

}  // namespace

void add_report_command(CLI::App& app, int& exit_code) {
    auto options = std::make_shared<Options>();
    CLI::App* command = app.add_subcommand("report", description);
    command->footer(footer);
    command
        ->add_option("FILE", options->files,
                     "certificates of any kind, tables of critical ratios (-: the standard input)")
        ->required();
    add_out_option(*command, options->out, {Content::page}, "the HTML file to write")->required();
    command
        ->add_option("--max-boxes", options->most_boxes,
                     "boxes that the page draws; where there are more, one stands for several, and is marked")
        ->check(CLI::Range(std::size_t{1}, most_boxes_in_any_page))
        ->capture_default_str();
    command->callback([options, &exit_code] { exit_code = run(*options); });
}

}  // namespace dumbbell
