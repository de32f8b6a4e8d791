#include "dumbbell/certify.hpp"

#include "catch.hpp"
#include "dumbbell/error.hpp"
#include "temporary_folder.hpp"

using namespace dumbbell::api;
using dumbbell_test::contents;
using dumbbell_test::TemporaryFolder;

TEST_CASE("One ratio: the maximum, and the certificate that the program ships") {
    const Proof proof = certify(MassRatio("10"));
    REQUIRE(proof.pieces.size() == 1);
    CHECK(proof.complete());
    CHECK(proof.pieces[0].lo == "10/1");
    CHECK(proof.pieces[0].hi == "10/1");
    CHECK(proof.pieces[0].least == 4);
    CHECK(proof.pieces[0].most == 4);
    CHECK(proof.certificate == contents(DUMBBELL_CERTIFICATES "/q-10.dbc"));
    CHECK_THAT(proof.certificate, EndsWith("sha256 " + proof.sha256 + "\n"));
}

TEST_CASE("A range: pieces that follow one another, whatever the number of threads") {
    const Proof proof = certify(MassRatio("1:100"), {.jobs = 2});
    CHECK(proof.certificate == contents(DUMBBELL_CERTIFICATES "/stairs-1-100.dbc"));
    CHECK(proof.complete());
    CHECK((proof.least() == 2 && proof.most() == 10));
    REQUIRE(!proof.pieces.empty());
    CHECK(proof.pieces.front().lo == "1/1");
    CHECK(proof.pieces.back().hi == "100/1");
    for (std::size_t i = 1; i < proof.pieces.size(); ++i) {
        CHECK(proof.pieces[i].lo == proof.pieces[i - 1].hi);
    }
    for (const Piece& piece : proof.pieces) {
        CHECK((*piece.most == piece.least || *piece.most == piece.least + 1));
    }
}

TEST_CASE("Without time, and beyond what is tried, the piece is open and claims nothing") {
    const Proof proof = certify(MassRatio("10"), {.budget = std::chrono::seconds(0)});
    CHECK(!proof.complete());
    CHECK(!proof.pieces.at(0).most);
    CHECK(!certify(MassRatio("1e1000")).complete());
}

TEST_CASE("A certificate is saved, plain or compressed, or the reason is said") {
    const TemporaryFolder folder;
    const Proof proof = certify(MassRatio("10"));
    save(proof, folder / "ten.dbc");
    CHECK(contents(folder / "ten.dbc") == proof.certificate);
    save(proof, folder / "ten.dbc.gz");
    CHECK(contents(folder / "ten.dbc.gz").starts_with("\x1f\x8b"));
    CHECK_THROWS_AS(save(proof, ""), InputError);
    CHECK_THROWS_AS(save(proof, folder / "none/ten.dbc"), InputError);
}

TEST_CASE("Many ratios: each has the proof that it has alone") {
    const std::vector<MassRatio> ratios{MassRatio("10"), MassRatio("9/2:12"), MassRatio("1e6")};
    for (const int jobs : {1, 3}) {
        const auto proofs = certify_many(ratios, {.jobs = jobs});
        REQUIRE(proofs.size() == ratios.size());
        for (std::size_t i = 0; i < ratios.size(); ++i) {
            CHECK(proofs[i].certificate == certify(ratios[i]).certificate);
        }
    }
    CHECK(certify_many({}).empty());
    CHECK_THROWS_AS(certify_many(ratios, {.jobs = 0}), InputError);
}

TEST_CASE("A proof says which system it is about, again when it is read") {
    for (const Proof& coin :
         {certify(Body{"1", "4"}), read_proof(contents(DUMBBELL_CERTIFICATES "/coin.dbc"))}) {
        CHECK((coin.scene == Scene::body && coin.rho == "1/1" && coin.demand == "--coin --exactly 4"));
    }
    CHECK(certify(MassRatio("9")).scene == Scene::dumbbell);
}

TEST_CASE("What is no system is refused") {
    for (const Body& body :
         {Body{"2", "3"}, Body{"", "4"}, Body{"1", "5:4"}, Body{"1", "1." + std::string(2100, '7')}}) {
        CHECK_THROWS_AS(certify(body), InputError);
    }
    CHECK_THROWS_AS(certify(Body{"1", "4"}, {.section = Section::full}), InputError);
}

TEST_CASE("Who has enough gets what is decided, and nobody else is stopped") {
    int asked = 0;
    const auto stopped = [&] { return ++asked > 0; };
    CHECK(!certify(MassRatio("1:1000000"), {.stopped = stopped}).complete());
    CHECK(asked > 0);
    CHECK(certify(MassRatio("1:20")).complete());
    CHECK(!certify_many(std::vector{MassRatio("10"), MassRatio("20")}, {.stopped = stopped})[1].complete());
}

TEST_CASE("Options out of range are refused") {
    const MassRatio ten("10");
    for (const char* gap : {"0", "-1", "0.011", "", "nan"}) {
        CHECK_THROWS_AS(certify(ten, {.gap = gap}), InputError);
    }
    for (const int jobs : {0, -1, 1025}) {
        CHECK_THROWS_AS(certify(ten, {.jobs = jobs}), InputError);
    }
}
