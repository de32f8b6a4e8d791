#include <fmt/core.h>

#include <algorithm>
#include <iterator>
#include <string>
#include <vector>

#include "cli/commands.hpp"
#include "cli/options/given.hpp"
#include "cli/terminal/exit_code.hpp"
#include "cli/terminal/output.hpp"
#include "cli/terminal/progress.hpp"
#include "cli/terminal/standard_input.hpp"
#include "file/file_contents.hpp"
#include "file/shipped.hpp"
#include "page/data.hpp"

namespace dumbbell::cli {
namespace {

constexpr const char* report_description =
    R"(Make one HTML page from certificates, to be opened in any browser.

It needs no network and no other file. It shows the staircase against the source paper's bound, the boxes of a cover
with their reasons, the witness orbits bounce by bounce (and any initial condition typed into the page), and tables of
the claims and their lemmas. Certificates of dumbbell certify and dumbbell trace can stand in one page.

The page shows what the files claim, each with the command that verifies it. If ./run web was run before, the page
contains the files and the independent verifier, too, and verifies them in the browser. Files whose checksum is wrong
are refused. Moving pictures are computed in double precision; they illustrate, they prove nothing.

Examples:
  dumbbell report certificates/stairs-1-100.dbc --out report.html
  dumbbell report stairs.dbc full-100.dbc falling.dbc --out report.html
  dumbbell report certificates/full-1000.dbc.gz --max-boxes 5000 --out small.html)";

constexpr const char* report_footer =
    "Exit codes: 0 the page is written; 1 internal error; 2 wrong usage, or a file that cannot be read.";

constexpr std::array report_options{
    argument("FILE", "certificates of dumbbell certify and dumbbell trace (-: the standard input)")
        .required()
        .repeated(),
    Option{"--out", "FILE", "the HTML file to write; -: the standard output"}
        .checked(fault_of_name<Content::page>)
        .required(),
    Option{"--max-boxes", "N",
           "boxes that the page draws; where there are more, one stands for several, and is marked", "200000"}
        .from(1, 2'000'000),
    flag("--no-verifier", "make a page without the verifier, which is smaller")};

int run_report(const Given& given) {
    const Output out(given.text("--out"), given.words("FILE"));
    const auto most_boxes = static_cast<std::size_t>(given.number("--max-boxes"));
    const std::vector<std::string>& names = given.words("FILE");
    Progress progress("", Verbosity::normal, "reading");
    std::vector<std::string> paths;
    std::ranges::transform(names, std::back_inserter(paths), input_file);
    page::require_few_pieces(paths);
    const auto verifier = given.has("--no-verifier") ? std::nullopt : verifier_for_pages();
    std::vector<page::ReportedFile> files;
    std::size_t boxes = 0;
    for (std::size_t i = 0; i < names.size(); ++i) {
        files.push_back(page::read_reported(paths[i], file_contents(paths[i]), verifier.has_value()));
        files.back().path = names[i];
        boxes += page::leaves_of(files.back().content);
    }
    progress.enter("making the page", "");
    out.commit(page::html_page(page_data(files, most_boxes), verifier ? file_contents(*verifier) : ""));
    if (!verifier && !given.has("--no-verifier")) {
        progress.note(
            "Written. The page shows the proof; it does not contain the verifier (./run web adds it)");
    }
    if (boxes > most_boxes) {
        progress.note(
            fmt::format("{} boxes are drawn as {} or fewer, as the page says; --max-boxes allows more", boxes,
                        most_boxes));
    }
    return exit_done;
}

}  // namespace

constinit const Command report_command{"report",      first_group,    report_description,
                                       report_footer, report_options, run_report};

}  // namespace dumbbell::cli
