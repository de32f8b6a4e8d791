#include "verify/program/claim_list.hpp"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <sstream>

#include "verify/input/foreign.hpp"
#include "verify/input/input_file.hpp"
#include "verify/program/claim_options.hpp"

namespace dumbbell_verify {
namespace {

constexpr std::size_t most_bytes = 1 << 24;

std::string contents(const std::string& path) {
    InputFile file(path);
    std::string text, block(1 << 16, '\0');
    while (const std::size_t n = file.read(block)) {
        text.append(block, 0, n);
        if (text.size() > most_bytes) throw std::invalid_argument("a list of claims has at most 16 MiB");
    }
    return text;
}

std::vector<std::string> split(const std::string& text, char separator) {
    std::vector<std::string> parts;
    std::istringstream in(text);
    for (std::string part; std::getline(in, part, separator);) parts.push_back(part);
    return parts;
}

/// The folder of a list that has one: a pipe has none, nor has a file that is named as an open one, below
/// /proc, to where /dev/stdin leads.
std::filesystem::path folder_of(const std::filesystem::path& list) {
    constexpr int most_links = 40;  // they may lead in a circle
    std::error_code none;
    std::filesystem::path at = std::filesystem::absolute(list);
    for (int i = 0; i < most_links; ++i) {
        if (std::filesystem::canonical(at.parent_path(), none).string().starts_with("/proc/")) return "";
        if (!std::filesystem::is_symlink(at, none)) break;
        at = at.parent_path() / std::filesystem::read_symlink(at, none);
    }
    return std::filesystem::is_regular_file(list, none) ? list.parent_path() : "";
}

/// Behind blanks, quotes and the like.
bool begins_with_option(std::string_view remark) {
    const auto begins = [](unsigned char c) { return c == '-' || (c < 0x80 && std::isalnum(c) != 0); };
    return std::string_view(std::find_if(remark.begin(), remark.end(), begins), remark.end())
        .starts_with("--");
}

Job parse_row(const std::string& row, const std::filesystem::path& folder, Request settings) {
    const auto fields = split(row, '\t');
    if (fields.size() < 2 || fields[0].empty())
        throw std::invalid_argument(
            "needs a certificate, a tab and its claim, FILE<tab>--ratio 10 --max 4, not `" +
            row.substr(0, 60) + "`");
    if (fields[0].find('\0') != std::string::npos) throw std::invalid_argument("a name with a zero byte");
    Arguments given(split(fields[1], ' '));
    ClaimWords words;
    while (given.next())
        if (!claim_option(given, words))
            throw std::invalid_argument("`" + given.word.substr(0, 60) + "` states no claim; see --help");
    state_claim(words, settings);
    for (std::size_t i = 2; i < fields.size(); ++i)
        if (begins_with_option(fields[i]))
            throw std::invalid_argument("a demand behind the second tab, where remarks are: put it before");
    const Collisions& demand = settings.demand;
    const auto& numbers = settings.numbers;
    const auto decided = numbers.find("decided");
    const bool is_bound = demand.most || (demand.least && *demand.least > 0) ||
                          (decided != numbers.end() && decided->second.first > 0);
    const bool is_whole = settings.claim.starts_with("adiabatic-")
                              ? numbers.contains("delta") && numbers.contains("constant")
                              : demand.ratios && is_bound;
    if (settings.claim != "law" && !is_whole)
        throw std::invalid_argument(
            "the claim needs --ratio or a body, and --max, --min, --exactly or --decided; or it is --claim "
            "law, or "
            "--claim adiabatic-... with --delta and --constant");
    return {fields[0] == "-" ? "-" : (folder / fields[0]).string(), std::move(settings)};
}

}  // namespace

std::vector<Job> read_claims(const std::string& path, const Request& settings) {
    std::vector<Job> jobs;
    std::string where = path;
    try {
        std::size_t line = 0;
        const std::filesystem::path folder = folder_of(path);
        for (const std::string& row : split(contents(path), '\n')) {
            where = path + ":" + std::to_string(++line);
            if (const std::string named = foreign_text(row, line == 1); !named.empty())
                throw std::invalid_argument(named);
            if (!row.empty() && row[0] != '#') jobs.push_back(parse_row(row, folder, settings));
        }
        where = path;
        if (jobs.empty()) throw std::invalid_argument("no claim in this list");
    } catch (const std::invalid_argument& error) {
        throw std::invalid_argument(where + ": " + error.what());
    }
    return jobs;
}

}  // namespace dumbbell_verify
