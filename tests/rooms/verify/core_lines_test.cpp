// The trusted core of the main claim is as long as docs/4-verifying.md says.
#include <algorithm>
#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

namespace {

std::string contents(const std::filesystem::path& path) {
    std::ifstream file(path);
    std::string text((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
    INFO(path);
    REQUIRE_FALSE(text.empty());
    return text;
}

}  // namespace

TEST_CASE("the trusted core has as many lines as docs/4-verifying.md says") {
    const std::filesystem::path project = DUMBBELL_PROJECT;
    std::ptrdiff_t lines = 0;
    for (const char* room : {"number", "format", "collisions"}) {
        for (const auto& entry : std::filesystem::directory_iterator(project / "src/verify" / room)) {
            const std::string text = contents(entry.path());
            lines += std::count(text.begin(), text.end(), '\n');
        }
    }
    std::string figure = std::to_string(lines);
    figure.insert(figure.size() - 3, ",");
    INFO(figure);
    CHECK(contents(project / "docs/4-verifying.md").find("are " + figure + " lines") != std::string::npos);
}
