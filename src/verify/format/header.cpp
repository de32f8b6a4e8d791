#include "verify/format/header.hpp"

#include <algorithm>

namespace dumbbell_verify {
namespace {

/// A line with one value: a word, or a number (or either). The file is unsupported unless `is_known`.
template <class Predicate>
std::string known(Text& text, const std::string& keyword, bool number, bool word, Predicate is_known) {
    text.expect(keyword, 1);
    const char first = text.fields[1][0];
    const bool digit = number && (!word || (first >= '0' && first <= '9'));
    const std::string found = digit ? std::to_string(text.natural(1)) : text.word(1);
    if (!is_known(found)) text.unsupported("unknown " + keyword + " " + found);
    return found;
}

/// The section that the lines `lemmas`, `scene` and `section` choose; nullptr: none.
const Section* read_section(Text& text) {
    const auto table = sections();
    const auto in = [&](std::string_view Section::*column) {
        return [&table, column](const std::string& word) {
            return std::any_of(table.begin(), table.end(),
                               [&](const Section* s) { return s->*column == word; });
        };
    };
    const std::string lemmas = known(text, "lemmas", true, true, in(&Section::lemmas));
    const std::string scene = known(text, "scene", false, true, in(&Section::scene));
    const auto is_section = in(&Section::name);
    const std::string name = known(text, "section", false, true, [&](const std::string& word) {
        return word == "none" || is_section(word);
    });
    if (lemmas == "1" && scene == "dumbbell" && name == "none") return nullptr;
    const auto found = std::find_if(table.begin(), table.end(), [&](const Section* s) {
        return s->lemmas == lemmas && s->scene == scene && s->name == name;
    });
    if (found == table.end())
        text.unsupported("no section " + name + " of the scene " + scene + " with lemmas " + lemmas);
    return *found;
}

}  // namespace

Header read_header(Text& text) {
    known(text, "dumbbell-certificate", true, false,
          [](const std::string& version) { return version == "1"; });
    text.expect("generator", 2);
    text.require_word(1);
    text.require_word(2, true);
    const Section* section = read_section(text);
    text.expect("claim", 1);
    return {section, text.word(1)};
}

}  // namespace dumbbell_verify
