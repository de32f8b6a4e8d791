#include "verify/program/options.hpp"

#include <algorithm>
#include <initializer_list>
#include <thread>

#include "verify/law/file.hpp"
#include "verify/program/claim_list.hpp"
#include "verify/program/claim_options.hpp"
#include "verify/program/version.hpp"

namespace dumbbell_verify {
namespace {

constexpr const char* help = R"(usage: dumbbell-verify [options] FILE...
       dumbbell-verify [options] --claims LIST
Checks certificates (docs/reference/format.md) independently of the program that wrote them.

  --ratio RATIO|LO:HI  the mass ratios (heavy/light) in question; else those of the file
  --max N              demand the proof that no trajectory has more than N collisions
  --min N              demand the proof that some trajectory has at least N collisions
  --exactly N          both
  --scene dumbbell|hybrid|wedge  demand this scene (dumbbell)
  --claim KIND         demand this kind of claim: collisions, or collisions-by-law (one mass ratio, with --law), or
                       initial-conditions (a file of `dumbbell trace --subdivide`: then --ratio, --max, --min,
                       --exactly are about the starts in its box), or incoming (the same of all trajectories
                       that come in, --incoming), or adiabatic-bounce, -run, -scattering, -printed
                       (the adiabatic invariant), or law (all mass ratios): these without --ratio, --max, --min,
                       --exactly, which they do not answer
  --claims LIST        the certificates and claims of a list like certificates/claims.tsv, one each line: a file
                       (its name is relative to the working folder), a tab, the six options above that state its
                       claim, with --ratio and a bound, or --claim law alone; what stands after another tab is a
                       remark
  --lemma 4.1|4.2 A B  compare two files: at most as many collisions in A (scene hybrid) as in B (wedge), or
                       at most one more in A (dumbbell) than in B (hybrid)
  --law FILE           the certificate of the law, on which files of the kind collisions-by-law rest by its SHA-256:
                       it is verified first, once for all of them; `dumbbell verify` takes the shipped one by itself
  --shards I-J         check only the pieces I to J (or I alone) of one file, counted from 1; the file is read as a
                       whole. The last line is `s PART ...`, which is not a verdict of the file
  --combine PARTS      check no piece, but take the lines `s PART` in the file PARTS, in any order: `s COMBINED`
                       states the whole file, if they are about it and have every piece. That dumbbell-verify
                       printed them is trusted, as it is of a log: run any part again that you doubt
  --jobs N             threads (all cores)
  --budget TIME        give up on a file that costs more work than a core does in this time, in about 30s, 10m
                       or 2h (30s). Counted in steps, not by a clock: the same on every machine
  --max-bits B         give up on pieces that need a higher precision (2048)
  --precision BITS     check with at least this many bits instead of in double
  --explain PIECE:PATH show one leaf with its inequalities: 3:bridge is the root, 3:light.01 the upper half
                       of its lower half, 3:witness the witness of the third piece; box.01 a leaf of a file
                       about initial conditions or the adiabatic invariant, in which class0.01 is a leaf of
                       the first class and attained1 the first attained state; layer.01, bulk1.17 and end.17
                       boxes of a file about the law; upper and lower the bounds of one by the law
  --shares             of one file about initial conditions: how likely each number of collisions is, bounds of its
                       share of the box, from the leaves that were checked
  --json               print JSON and nothing else: an array of one object for each file; with --lemma one object
  --junit FILE.xml     write a JUnit report, too: one test case for each file
  --quiet              print the last line only, and show no progress
  -h, --help, -V, --version  print that and nothing else

