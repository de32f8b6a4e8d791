#include "mutations.hpp"

namespace dumbbell_mutation {

void line_mutations(const std::string& text, const Sink& sink) {
    const Lines lines = lines_of(text);
    const auto give = [&](std::string_view kind, std::size_t i, const Lines& changed) {
        sink({kind, "line " + std::to_string(i + 1) + ": " + lines[i], text_of(changed)});
    };
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const auto at = static_cast<std::ptrdiff_t>(i);
        Lines changed = lines;
        changed.erase(changed.begin() + at);
        give("line deleted", i, changed);
        changed = lines;
        changed.insert(changed.begin() + at, lines[i]);
        give("line doubled", i, changed);
        for (const std::size_t distance : {1UL, 2UL, 3UL}) {
            if (i + distance >= lines.size() || lines[i] == lines[i + distance]) continue;
            changed = lines;
            std::swap(changed[i], changed[i + distance]);
            give("lines exchanged", i, changed);
        }
        changed = lines;
        for (const auto& [before, behind] :
             {std::pair("", " "), {" ", ""}, {"", "\r"}, {"", "\t"}, {"", "\n"}, {"\n", ""}}) {
            changed[i] = before + lines[i] + behind;
            give("line with spaces", i, changed);
        }
        changed[i] = lines[i] + std::string(5000, '0');
        give("line too long", i, changed);
    }
}

}  // namespace dumbbell_mutation
