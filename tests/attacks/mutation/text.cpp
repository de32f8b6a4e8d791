#include "text.hpp"

#include <algorithm>
#include <cstdint>
#include <optional>

#include "rooms/verify/wings/starts/make_file.hpp"

namespace dumbbell_mutation {
namespace {

bool is_trailer(std::string_view line) { return line.starts_with("total ") || line.starts_with("sha256 "); }

/// The number at a word's beginning; 0 if there is none.
std::uint64_t number(const std::string& word) {
    std::uint64_t value = 0;
    for (const char c : word) {
        if (c < '0' || c > '9' || value > UINT64_MAX / 16) break;
        value = 10 * value + static_cast<std::uint64_t>(c - '0');
    }
    return value;
}

std::optional<std::size_t> bounds_line(const Lines& lines) {
    for (std::size_t i = 0; i < lines.size(); ++i)
        if (lines[i].starts_with("between ")) return i;
    return std::nullopt;
}

/// The header's line `between` that the leaves after it imply.
std::string implied_bounds(const Lines& lines, std::size_t header) {
    std::uint64_t least = UINT64_MAX, most = 0;
    for (std::size_t i = header + 1; i < lines.size() && !is_trailer(lines[i]); ++i) {
        const Words words = words_of(lines[i]);
        if (words[0] == "open") return "between 0 none";
        const bool between = words[0] == "between";
        if (words.size() < (between ? 3 : 2) || (!between && words[0] != "exactly")) continue;
        least = std::min(least, number(words[1]));
        most = std::max(most, number(words[between ? 2 : 1]));
    }
    return "between " + std::to_string(least) + " " + std::to_string(most);
}

/// Does a tree about the adiabatic invariant begin after line i?
bool before_adiabatic_tree(const Lines& lines, std::size_t i) {
    const auto next_is = [&](std::string_view word) {
        return i + 1 < lines.size() && lines[i + 1].starts_with(word);
    };
    const std::string& line = lines[i];
    const bool header = line.starts_with("bound ") && line.find('/') != std::string::npos;
    return line == "end" || (line.starts_with("cell ") && !next_is("cell ")) ||
           (header && !next_is("classes "));
}

/// The end of the subtree that begins at line i; 0 if it is not complete. Depth first, without recursion.
std::size_t subtree_end(const Lines& lines, std::size_t i) {
    for (long missing = 1; missing > 0; ++i) {
        if (i >= lines.size() || is_trailer(lines[i])) return 0;
        missing += lines[i].starts_with("split ") ? 1 : -1;
    }
    return i;
}

}  // namespace

Lines lines_of(std::string_view text) {
    Lines lines;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        lines.emplace_back(text.substr(0, end));
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return lines;
}

std::string text_of(const Lines& lines) {
    std::string text;
    for (const std::string& line : lines) text += line + '\n';
    return text;
}

Words words_of(std::string_view line) {
    Words words;
    for (std::size_t begin = 0; begin <= line.size();) {
        const std::size_t end = std::min(line.find(' ', begin), line.size());
        words.emplace_back(line.substr(begin, end - begin));
        begin = end + 1;
    }
    return words;
}

std::string line_of(const Words& words) {
    std::string line;
    for (const std::string& word : words) (line += &word == words.data() ? "" : " ") += word;
    return line;
}

bool is_initial(const Lines& lines) {
    return std::any_of(lines.begin(), lines.end(), [](const std::string& line) {
        return line == "claim initial-conditions" || line == "claim incoming";
    });
}

bool is_adiabatic(const Lines& lines) {
    return std::any_of(lines.begin(), lines.end(),
                       [](const std::string& line) { return line.starts_with("claim adiabatic-"); });
}

std::string body_of(const std::string& text) {
    Lines lines = lines_of(text);
    lines.erase(std::find_if(lines.begin(), lines.end(), is_trailer), lines.end());
    return text_of(lines);
}

std::string closed(const std::string& text) {
    Lines lines = lines_of(body_of(text));
    const auto header = is_initial(lines) ? bounds_line(lines) : std::nullopt;
    if (header) lines[*header] = implied_bounds(lines, *header);
    return make::closed(text_of(lines));
}

std::string hashed(const std::string& text) {
    Lines lines = lines_of(text);
    const auto is_hash = [](const std::string& line) { return line.starts_with("sha256 "); };
    lines.erase(std::find_if(lines.begin(), lines.end(), is_hash), lines.end());
    return make::hashed(text_of(lines));
}

std::vector<TreeNode> nodes_of(const Lines& lines) {
    std::vector<TreeNode> nodes;
    const auto header = is_initial(lines) ? bounds_line(lines) : std::nullopt;
    const bool adiabatic = is_adiabatic(lines);
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const bool before_tree = header      ? i == header
                                 : adiabatic ? before_adiabatic_tree(lines, i)
                                             : lines[i].starts_with("chart ");
        const std::size_t end = before_tree ? subtree_end(lines, i + 1) : 0;
        for (std::size_t at = i + 1; at < end; ++at) {
            const bool split = lines[at].starts_with("split ");
            nodes.push_back({at, subtree_end(lines, at), split ? subtree_end(lines, at + 1) : 0, i + 1});
        }
    }
    return nodes;
}

}  // namespace dumbbell_mutation
