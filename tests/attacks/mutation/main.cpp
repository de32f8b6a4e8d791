// mutation: certificates changed in every small way, and each mutant through the verifier.
#include <CLI/CLI.hpp>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <sstream>

#include "corpus.hpp"
#include "report.hpp"
#include "text.hpp"

namespace dumbbell_mutation {
namespace {

constexpr const char* description =
    R"(Changes certificates in every small way and gives each mutant to the verifier.
Exit code 0: no defect was found; 1: one was; 2: wrong usage. Whether accepted mutants are true the second
verifier is asked by ../second_opinion/mutants_test.py.

  mutation --jobs 2 --report FOLDER      all mutants, and tables of what became of them
  mutation --dump FOLDER 500             some of them as files, with what the verifier said of each
  mutation --replay FOLDER/manifest.tsv  whether it still says the same
  mutation --close FILE                  the certificate with the totals and the checksum that fit it)";

struct Request {
    Options options;
    std::string report, only, manifest, program, close;
    std::vector<std::string> dump;  ///< folder and number
    std::size_t at_least = 0;
};

std::string contents(const std::string& path) {
    std::ifstream in(path, std::ios::binary);
    std::ostringstream text;
    text << in.rdbuf();
    if (!in) throw std::runtime_error("cannot read " + path);
    return text.str();
}

int mutate(const Request& request) {
    Report report;
    Corpus corpus;
    for (const Base& base : bases(request.options.scale > 1)) {
        if (!request.only.empty() && base.name != request.only) continue;
        const std::vector<Trial> trials = trials_of(base, request.options);
        const std::vector<Result> results = run(trials, request.options);
        report.add(base, trials, results);
        if (!request.dump.empty()) corpus.add(base, trials, results);
    }
    if (!request.report.empty()) {
        std::filesystem::create_directories(request.report);
        write_file(request.report + "/summary.tsv", report.summary());
        write_file(request.report + "/accepted.tsv", report.accepted());
        write_file(request.report + "/defects.tsv", report.defects());
    }
    if (!request.dump.empty()) corpus.write(request.dump[0], std::stoul(request.dump[1]));
    std::cout << report.defects() << report.sentence() << "\n";
    if (report.tried() >= request.at_least) return report.defects().empty() ? 0 : 1;
    std::cout << "fewer mutants than the " << request.at_least << " that were asked for\n";
    return 1;
}

int answer(const Request& request) {
    if (!request.close.empty()) {
        std::cout << closed(contents(request.close));
        return 0;
    }
    if (request.manifest.empty()) return mutate(request);
    const std::string differences = replay(request.manifest, request.program);
    std::cout << differences << read_manifest(request.manifest).size() << " files\n";
    return differences.empty() ? 0 : 1;
}

}  // namespace
}  // namespace dumbbell_mutation

int main(int argc, char** argv) {
    dumbbell_mutation::Request request;
    CLI::App app(dumbbell_mutation::description);
    app.add_option("--report", request.report, "write summary.tsv, accepted.tsv and defects.tsv there")
        ->type_name("FOLDER");
    app.add_option("--base", request.only, "the mutants of this base alone")->type_name("NAME");
    app.add_option("--at-least", request.at_least, "fail if there are fewer mutants")->type_name("N");
    app.add_option("--jobs", request.options.jobs, "processes")->check(CLI::Range(1, 64));
    app.add_option("--most", request.options.most, "mutants of each base")
        ->check(CLI::Range(10, 1'000'000))
        ->capture_default_str();
    app.add_option("--scale", request.options.scale,
                   "the factor by which there are more mutants, several changes at once among them")
        ->envname("DUMBBELL_TEST_SCALE")
        ->check(CLI::Range(1, 1000));
    app.add_option("--dump", request.dump, "write N mutants and manifest.tsv there")
        ->expected(2)
        ->type_name("FOLDER N");
    app.add_option("--replay", request.manifest, "verify the files of this table again")->type_name("FILE");
    app.add_option("--program", request.program, "with --replay: by this program, instead of in this process")
        ->type_name("FILE");
    app.add_option("--close", request.close, "print this certificate with a trailer that fits")
        ->type_name("FILE");
    try {
        app.parse(argc, argv);
        return dumbbell_mutation::answer(request);
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? 0 : 2;
    } catch (const std::exception& error) {
        std::cerr << "mutation: " << error.what() << "\n";
        return 2;
    }
}
