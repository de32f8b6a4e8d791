// The table of commands and options, as `dumbbell generate reference` prints it: what the tests of help, man
// page and bad input take their commands and options from.
#pragma once

#include "programs.hpp"

namespace dumbbell_test {

struct ListedOption {
    std::string spelling;  // --out FILE, or FILE
    std::string meaning;

    [[nodiscard]] bool is_argument() const { return spelling.front() != '-'; }
    // All its names, without its value.
    [[nodiscard]] Words names() const {
        Words all;
        std::istringstream words(spelling);
        for (std::string word; words >> word && word.front() == '-';) {
            all.push_back(word.substr(0, word.find(',')));
        }
        return all;
    }
    // How its value is called; empty: it is a flag.
    [[nodiscard]] std::string value() const {
        const std::size_t end = spelling.rfind(names().back()) + names().back().size();
        return spelling.substr(std::min(spelling.size(), end + 1));
    }
};

struct ListedCommand {
    Words words;  // plot staircase; of the program none
    std::vector<ListedOption> options;
    Words topics;      // that have a help of their own
    std::string text;  // all else that is said of it
};

// Without the escapes of Markdown.
inline std::string unescaped(const std::string& text) {
    std::string result;
    for (std::size_t i = 0; i < text.size(); ++i) {
        i += text[i] == '\\' && i + 1 < text.size() ? 1 : 0;
        result += text[i];
    }
    return result;
}

inline std::vector<ListedCommand> listed_commands() {
    const std::string heading = "## dumbbell", row = "| `";
    std::vector<ListedCommand> commands;
    for (const std::string& line : lines_of(dumbbell({"generate", "reference"}).out)) {
        if (line.rfind(heading, 0) == 0) {
            commands.emplace_back();
            std::istringstream words(line.substr(heading.size()));
            for (std::string word; words >> word;) {
                commands.back().words.push_back(word);
            }
        } else if (line.rfind("### ", 0) == 0) {
            commands.back().topics.push_back(line.substr(line.rfind(' ') + 1));
        } else if (line.rfind(row, 0) == 0) {
            const std::size_t end = line.find("` | ");
            commands.back().options.push_back({unescaped(line.substr(row.size(), end - row.size())),
                                               unescaped(line.substr(end + 4, line.size() - end - 6))});
        } else if (!commands.empty() && !line.empty() && line.front() != '|') {
            commands.back().text += unescaped(line) + "\n";
        }
    }
    return commands;
}

// With one blank between words, wherever lines end.
inline std::string in_one_line(const std::string& text) {
    std::string result;
    std::istringstream words(text);
    for (std::string word; words >> word;) {
        result += (result.empty() ? "" : " ") + word;
    }
    return result;
}

}  // namespace dumbbell_test
