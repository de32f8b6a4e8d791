// The tools of the driver: what they make is what it is said to be, and the prover's formulas refuse what is
// false of the adiabatic invariant.
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <set>
#include <sstream>

#include "adiabatic/writer.hpp"
#include "adiabatic_argument.hpp"
#include "apart.hpp"
#include "campaign.hpp"
#include "catch.hpp"
#include "corpus.hpp"
#include "manifest.hpp"
#include "temporary_folder.hpp"
#include "text.hpp"

using namespace dumbbell_mutation;

namespace {

const std::vector<Base>& all_bases() {
    static const std::vector<Base> all = bases(false);
    return all;
}

}  // namespace

TEST_CASE("The trailer that is made anew is the one that the prover wrote") {
    for (const Base& base : all_bases()) {
        INFO(base.name);
        CHECK(closed(base.text) == base.text);
        CHECK(hashed(base.text) == base.text);
        CHECK(text_of(lines_of(base.text)) == base.text);
    }
}

TEST_CASE("Every base is verified, and shown to be true if it is about the adiabatic invariant") {
    const Scratch file;
    for (const Base& base : all_bases()) {
        file.write(base.text);
        const Outcome outcome = examine(file.path(), {});
        INFO(base.name << ": " << outcome.text);
        REQUIRE(outcome.accepted());
        const auto* claim =
            dynamic_cast<const dumbbell_verify::adiabatic::Claim*>(outcome.proof->other.get());
        if (!claim) continue;
        const Argument argument = adiabatic_argument(file.path(), claim);
        INFO(argument.text);
        CHECK(argument.holds);
    }
}

TEST_CASE("Together the bases have every opcode, section, scene, precision and kind of piece") {
    std::set<std::string> found;
    for (const Base& base : all_bases()) {
        for (const std::string& line : lines_of(base.text)) {
            const Words words = words_of(line);
            if (words[0] == "total") {
                if (words[2] != "0") found.insert(words[1]);
            } else if (words[0] == "bits") {
                found.insert(words[1] == "53" ? "double" : "multiple");
            } else if (words[0] == "scene" || words[0] == "section" || words[0] == "lemmas" ||
                       words[0] == "claim" || words[0] == "chart") {
                found.insert(line);
            }
        }
    }
    for (const std::string what : {"split",
                                   "count",
                                   "outside",
                                   "meets",
                                   "meets-reversed",
                                   "equal-masses",
                                   "symmetric",
                                   "witness",
                                   "once",
                                   "open",
                                   "exactly",
                                   "between",
                                   "double",
                                   "multiple",
                                   "lemmas minimal",
                                   "scene body",
                                   "section full",
                                   "section none",
                                   "section perpendicular",
                                   "claim initial-conditions",
                                   "bound",
                                   "claim adiabatic-bounce",
                                   "claim adiabatic-run",
                                   "claim adiabatic-scattering",
                                   "chart again",
                                   "chart departure"})
        CHECK(found.contains(what));
}

TEST_CASE("Trees are found in the lines") {
    const Lines lines = {"chart bridge", "split e", "outside", "split q", "count 1 2", "meets", "lower 0"};
    const auto nodes = nodes_of(lines);
    REQUIRE(nodes.size() == 5);
    CHECK((nodes[0].begin == 1 && nodes[0].upper == 3 && nodes[0].end == 6));
    CHECK((nodes[2].begin == 3 && nodes[2].upper == 5 && nodes[2].end == 6));
    CHECK((nodes[4].begin == 5 && nodes[4].upper == 0 && nodes[4].end == 6));
    CHECK(nodes_of({"chart bridge", "split e", "outside"}).empty());
    const auto roots = [](const Lines& adiabatic) {
        std::vector<std::size_t> begins;
        for (const TreeNode& node : nodes_of(adiabatic))
            if (node.begin == node.tree) begins.push_back(node.begin);
        return begins;
    };
    CHECK(roots({"claim adiabatic-run", "bound 3/2", "classes 1", "class 1/1 2", "cell 1/2 1/1",
                 "cell 1/4 2/1", "split u", "bound", "outside", "end", "bound 0",
                 "attained 1/2 0/1 1/20 1 1/2"}) == std::vector<std::size_t>{6, 10});
    CHECK(roots({"claim adiabatic-bounce", "bound 3/2 2/1", "split s", "bound", "outside"}) ==
          std::vector<std::size_t>{2});
}

