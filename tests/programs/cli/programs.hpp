// The two built programs, as these tests run them.
#pragma once

#include <nlohmann/json.hpp>
#include <sstream>

#include "catch.hpp"
#include "process.hpp"

namespace dumbbell_test {

using Words = std::vector<std::string>;

// The command as a Process wants it.
inline Words with_program(Words arguments) {
    arguments.insert(arguments.begin(), DUMBBELL_BIN);
    return arguments;
}

inline Outcome dumbbell(Words arguments, const std::string& folder = ".") {
    return run(with_program(std::move(arguments)), folder);
}

inline Outcome verifier(Words arguments, const std::string& folder = ".") {
    arguments.insert(arguments.begin(), DUMBBELL_VERIFY_BIN);
    return run(std::move(arguments), folder);
}

// The one line on stderr of a command that must be refused: exit 2, nothing on stdout, nothing written. Runs
// in an empty folder, which must stay empty.
inline std::string refused(const Words& arguments) {
    const TemporaryFolder folder;
    const Outcome result = dumbbell(arguments, folder.path());
    std::string command;
    for (const std::string& word : arguments) {
        command += " '" + word.substr(0, 60) + "'";
    }
    CAPTURE(command, result.out, result.err);
    CHECK(result.code == 2);
    CHECK(result.out.empty());
    CHECK(count_lines(result.err) == 1);
    CHECK_THAT(result.err, StartsWith("dumbbell: "));
    CHECK(folder.names().empty());
    return result.err;
}

// How many files are in the folder of finished pieces; 0 if there is none yet.
inline std::size_t kept(const std::string& folder) {
    std::error_code ignored;
    return static_cast<std::size_t>(std::distance(std::filesystem::directory_iterator(folder, ignored),
                                                  std::filesystem::directory_iterator()));
}

// Certifies into a file of the folder, which must succeed, and returns the file's path.
inline std::string certificate(const TemporaryFolder& folder, const std::string& ratio, Words options = {}) {
    const std::string path = folder / "certificate-" + std::to_string(folder.names().size()) + ".dbc";
    options.insert(options.begin(), {"certify", ratio, "--out", path});
    const Outcome made = dumbbell(options);
    if (made.code != 0) {
        throw std::runtime_error("certify " + ratio + " failed: " + made.err);
    }
    return path;
}

// Writes a text that ends with a line `sha256 HEX`, made right again after a change above it.
inline void write_sealed(const std::string& path, std::string text) {
    text.erase(text.rfind("sha256 "));
    write_file(path, text);
    write_file(path, text + "sha256 " + run({"sha256sum", path}).out.substr(0, 64) + "\n");
}

inline std::string last_line(const std::string& text) {
    if (text.empty() || text.back() != '\n') {
        throw std::runtime_error("no last line: " + text);
    }
    return lines_of(text).back();
}

// The ratios that the project promises to decide, with the known maximum.
struct Known {
    const char* ratio;
    int maximum;
};
inline const std::vector<Known> known_maxima{{"1", 2},     {"1.0000001", 3}, {"1.1", 3},  {"4.6", 3},
                                             {"4.61", 4},  {"10", 4},        {"12", 5},   {"100", 10},
                                             {"1000", 29}, {"10000", 90},    {"1e6", 887}};

}  // namespace dumbbell_test