  dumbbell-verify --ratio 10 --exactly 4 ten.dbc       is N*(10) = 4 proved?
  dumbbell-verify --ratio 2:5/2 --max 3 stairs.dbc     at most 3 collisions on a part of the file's range?
  dumbbell-verify --explain 1:bridge ten.dbc           one leaf, in numbers
  dumbbell-verify --claim initial-conditions --min 1 falling.dbc    at least one collision from every start?
  dumbbell-verify --law certificates/law.dbc.gz --ratio 1e6 --exactly 887 million.dbc    one mass ratio by the law
  dumbbell-verify --junit proofs.xml --claims certificates/claims.tsv   in CI: every certificate, its own claim
  dumbbell-verify --ratio 3 --max 3 *.dbc | tail -n 1               how many files prove this?
  dumbbell-verify --json --lemma 4.1 hybrid.dbc wedge.dbc           a comparison, for a script
  dumbbell-verify --scene wedge --ratio 1:100 --max 16 wedge.dbc    the paper's model wedge
  dumbbell-verify --budget 10m huge.dbc                a staircase up to 10^8
  dumbbell-verify --jobs 1 --precision 200 --max-bits 4096 ten.dbc  slowly, in multiple precision, on one thread
  dumbbell-verify --quiet --shards 1-90 stairs.dbc >> parts.txt     one part of a large certificate
  dumbbell-verify --combine parts.txt --ratio 3:9 --max 4 stairs.dbc    all of its parts, put together

FILE `-` is the standard input. Of one file the last line is its verdict: s VERIFIED, s REJECTED, s UNSUPPORTED,
s UNREADABLE or s LIMIT; instead of s VERIFIED with --shards s PART, with --combine s COMBINED. Of several, each has one
such line with its name, in the given order, and a line with the numbers ends them:
c files=3 verified=2 rejected=1 ...
Exit code: 0 verified and proved (with --shards: the part; with --combine: if its lines are true), 1 rejected, 2 usage
or unreadable, 3 unsupported, 4 resource limit; of several codes the first of 1, 4, 3, 2, 0.
)";

/// The option `name` was given, so none of the others must have been.
void exclude(const Words& words, const std::string& name, std::initializer_list<const char*> others) {
    for (const char* other : others)
        if (words.seen(name) && words.seen(other))
            throw std::invalid_argument(name + " and " + other + " exclude each other; see --help");
}

/// Puts the present option into the job if it is --shards or --combine, of a verification in parts; false if
/// it is another. Throws std::invalid_argument.
bool part_option(Words& words, Job& job) {
    if (words.option != "--shards" && words.option != "--combine") return false;
    words.once();
    const std::string value = words.value();
    Settings& settings = job.settings;
    if (words.option == "--combine") {
        job.parts = value;
        settings.check = {};
        settings.demand.keep = all_pieces;
        return true;
    }
    settings.check = settings.demand.keep = parse_pieces(value);
    if (settings.check == Pieces{})
        throw std::invalid_argument("--shards needs the numbers of pieces, such as 5-8 or 5, not `" +
                                    value.substr(0, 60) + "`");
    return true;
}

/// A name like that of no certificate, so that `--junit *.dbc` destroys none.
std::string report_name(const std::string& path) {
    if (!path.ends_with(".xml") || path == ".xml")
        throw std::invalid_argument("--junit needs a file name that ends in .xml, not `" + path + "`");
    return path;
}

void check_together(const Words& words, const Options& options) {
    exclude(words, "--explain", {"--json", "--quiet"});
    exclude(words, "--json", {"--quiet"});
    exclude(words, "--lemma", {"--scene", "--claim", "--max", "--min", "--exactly", "--explain", "--claims"});
    exclude(words, "--claims", {"--ratio", "--max", "--min", "--exactly", "--scene", "--claim"});
    exclude(words, "--shards",
            {"--ratio", "--max", "--min", "--exactly", "--lemma", "--claims", "--explain", "--combine"});
    exclude(words, "--combine", {"--lemma", "--claims", "--explain", "--max-bits"});
    exclude(words, "--shares", {"--quiet", "--lemma", "--claims", "--shards", "--combine"});
    if (words.seen("--claims") && !options.jobs.empty())
        throw std::invalid_argument("--claims names the files: give no other FILE");
    if (options.lemma && options.jobs.size() != 2) throw std::invalid_argument("--lemma compares two files");
    for (const char* name : {"--shards", "--combine", "--shares"})
        if (words.seen(name) && options.jobs.size() != 1)
            throw std::invalid_argument(std::string(name) + " is about one FILE");
    if (!words.seen("--claims") && options.jobs.empty()) throw std::invalid_argument("no FILE; see --help");
}

}  // namespace

Options parse_options(const std::vector<std::string>& arguments) {
    Options result;
    Job asked;
    Settings& settings = asked.settings;
    Words words(arguments);
    std::string claims;
    settings.jobs = std::max(1U, std::thread::hardware_concurrency());
    const auto bits = [&] { return static_cast<unsigned>(words.number(53, 4096)); };
    while (words.next()) {
        const std::string& name = words.option;
        if (name.empty())
            result.jobs.push_back({words.word, {}});  // its settings: below
        else if (claim_option(words, settings) || part_option(words, asked))
            continue;
        else if (name == "--claims")
            claims = words.value();
        else if (name == "--law") {
            words.once();
            result.inputs.push_back(words.value());
            settings.law = std::make_shared<LawFile>(result.inputs.back());
        } else if (name == "--lemma") {
            const std::string lemma = words.value();
            result.lemma = find_lemma(lemma);
            if (!result.lemma)
                throw std::invalid_argument("no lemma `" + lemma.substr(0, 60) + "`: 4.1 or 4.2");
        } else if (name == "--jobs")
            settings.jobs = static_cast<unsigned>(words.number(1, 1024));
        else if (name == "--max-bits")
            settings.max_bits = bits();
        else if (name == "--precision")
            settings.precision = bits();
        else if (name == "--budget")
            settings.budget = words.time();
        else if (name == "--explain")
            settings.explain = words.value();
        else if (name == "--junit")
            result.junit = report_name(words.value());
        else if (words.word == "--shares")
            settings.shares = true;
        else if (words.word == "--json")
            result.json = true;
        else if (words.word == "--quiet")
            result.quiet = true;
        else if (words.word == "--help" || words.word == "-h")
            result.answer = help;
        else if (words.word == "--version" || words.word == "-V")
            result.answer = "dumbbell-verify " + std::string(version) + " (" __VERSION__ ")\n";
        else
            throw std::invalid_argument("unknown option " + words.word + "; see --help");
    }
    if (!result.answer.empty()) return result;
    check_together(words, result);
    if (result.lemma) settings.demand.keep = all_pieces;
    for (Job& job : result.jobs) job = {job.file, settings, asked.parts};
    if (words.seen("--claims")) result.jobs = read_claims(claims, settings);
    if (result.lemma) {
        result.jobs[0].settings.scene = result.lemma->scene_a;
        result.jobs[1].settings.scene = result.lemma->scene_b;
    }
    // A leaf that is explained is printed while it is checked: one file after the other.
    if (settings.explain.empty())
        result.at_once = static_cast<unsigned>(std::min<std::size_t>(settings.jobs, result.jobs.size()));
    for (Job& job : result.jobs) job.settings.jobs = settings.jobs / result.at_once;
    for (const Job& job : result.jobs) result.inputs.push_back(job.file);
    if (words.seen("--claims")) result.inputs.push_back(claims);
    if (asked.parts) result.inputs.push_back(*asked.parts);
    return result;
}

}  // namespace dumbbell_verify
