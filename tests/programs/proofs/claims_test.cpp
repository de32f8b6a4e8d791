// The shipped certificates: each row of certificates/claims.tsv is proved by its file, and the small files
// can be made again, byte for byte, with the command of the row.
#include <algorithm>
#include <sstream>

#include "catch.hpp"
#include "programs/cli/process.hpp"

using namespace dumbbell_test;
namespace fs = std::filesystem;

namespace {

using Words = std::vector<std::string>;

const fs::path project = DUMBBELL_PROJECT;

struct Row {
    std::string certificate;
    Words claim;
    Words command;
    bool small;
};

Words split(const std::string& text, char separator) {
    Words words;
    std::istringstream in(text);
    for (std::string word; std::getline(in, word, separator);) {
        words.push_back(word);
    }
    return words;
}

// Lines that begin with # are remarks.
std::vector<Row> rows() {
    std::vector<Row> result;
    std::istringstream lines(contents(project / "certificates/claims.tsv"));
    for (std::string line; std::getline(lines, line);) {
        if (line.empty() || line[0] == '#') {
            continue;
        }
        const Words fields = split(line, '\t');
        if (fields.size() != 4 || (fields[3] != "yes" && fields[3] != "no")) {
            throw std::runtime_error("claims.tsv: not 'certificate, claim, command, yes or no': " + line);
        }
        result.push_back(
            {"certificates/" + fields[0], split(fields[1], ' '), split(fields[2], ' '), fields[3] == "yes"});
    }
    return result;
}

bool is_certificate(const fs::path& path) {
    return path.string().ends_with(".dbc") || path.string().ends_with(".dbc.gz");
}

}  // namespace

TEST_CASE("every shipped certificate proves its claim") {
    REQUIRE_FALSE(rows().empty());
    // Without a claim in each row the verifier refuses the list.
    const Outcome result =
        run({DUMBBELL_VERIFY_BIN, "--claims", "certificates/claims.tsv"}, project.string());
    CAPTURE(result.out, result.err);
    CHECK(result.code == 0);
    const Words lines = split(result.out, '\n');
    REQUIRE(lines.size() == rows().size() + 1);
    for (std::size_t i = 0; i < rows().size(); ++i) {
        CHECK_THAT(lines[i], StartsWith("s VERIFIED ") && EndsWith(" file=" + rows()[i].certificate));
    }
}

TEST_CASE("every small certificate is made again, byte for byte, by its command") {
    long small = 0;
    for (const Row& row : rows()) {
        if (!row.small) {
            continue;
        }
        ++small;
        DYNAMIC_SECTION(row.certificate) {
            REQUIRE(row.command.size() > 1);
            REQUIRE(row.command.front() == "dumbbell");
            const TemporaryFolder folder;
            const std::string made = folder / row.certificate;
            fs::create_directories(fs::path(made).parent_path());
            Words command = row.command;
            command.front() = DUMBBELL_BIN;
            const Outcome result = run(command, folder.path());
            CAPTURE(result.err);
            REQUIRE(result.code == 0);
            REQUIRE(fs::exists(made));
            CHECK((contents(made) == contents(project / row.certificate)));
        }
    }
    CHECK(small > 0);
}

TEST_CASE("every certificate that is shipped is listed, once") {
    Words listed;
    for (const Row& row : rows()) {
        listed.push_back(row.certificate);
    }
    std::sort(listed.begin(), listed.end());
    CHECK(std::adjacent_find(listed.begin(), listed.end()) == listed.end());
    REQUIRE(fs::is_directory(project / "certificates"));
    for (const auto& entry : fs::recursive_directory_iterator(project / "certificates")) {
        if (entry.is_regular_file() && is_certificate(entry.path())) {
            const std::string name = fs::relative(entry.path(), project).string();
            CAPTURE(name);
            CHECK(std::binary_search(listed.begin(), listed.end(), name));
        }
    }
}

TEST_CASE("the checksums of the shipped files are right, and none is missing") {
    const Outcome result =
        run({"sha256sum", "--check", "--strict", "SHA256SUMS"}, (project / "certificates").string());
    CAPTURE(result.out, result.err);
    CHECK(result.code == 0);
    const std::string sums = contents(project / "certificates/SHA256SUMS");
    for (const Row& row : rows()) {
        CAPTURE(row.certificate);
        CHECK(sums.find("  " + fs::path(row.certificate).filename().string() + "\n") != std::string::npos);
    }
}

TEST_CASE("the claims that the project promises are among them") {
    const auto promised = [](const Words& claim) {
        const auto all = rows();
        return std::any_of(all.begin(), all.end(), [&](const Row& row) { return row.claim == claim; });
    };
    CHECK(promised({"--ratio", "1", "--exactly", "2"}));
    CHECK(promised({"--ratio", "10", "--exactly", "4"}));
    CHECK(promised({"--ratio", "100", "--exactly", "10"}));
    CHECK(promised({"--ratio", "1e4", "--exactly", "90"}));
    CHECK(promised({"--ratio", "1e6", "--exactly", "887"}));
    CHECK(promised({"--ratio", "1:100", "--max", "10", "--min", "2", "--gap", "1e-6", "--gaps", "8"}));
}
