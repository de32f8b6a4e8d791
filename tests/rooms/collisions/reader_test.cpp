#include "collisions/reader.hpp"

#include <zlib.h>

#include "base/error.hpp"
#include "catch.hpp"
#include "collisions/writer.hpp"
#include "example.hpp"
#include "file/atomic_file.hpp"
#include "file/dyadic.hpp"
#include "programs/cli/process.hpp"

using namespace dumbbell_test;
using namespace dumbbell::collisions;

namespace {

const std::string& good() {
    static const std::string text = render(every_kind_of_line()).text;
    return text;
}

Certificate read_text(const std::string& text) {
    const TemporaryFolder folder;
    write_file(folder / "file.dbc", text);
    return read_certificate(folder / "file.dbc");
}

void check_refused(const std::string& text) {
    CAPTURE(text);
    CHECK_THROWS_AS(read_text(text), InputError);
}

std::string changed(const std::string& from, const std::string& to) { return replaced(good(), from, to); }

}  // namespace

TEST_CASE("what was written and read is written the same again") {
    CHECK(render(read_text(good())).text == good());
}

TEST_CASE("a body has one rho: files with a range of it are for the verifiers") {
    Piece piece;
    piece.q_lo = piece.q_hi = 4;
    const std::string text = render({.pieces = {piece}, .system = {Section::plain_body, 1}}).text;
    CHECK(render(read_text(text)).text == text);
    CHECK_THROWS_WITH(read_text(replaced(text, "rho 1/1 1/1", "rho 1/2 1/1")),
                      Contains("only the verifiers"));
}

TEST_CASE("the name of the program, the bits and the coordinates survive") {
    const Certificate read = read_text(good());
    CHECK(read.generator.program == "dumbbell");
    CHECK(read.generator.version == "0.1.0");
    REQUIRE(read.pieces.size() == 3);
    CHECK(read.pieces[0].cover.equal_masses);
    CHECK(read.pieces[1].bits == 128);
    CHECK(read.pieces[1].witness->e == Rational(3, 8));
    CHECK(read.pieces[1].witness->eta == Rational(1, 1024));
    CHECK_FALSE(read.pieces[2].upper.has_value());
    CHECK_FALSE(read.pieces[2].witness.has_value());
}

TEST_CASE("a foreign file is refused") {
    check_refused("");
    check_refused("\n");
    check_refused("<svg></svg>\n");
    check_refused(std::string(100'000, '\0'));
    check_refused(std::string(100'000, 'x'));
}

TEST_CASE("the message names file and line") {
    const TemporaryFolder folder;
    write_file(folder / "bad.dbc", changed("split eta", "splat eta"));
    CHECK_THROWS_WITH(read_certificate(folder / "bad.dbc"), Contains("bad.dbc") && Contains("line 21"));
}

TEST_CASE("truncated before its trailer, at any line or byte, it is refused") {
    const std::size_t body = good().find("total split");
    for (std::size_t length = 0; length < body; ++length) {
        CAPTURE(length);
        REQUIRE_THROWS_AS(read_text(good().substr(0, length)), InputError);
    }
}

TEST_CASE("a line too many or too few is refused") {
    check_refused(changed("lemmas 1\n", ""));
    check_refused(changed("lemmas 1\n", "lemmas 1\nlemmas 1\n"));
    check_refused(changed("chart light\n", ""));
    check_refused(changed("split e\n", ""));
    check_refused(changed("split e\n", "split e\nsplit e\n"));
    check_refused(changed("outside\nchart light", "chart light"));
    check_refused(changed("pieces 3", "pieces 4"));
}

TEST_CASE("the checksum is there only if it is right, and the last line") {
    const std::string hex = good().substr(good().size() - 65, 64);
    CHECK(read_text(good()).sha256 == hex);
    for (const std::string& after : {std::string("x\n"), std::string("x"), std::string("\n"), good()}) {
        CHECK(read_text(good() + after).sha256.empty());
    }
    CHECK(read_text(good().substr(0, good().size() - 1)).sha256.empty());
    CHECK(read_text(changed("total split", "total splits")).sha256.empty());
}

TEST_CASE("malformed fields are refused") {
    for (const auto& [from, to] : std::vector<std::pair<std::string, std::string>>{
             {"dumbbell-certificate 1", "dumbbell-certificate 2"},
             {"dumbbell-certificate 1", "dumbbell-certificate  1"},
             {"ratio 1/1 14/3", "ratio 1/1"},
             {"pieces 3", "pieces 0"},
             {"pieces 3", "pieces three"},
             {"pieces 3", "pieces -3"},
             {"pieces 3", "pieces 99999999999999999999"},
             {"piece 1/1 9/2", "piece 1/1 nine"},
             {"piece 1/1 9/2", "piece 1/1 9/0"},
             {"bits 128", "bits many"},
             {"upper 4", "upper"},
             {"upper 4", "upper 4x"},
             {"count 0 3", "count 0"},
             {"count 0 3", "count 0 -3"},
             {"count 0 3", "count 0 3 0"},
             {"meets-reversed\ncount", "meets-twice\ncount"},
             {"lower 3", "lower 1e1"},
             {"3b-3 1b-10", "3b-3 1x-10"},
             {"3b-3 1b-10", "3b-3 1b"},
             {"3b-3 1b-10", "3b-3 b-10"},
             {"3b-3 1b-10", "3b-3 1b-4097"},
             {"3b-3 1b-10", "3b-3 1b4097"},
             {"3b-3 1b-10", "3b-3 1b-99999999999999999999"},
             {"3b-3 1b-10", "3b-3"}}) {
        check_refused(changed(from, to));
    }
}

TEST_CASE("a coordinate has as many binary places as the format allows") {
    Certificate certificate = every_kind_of_line();
    Witness& witness = *certificate.pieces[1].witness;
    const Integer places = Integer(1) << static_cast<unsigned>(most_binary_places);
    witness.e = Rational(3) / 2 + Rational(Integer(1), places);  // an odd part of 4,097 bits
    witness.eta = Rational(Integer(1), places);
    const TemporaryFolder folder;
    AtomicFile(folder / "file.dbc").commit(render(certificate).text);
    const Certificate read = read_certificate(folder / "file.dbc");
    CHECK(read.pieces[1].witness->e == witness.e);
    CHECK(read.pieces[1].witness->eta == witness.eta);
}
