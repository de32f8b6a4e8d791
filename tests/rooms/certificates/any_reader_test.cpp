#include "certificates/any_reader.hpp"

#include <sys/stat.h>

#include "adiabatic/writer.hpp"
#include "base/error.hpp"
#include "catch.hpp"
#include "collisions/reader.hpp"
#include "collisions/writer.hpp"
#include "file/atomic_file.hpp"
#include "programs/cli/process.hpp"
#include "rooms/collisions/example.hpp"
#include "rooms/not_root.hpp"
#include "starts/writer.hpp"

using namespace dumbbell_test;
using namespace dumbbell::adiabatic;
using namespace dumbbell::certificates;
using namespace dumbbell::collisions;

namespace {

SealedText initial_text() {
    dumbbell::starts::InitialCertificate certificate{{"dumbbell", "0.1.0"}, {}, 53, {{}}};
    certificate.box.lo = certificate.box.hi = {0, 1, 3, -1, 10};
    return render(certificate);
}

SealedText adiabatic_text() {
    AdiabaticCertificate certificate;
    certificate.generator = {"dumbbell", "0.1.0"};
    certificate.hypotheses.claim = AdiabaticClaim::scattering;
    certificate.hypotheses.delta = {Rational(1, 100), Rational(1, 100)};
    certificate.hypotheses.margin = Rational(1, 2);
    certificate.bounds = {20};
    certificate.classes = {{2, {}, {{}}}};
    certificate.tree = {{}};
    certificate.attained = {{Rational(1, 2), 1, Rational(1, 100), 63, 3}};
    return render(certificate);
}

// Does `check(path)` with a file of this text.
template <class Check>
auto with_file(const std::string& text, const Check& check, const std::string& name = "file.dbc") {
    const TemporaryFolder folder;
    write_file(folder / name, text);
    return check(folder / name);
}

std::string digest_of(const std::string& text) { return with_file(text, sealed_digest); }

}  // namespace

TEST_CASE("a certificate of each claim kind is read as what it is") {
    CHECK(std::holds_alternative<Certificate>(
        with_file(render(every_kind_of_line()).text, read_any_certificate)));
    CHECK(std::holds_alternative<dumbbell::starts::InitialCertificate>(
        with_file(initial_text().text, read_any_certificate)));
    CHECK(
        std::holds_alternative<AdiabaticCertificate>(with_file(adiabatic_text().text, read_any_certificate)));
}

TEST_CASE("where mass ratios are needed, a certificate of another claim is told apart from no certificate") {
    CHECK_THROWS_WITH(with_file(initial_text().text, read_certificate),
                      Contains("is about initial conditions"));
    CHECK_THROWS_WITH(with_file(adiabatic_text().text, read_certificate),
                      Contains("is about the adiabatic invariant"));
}

TEST_CASE("an unknown claim, no certificate and no file are refused") {
    const std::string unknown = replaced(initial_text().text, "claim initial-conditions", "claim to-fame");
    CHECK_THROWS_AS(with_file(unknown, read_any_certificate), InputError);
    CHECK_THROWS_AS(with_file("", read_any_certificate), InputError);
    CHECK_THROWS_AS(with_file("some text\n", read_any_certificate), InputError);
    CHECK_THROWS_WITH(read_any_certificate("no/such/file.dbc"), Contains("no such file"));
    const std::string of_law = replaced(initial_text().text, "claim initial-conditions", "claim law");
    CHECK_THROWS_WITH(with_file(of_law, read_any_certificate),
                      Contains("no page and no picture shows that; dumbbell verify checks it"));
}

TEST_CASE("the digest of a file is the one in its last line, plain or compressed") {
    for (const SealedText& good : {render(every_kind_of_line()), initial_text(), adiabatic_text()}) {
        CHECK(digest_of(good.text) == good.sha256);
        const TemporaryFolder folder;
        AtomicFile(folder / "file.dbc.gz").commit(good.text);
        CHECK(sealed_digest(folder / "file.dbc.gz") == good.sha256);
    }
}

TEST_CASE("a damaged file has no digest: cut off, changed, or with something after its end") {
    const std::string good = render(every_kind_of_line()).text;
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

TEST_CASE("a file with more than one gzip member is neither read nor has a digest") {
    const TemporaryFolder folder;
    AtomicFile(folder / "good.dbc.gz").commit(initial_text().text);
    const std::string packed = contents(folder / "good.dbc.gz");
    for (const std::string& after : {std::string("x\n"), packed}) {
        write_file(folder / "bad.dbc", packed + after);
        CHECK_THROWS_WITH(sealed_digest(folder / "bad.dbc"), Contains("bytes after the gzip member"));
        CHECK_THROWS_WITH(read_any_certificate(folder / "bad.dbc"), Contains("bytes after the gzip member"));
    }
}

TEST_CASE("a certificate that cannot be read is not called something else") {
    const TemporaryFolder folder;
    write_file(folder / "file.dbc", initial_text().text);
    ::chmod((folder / "file.dbc").c_str(), 0);
    ::chmod(folder.path().c_str(), 0755);
    const NotRoot user;
    const std::string why = "cannot read '" + (folder / "file.dbc") + "': Permission denied";
    CHECK_THROWS_WITH(sealed_digest(folder / "file.dbc"), why);
    CHECK_THROWS_WITH(read_any_certificate(folder / "file.dbc"), why);
}
