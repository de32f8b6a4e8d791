#include "catch.hpp"
#include "programs.hpp"

using namespace dumbbell_test;

namespace {

// The data that the program put into the page.
nlohmann::json data_of(const std::string& page) {
    const std::string start = "id=\"data\">";
    const std::size_t begin = page.find(start) + start.size();
    return nlohmann::json::parse(page.substr(begin, page.find("</script>", begin) - begin));
}

Outcome report(const TemporaryFolder& folder, Words words) {
    words.insert(words.begin(), "report");
    return dumbbell(words, folder.path());
}

}  // namespace

TEST_CASE("more pieces than a page takes are refused before they are read", "[wings]") {
    const TemporaryFolder folder;
    const std::string few = contents(DUMBBELL_PROJECT "/certificates/stairs-1-100.dbc");
    write_file(folder / "many.dbc", replaced(few, "\npieces 17\n", "\npieces 3000000\n"));
    const Outcome made = report(folder, {"many.dbc", "--out", "page.html"});
    CHECK(made.code == 2);
    CHECK_THAT(made.err, Contains("the files have 3000000 pieces, a page takes 100000"));
    CHECK(folder.names() == Words{"many.dbc"});
}

TEST_CASE("report makes one page from certificates of certify and trace, and says nothing", "[wings]") {
    const TemporaryFolder folder;
    REQUIRE(dumbbell({"certify", "1:10", "--out", "stairs.dbc"}, folder.path()).code == 0);
    REQUIRE(dumbbell({"certify", "10", "--section", "full", "--out", "full.dbc.gz"}, folder.path()).code ==
            0);
    REQUIRE(dumbbell({"certify", "--coin", "--out", "coin.dbc"}, folder.path()).code == 0);
    REQUIRE(dumbbell({"trace", "10", "--phi", "0:1", "--phidot", "0", "--y", "3/2", "--ydot", "-1",
                      "--subdivide", "--max-boxes", "50", "--out", "starts.dbc"},
                     folder.path())
                .code == 0);
    const Outcome made = report(folder, {"stairs.dbc", "full.dbc.gz", "coin.dbc", "starts.dbc",
                                         "--no-verifier", "--out", "page.html"});
    CAPTURE(made.err);
    CHECK(made.code == 0);
    CHECK(made.out.empty());
    CHECK(made.err.empty());
    const std::string page = contents(folder / "page.html");
    CHECK_THAT(page, StartsWith("<!doctype html>") && Contains("</html>"));
    const auto files = data_of(page)["files"];
    REQUIRE(files.size() == 4);
    CHECK(files[0]["claim"] == "collisions");
    CHECK(files[1]["section"] == "full");
    CHECK(files[2]["scene"] == "body");
    CHECK(files[3]["claim"] == "initial-conditions");

    SECTION("and the commands in it are ones with which the verifier verifies these files") {
        for (const auto& file : files) {
            const std::string options = file["verify_options"];
            const std::string name = file["verify_file"];
            const Outcome checked = run(
                {"sh", "-c", std::string(DUMBBELL_BIN) + " verify " + options + " " + name}, folder.path());
            CAPTURE(options, name, checked.out);
            CHECK(checked.code == 0);
            CHECK_THAT(checked.out, Contains("sha256=" + file["sha256"].get<std::string>()));
        }
    }
}

