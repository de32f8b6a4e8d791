#include "file/sealed_lines.hpp"

#include <algorithm>

#include "base/error.hpp"
#include "catch.hpp"
#include "file/atomic_file.hpp"
#include "file/sha256.hpp"
#include "programs/cli/process.hpp"

using namespace dumbbell;
using namespace dumbbell_test;

namespace {

const std::string sealed_body = "dumbbell-certificate 1\nbits 128\nend\n";

std::string digest() {
    Sha256 sha;
    sha.add(sealed_body);
    return sha.hex();
}

std::string sealed() { return sealed_body + "sha256 " + digest() + "\n"; }

std::string digest_of(const std::string& text) {
    const TemporaryFolder folder;
    write_file(folder / "file.dbc", text);
    return sealed_digest(folder / "file.dbc");
}

}  // namespace

TEST_CASE("the digest of a file is the one in its last line, plain or compressed") {
    CHECK(digest_of(sealed()) == digest());
    const TemporaryFolder folder;
    AtomicFile(folder / "file.dbc.gz").commit(sealed());
    CHECK(sealed_digest(folder / "file.dbc.gz") == digest());
    // What was read before is not read again.
    const std::string packed = file_contents(folder / "file.dbc.gz");
    CHECK(sealed_digest(NamedFile("no/such/file.dbc", packed)) == digest());
}

TEST_CASE("a damaged file has no digest: cut off, changed, or with something after its end") {
    const std::string good = sealed();
    std::vector<std::string> damaged{good.substr(0, good.size() - 1), good.substr(0, good.size() / 2),
                                     good + "\n", good + good, replaced(good, "bits 128", "bits 129")};
    damaged.push_back(good);
    damaged.back()[good.size() - 2] = good[good.size() - 2] == '0' ? '1' : '0';
    for (const std::string& text : damaged) {
        CAPTURE(text);
        CHECK_THROWS_WITH(digest_of(text), Contains("damaged"));
    }
    for (const char* other : {"", "certificates/q-1.dbc\t--ratio 1\n", "dumbbell-certificate 1"}) {
        CHECK_THROWS_WITH(digest_of(other),
                          Contains("is not a certificate: its first line is not 'dumbbell-certificate 1'"));
    }
    CHECK_THROWS_WITH(sealed_digest("no/such/file.dbc"), Contains("no such file"));
}

TEST_CASE("a long text that goes to a sink is never there as a whole, and its digest is the same") {
    const auto write = [](SealedLines lines) {
        for (int i = 0; i < 100'000; ++i) {
            lines.line("line {}", i);
        }
        return std::move(lines).sealed();
    };
    std::string text;
    std::size_t longest = 0;
    const SealedText handed_on = write(SealedLines([&](std::string_view part) {
        text += part;
        longest = std::max(longest, part.size());
    }));
    const SealedText kept = write(SealedLines());
    CHECK(handed_on.text.empty());
    CHECK(handed_on.sha256 == kept.sha256);
    CHECK((text == kept.text));
    CHECK(longest < 100'000);
    CHECK(text.size() > 1'000'000);
}
