#include "manifest.hpp"

#include <fmt/format.h>
#include <sys/wait.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <memory>
#include <stdexcept>

#include "verify/program/claim_options.hpp"

namespace dumbbell_mutation {
namespace {

std::vector<std::string> split(const std::string& text, char mark) {
    std::vector<std::string> parts(1);
    for (const char c : text)
        if (c == mark)
            parts.emplace_back();
        else
            parts.back() += c;
    return parts;
}

std::string said(const Entry& e) {
    return fmt::format("exit {} line {} code {} `{}`", e.exit, e.line, e.code, e.reason);
}

std::string quoted(const std::string& text) {
    std::string result = "'";
    for (const char c : text) result += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return result + "'";
}

/// The last line of the program's output and its exit code.
std::pair<std::string, int> run(const std::string& command) {
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> pipe(popen(command.c_str(), "r"),
                                                               [](std::FILE*) { return 0; });
    if (!pipe) throw std::runtime_error("cannot run " + command);
    std::string last, line;
    for (int c = std::fgetc(pipe.get()); c != EOF; c = std::fgetc(pipe.get())) {
        line += static_cast<char>(c);
        if (c == '\n') last = std::exchange(line, "");
    }
    const int status = pclose(pipe.get());
    return {last, WIFEXITED(status) ? WEXITSTATUS(status) : 128};
}

/// Is this the verdict line that an entry stands for?
bool fits(const std::string& line, const Entry& e) {
    if (e.exit == 0) return line.find(" " + e.reason + " sha256=") != std::string::npos;
    const std::string place =
        (e.line > 0 ? fmt::format(" line={}", e.line) : "") + (e.exit == 1 ? " code=" + e.code : "") + " ";
    const std::size_t at = line.find(place);
    return at != std::string::npos && line.find(e.reason, at + place.size()) != std::string::npos;
}

std::string through_program(const Entry& e, const std::string& program, const std::string& path) {
    const auto [last, code] = run(quoted(program) + " " + e.options + " " + quoted(path));
    return code == e.exit && fits(last, e) ? "" : fmt::format("exit {} {}", code, last);
}

std::string in_process(const Entry& e, const std::string& path) {
    const Entry found = entry_of(examine(path, settings_of(e.options)));
    const bool reason =
        e.exit == 0 ? found.reason == e.reason : found.reason.find(e.reason) != std::string::npos;
    const bool same = reason && found.exit == e.exit && found.line == e.line && found.code == e.code;
    return same ? "" : said(found) + "\n";
}

}  // namespace

std::vector<Entry> read_manifest(const std::string& path) {
    std::ifstream in(path);
    if (!in) throw std::runtime_error("cannot read " + path);
    std::vector<Entry> entries;
    for (std::string line; std::getline(in, line);) {
        if (line.empty() || line[0] == '#') continue;
        const auto fields = split(line, '\t');
        if (fields.size() != 7) throw std::runtime_error(path + ": not seven fields: " + line);
        entries.push_back({fields[0], fields[1], std::stoi(fields[2]), std::stoul(fields[3]), fields[4],
                           fields[5], fields[6]});
    }
    return entries;
}

std::string manifest_text(const std::vector<Entry>& entries) {
    std::string text = "# file\toptions\texit\tline\tcode\treason\twhy\n";
    for (const Entry& e : entries)
        text += fmt::format("{}\t{}\t{}\t{}\t{}\t{}\t{}\n", e.file, e.options, e.exit, e.line, e.code,
                            e.reason, e.why);
    return text;
}

dumbbell_verify::Request settings_of(const std::string& options) {
    dumbbell_verify::Arguments given(options.empty() ? std::vector<std::string>{} : split(options, ' '));
    dumbbell_verify::ClaimWords words;
    while (given.next())
        if (!claim_option(given, words)) throw std::runtime_error("unknown option " + given.word);
    dumbbell_verify::Request settings;
    state_claim(words, settings);
    return settings;
}

Entry entry_of(const Outcome& outcome) {
    if (outcome.accepted()) return {"", "", 0, 0, "-", claim_without_scene(*outcome.proof), ""};
    return {"", "", exit_code(outcome.verdict), outcome.line, outcome.code, outcome.text, ""};
}

std::string replay(const std::string& manifest, const std::string& program) {
    const auto folder = std::filesystem::path(manifest).parent_path();
    std::string differences;
    for (const Entry& e : read_manifest(manifest)) {
        const std::string path = (folder / e.file).string();
        const std::string other = program.empty() ? in_process(e, path) : through_program(e, program, path);
        if (!other.empty())
            differences += fmt::format("{} {}: expected {}, found {}", e.file, e.options, said(e), other);
    }
    return differences;
}

}  // namespace dumbbell_mutation
