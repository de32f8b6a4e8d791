#include "page/any_certificate.hpp"

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
#include "starts/answer/writer.hpp"

using namespace dumbbell_test;
using namespace dumbbell::page;
using namespace dumbbell::collisions;

namespace {

SealedText initial_text() {
    dumbbell::starts::Certificate certificate{{"dumbbell", "0.1.0"}, {}, 53, {{}}};
    certificate.box.lo = certificate.box.hi = {0, 1, 3, -1, 10};
    return render(certificate);
}

SealedText adiabatic_text() {
    adiabatic::Certificate certificate;
    certificate.generator = {"dumbbell", "0.1.0"};
    certificate.hypotheses.claim = adiabatic::Claim::scattering;
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

}  // namespace

TEST_CASE("a certificate of each claim kind is read as what it is") {
    CHECK(std::holds_alternative<Certificate>(
        with_file(render(every_kind_of_line()).text, read_any_certificate)));
    CHECK(std::holds_alternative<dumbbell::starts::Certificate>(
        with_file(initial_text().text, read_any_certificate)));
    CHECK(std::holds_alternative<adiabatic::Certificate>(
        with_file(adiabatic_text().text, read_any_certificate)));
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

TEST_CASE("a certificate that cannot be read is not called something else") {
    const TemporaryFolder folder;
    write_file(folder / "file.dbc", initial_text().text);
    ::chmod((folder / "file.dbc").c_str(), 0);
    ::chmod(folder.path().c_str(), 0755);
    const NotRoot user;
    const std::string why = "cannot read '" + (folder / "file.dbc") + "': Permission denied";
    CHECK_THROWS_WITH(read_any_certificate(folder / "file.dbc"), why);
}
