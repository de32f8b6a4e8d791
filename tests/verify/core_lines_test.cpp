// What docs/verifying.md gives to read is there, and as long as it says.
#include <algorithm>
#include <catch2/catch.hpp>
#include <fstream>
#include <regex>
#include <sstream>

namespace {

std::string contents(const std::string& path) {
    std::ostringstream text;
    text << std::ifstream(path).rdbuf();
    REQUIRE_FALSE(text.str().empty());
    return text.str();
}

}  // namespace

TEST_CASE("the files that the main claim rests on have as many lines as docs/verifying.md says") {
    const std::string page = contents(DUMBBELL_PROJECT "/docs/verifying.md");
    const std::size_t begin = page.find("## 4. Read the verifier"), table = page.find("| file |", begin);
    const std::string rows = page.substr(table, page.find("\n\n", table) - table);
    static const std::regex link("\\(\\.\\./(src/verify/[a-z]+\\.[ch]pp)\\)");
    std::ptrdiff_t lines = 0;
    for (std::sregex_iterator at(rows.begin(), rows.end(), link), end; at != end; ++at) {
        const std::string text = contents(DUMBBELL_PROJECT "/" + (*at)[1].str());
        lines += std::count(text.begin(), text.end(), '\n');
    }
    std::string figure = std::to_string(lines);
    figure.insert(figure.size() - 3, ",");
    CHECK(page.substr(begin, table - begin).find("are " + figure + " lines") != std::string::npos);
    // Nothing is left out: what these files include of src/verify is among them.
    static const std::regex include("\n#include \"([a-z_]+\\.hpp)\"");
    for (std::sregex_iterator at(rows.begin(), rows.end(), link), end; at != end; ++at) {
        const std::string file = (*at)[1].str(), text = contents(DUMBBELL_PROJECT "/" + file);
        for (std::sregex_iterator other(text.begin(), text.end(), include); other != end; ++other) {
            const std::string name = (*other)[1].str();
            if (name.starts_with("initial") || name.starts_with("adiabatic"))
                continue;  // other claims' readers
            INFO(file << " includes " << name);
            CHECK(rows.find("/" + name + ")") != std::string::npos);
        }
    }
}
