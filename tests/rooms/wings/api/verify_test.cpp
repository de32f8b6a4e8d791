#include "dumbbell/verify.hpp"

#include <chrono>
#include <fstream>
#include <stdexcept>

#include "catch.hpp"
#include "dumbbell/certify.hpp"
#include "dumbbell/starts.hpp"
#include "temporary_folder.hpp"

using namespace dumbbell::api;
using dumbbell_test::TemporaryFolder;

namespace {
const std::string ten = DUMBBELL_CERTIFICATES "/q-10.dbc";
/// Of another kind than a claim is by default.
std::string starts_certificate() {
    return certify_starts(MassRatio("10"), {"1/3", "1", "3", "-1/2"}, {.boxes = 10}).certificate;
}
}  // namespace

TEST_CASE("What the prover proves, the verifier verifies") {
    const TemporaryFolder folder;
    const Proof proof = certify(MassRatio("9/2:12"));
    save(proof, folder / "stairs.dbc");
    const Verification result = verify(folder / "stairs.dbc", {.ratio = "9/2:12", .most = 5, .least = 3}, 2);
    CHECK(result.verdict == Verdict::verified);
    CHECK(result);
    CHECK(result.sha256 == proof.sha256);
    CHECK_THAT(
        result.text,
        Contains("ratio=9/2:12/1 upper=5 lower=3 ") && Contains("sha256=" + proof.sha256) &&
            EndsWith(" demanded-ratio=9/2:12/1 max=5 min=3 demanded-claim=collisions not-demanded=gap,gaps"));
}

TEST_CASE("Every other verdict has its name") {
    const TemporaryFolder folder;
    const Claim claim{.ratio = "10", .most = 4};
    CHECK(verify(folder / "none.dbc", claim).verdict == Verdict::unreadable);
    const auto written = [&](const std::string& text) {
        std::ofstream(folder / "file.dbc") << text;
        return folder / "file.dbc";
    };
    const std::string text = dumbbell_test::contents(ten);
    CHECK(verify(written(""), claim).verdict == Verdict::rejected);
    CHECK(verify(ten, {.most = 3}).sha256.empty());
    CHECK(verify(written(text.substr(0, text.size() / 2)), claim).verdict == Verdict::rejected);
    CHECK(verify(written("dumbbell-certificate 2" + text.substr(22)), claim).verdict == Verdict::unsupported);
    CHECK(verify(written(text), claim).verdict == Verdict::verified);
}

TEST_CASE("Without a ratio in the claim the file's own is meant, without a kind its own, too") {
    CHECK(verify(ten, {.most = 4, .least = 4}));
    CHECK(!verify(ten, {.most = 3}));
    const std::string of_starts = starts_certificate();
    CHECK(verify_text(of_starts, {.kind = ""}));
    CHECK(!verify_text(of_starts, {}));
}

TEST_CASE("Without a bound in the claim any will do, and a file without one is open") {
    const TemporaryFolder folder;
    CHECK(verify(ten, {.ratio = "10"}));
    const std::chrono::duration<double> no_time(1e-9);
    save(certify(MassRatio("1:1000000"), {.budget = no_time}), folder / "open.dbc");
    CHECK(verify(folder / "open.dbc", {.ratio = "1:1000000"}).verdict == Verdict::open);
}

TEST_CASE("What cannot be taken is refused, never verified") {
    CHECK_THROWS_AS(verify(ten, {.ratio = "10", .most = 4}, 0), std::invalid_argument);
    CHECK_THROWS_AS(verify(ten + '\0', {.ratio = "10", .most = 4}), std::invalid_argument);
}

TEST_CASE("A text in memory is verified as a file is, plain or compressed") {
    const TemporaryFolder folder;
    const Proof proof = certify(MassRatio("10"));
    const Claim claim{.ratio = "10", .most = 4, .least = 4};
    save(proof, folder / "ten.dbc.gz");
    for (const std::string& text : {proof.certificate, dumbbell_test::contents(folder / "ten.dbc.gz")}) {
        const Verification result = verify_text(text, claim);
        CHECK(result);
        CHECK(result.text == verify(ten, claim).text);
    }
    CHECK(verify_text("", claim).verdict == Verdict::rejected);
    CHECK(verify_text(proof.certificate, {.ratio = "10", .most = 3}).verdict == Verdict::rejected);
}

TEST_CASE("What the members of a claim say may be said in the words of the program, once") {
    const std::string coin = DUMBBELL_CERTIFICATES "/coin.dbc";
    CHECK(verify(coin, {.least = 3, .demand = "--rho=1 --inertia 4"}));
    CHECK(!verify(coin, {.ratio = "4", .most = 4}));
    CHECK(verify_text(starts_certificate(), {.demand = "--claim initial-conditions"}));
    for (const Claim& claim :
         {Claim{.most = 4, .demand = "--max 4"}, Claim{.kind = "collisions", .demand = "--claim law"},
          Claim{.demand = "--gap 1e-6 --jobs 2"}, Claim{.demand = "ten"}, Claim{.demand = "--gap"},
          Claim{.ratio = "10", .demand = "--help"}, Claim{.ratio = "10", .kind = "law"}}) {
        CHECK_THROWS_AS(verify(ten, claim), std::invalid_argument);
    }
}

TEST_CASE("All that a proof says can be demanded of it, and no weaker file has it") {
    const Proof stairs = certify(MassRatio("4:5")), wide = certify(MassRatio("4:5"), {.gap = "1e-3"});
    CHECK(stairs.demand == "--ratio 4:5 --max 4 --min 3 --gap 9.35e-7 --gaps 1");
    CHECK(read_proof(stairs.certificate).demand == stairs.demand);
    CHECK(verify_text(stairs.certificate, {.demand = stairs.demand}));
    CHECK(verify_text(wide.certificate, {.demand = wide.demand}));
    CHECK(!verify_text(wide.certificate, {.demand = stairs.demand}));
    CHECK_THAT(certify(MassRatio("10"), {.section = Section::full}).demand, EndsWith("--heavy-at-most 1"));
}

TEST_CASE("Who has enough verifies nothing") {
    const Verification result = verify(ten, {.ratio = "10"}, 1, "30s", [] { return true; });
    CHECK(result.verdict == Verdict::limit);
    CHECK_THAT(result.text, Contains("stopped"));
}