TEST_CASE("a page has the verifier and the file, or report says how to have them", "[wings]") {
    const TemporaryFolder folder;
    // As it is installed, without the verifier and then with what stands for it: ./run web may have made one,
    // or not.
    std::filesystem::create_directories(folder / "bin");
    std::filesystem::create_directories(folder / "share/dumbbell");
    std::filesystem::copy_file(DUMBBELL_BIN, folder / "bin/dumbbell");
    const auto report_ten = [&](const std::string& out, Words options = {}) {
        options.insert(options.begin(), {folder / "bin/dumbbell", "report",
                                         DUMBBELL_PROJECT "/certificates/q-10.dbc", "--out", folder / out});
        const Outcome made = run(options);
        CHECK(made.code == 0);
        return made.err;
    };
    const std::string none = "id=\"verifier\"></script>";
    CHECK(report_ten("page.html") ==
          "dumbbell: Written. The page shows the proof; it does not contain the verifier (./run web adds "
          "it)\n");
    CHECK_THAT(contents(folder / "page.html"), Contains(none) && Contains("\"bytes\":\"\""));
    write_file(folder / "share/dumbbell/verifier.wasm.gz", "verifier");
    CHECK(report_ten("page.html").empty());
    CHECK_THAT(contents(folder / "page.html"), Contains("id=\"verifier\">dmVyaWZpZXI=</script>"));
    const std::string bytes = data_of(contents(folder / "page.html"))["files"][0]["bytes"];
    CHECK_THAT(bytes, StartsWith("ZHVtYmJlbGwtY2VydGlmaWNhdGUgMQ"));  // dumbbell-certificate 1
    CHECK(report_ten("page.html", {"--no-verifier"}).empty());
    CHECK_THAT(contents(folder / "page.html"), Contains(none) && Contains("\"bytes\":\"\""));
}

TEST_CASE("the same certificates give the same page", "[wings]") {
    const TemporaryFolder folder;
    REQUIRE(dumbbell({"certify", "10", "--out", "ten.dbc"}, folder.path()).code == 0);
    REQUIRE(report(folder, {"ten.dbc", "--out", "one.html"}).code == 0);
    REQUIRE(report(folder, {"ten.dbc", "--out", "two.html"}).code == 0);
    CHECK(contents(folder / "one.html") == contents(folder / "two.html"));
}

TEST_CASE("where there are more boxes than asked for, one line says so", "[wings]") {
    const TemporaryFolder folder;
    REQUIRE(dumbbell({"certify", "100", "--section", "full", "--out", "full.dbc"}, folder.path()).code == 0);
    const Outcome made =
        report(folder, {"full.dbc", "--no-verifier", "--max-boxes", "100", "--out", "page.html"});
    CHECK(made.code == 0);
    CHECK(count_lines(made.err) == 1);
    CHECK_THAT(made.err, StartsWith("dumbbell: ") && Contains("--max-boxes"));
    std::size_t drawn = 0;
    const auto data = data_of(contents(folder / "page.html"));
    for (const auto& tree : data["files"][0]["pieces"][0]["trees"]) {
        drawn += tree["stands_for"].size();
    }
    CHECK(drawn <= 100);
}

TEST_CASE("what cannot be read is refused in one line, and an older page stays", "[wings]") {
    const TemporaryFolder folder;
    REQUIRE(dumbbell({"certify", "10", "--out", "ten.dbc"}, folder.path()).code == 0);
    const std::string text = contents(folder / "ten.dbc");
    write_file(folder / "half.dbc", text.substr(0, text.size() / 2));
    write_file(folder / "changed.dbc", replaced(text, "upper 4", "upper 3"));
    write_file(folder / "text.dbc", "Dear reader,\n");
    write_file(folder / "empty.dbc", "");
    REQUIRE(dumbbell({"certify", "10", "--out", "ten.dbc.gz"}, folder.path()).code == 0);
    const std::string packed = contents(folder / "ten.dbc.gz");
    write_file(folder / "tail.dbc", packed + "x\n");
    write_file(folder / "two.dbc", packed + packed);
    write_file(folder / "page.html", "old");
    const auto before = folder.names();
    for (const char* bad :
         {"half.dbc", "changed.dbc", "text.dbc", "empty.dbc", "tail.dbc", "two.dbc", "missing.dbc", "."}) {
        const Outcome refused = report(folder, {"ten.dbc", bad, "--out", "page.html"});
        CAPTURE(bad, refused.err);
        CHECK(refused.code == 2);
        CHECK(refused.out.empty());
        CHECK(count_lines(refused.err) == 1);
        CHECK_THAT(refused.err, StartsWith("dumbbell: ") && Contains(bad));
    }
    CHECK(contents(folder / "page.html") == "old");
    CHECK(folder.names() == before);
}