TEST_CASE("The prover's formulas refuse false claims about the adiabatic invariant") {
    namespace adiabatic = dumbbell::adiabatic;
    const Scratch file;
    int refused = 0;
    for (const Base& base : all_bases()) {
        const auto* data = std::get_if<adiabatic::Certificate>(&base.data);
        if (!data) continue;
        const auto refuses = [&](const std::string& what, const auto& change) {
            adiabatic::Certificate changed = *data;
            change(changed);
            file.write(adiabatic::render(changed).text);
            INFO(base.name << ": " << what);
            CHECK_FALSE(adiabatic_argument(file.path(), nullptr).holds);
            ++refused;
        };
        for (std::size_t i = 0; i < data->attained.size(); ++i) {
            refuses("more attained", [&](adiabatic::Certificate& c) { c.attained[i].value *= 2; });
            refuses("nearer than the margin", [&](adiabatic::Certificate& c) { c.attained[i].u /= 64; });
            if (i < data->bounds.size())
                refuses("less than is attained", [&](adiabatic::Certificate& c) {
                    c.bounds[i] = c.attained[i].value * dumbbell::Rational(9, 10);
                });
        }
        if (!data->bounds.empty()) {
            refuses("no state at all", [](adiabatic::Certificate& c) { c.tree = {{std::nullopt, true, 0}}; });
            refuses("a part is missing", [](adiabatic::Certificate& c) {
                c.tree.insert(c.tree.begin(), {adiabatic::Axis::u, false, 0});
                c.tree.push_back({std::nullopt, true, 0});
            });
        }
        for (std::size_t i = 0; i < data->classes.size(); ++i) {
            refuses("no density", [&](adiabatic::Certificate& c) {
                for (auto& cell : c.classes[i].cells) cell.v = 0;
            });
            refuses("J too small",
                    [&](adiabatic::Certificate& c) { c.classes[i].least_share = dumbbell::Rational(3, 4); });
            refuses("no flight at all", [&](adiabatic::Certificate& c) {
                c.classes[i].tree = {{std::nullopt, true, 0}};
            });
        }
    }
    CHECK(refused >= 20);
}

TEST_CASE("Every false claim is in the table, and the other way round") {
    const std::filesystem::path folder = DUMBBELL_FALSE_CLAIMS;
    std::set<std::string> listed, there;
    for (const Entry& entry : read_manifest((folder / "manifest.tsv").string())) listed.insert(entry.file);
    for (const auto& file : std::filesystem::directory_iterator(folder))
        if (file.path().extension() == ".dbc") there.insert(file.path().filename().string());
    CHECK(listed == there);
}

TEST_CASE("Crashes and endless loops are counted, and the rest is done all the same") {
    const auto ended = run_apart(12, 3, 1, [](std::size_t i) {
        if (i == 3) std::raise(SIGKILL);
        for (volatile std::size_t endless = i; endless == 5;) continue;
        return std::to_string(i * i);
    });
    REQUIRE(ended.size() == 12);
    for (std::size_t i = 0; i < ended.size(); ++i) {
        INFO(i);
        CHECK(ended[i].signal == (i == 3 ? SIGKILL : i == 5 ? SIGPROF : 0));
        CHECK(ended[i].result == (i == 3 || i == 5 ? "" : std::to_string(i * i)));
    }
}

TEST_CASE("What is dumped is verified again with the same words") {
    const dumbbell_test::TemporaryFolder folder;
    const Base& base = all_bases().at(1);
    const Options options{.most = 300};
    const auto trials = trials_of(base, options);
    REQUIRE(trials.size() > 300);
    Corpus corpus;
    corpus.add(base, trials, run(trials, options));
    corpus.write(folder / "corpus", 100);
    const std::string table = folder / "corpus/manifest.tsv";
    CHECK(read_manifest(table).size() == 100);
    CHECK(replay(table, "") == "");
    CHECK_THROWS_AS(corpus.write(folder / "corpus", 100), std::runtime_error);
}
