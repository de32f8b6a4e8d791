// Whether a text is well-formed XML of the simple kind that the program writes: elements, attributes in
// double quotes, text with the entities of XML; no comments or declarations.
#pragma once

#include <cctype>
#include <string>
#include <vector>

namespace dumbbell_test {

class XmlScanner {
  public:
    explicit XmlScanner(const std::string& text) : text_(text) {}

    [[nodiscard]] bool well_formed() {
        int roots = 0;
        while (skip_text()) {
            ++at_;  // <
            const bool closes = take('/');
            const std::string name = take_name();
            if (name.empty()) {
                return false;
            }
            if (closes) {
                if (open_.empty() || open_.back() != name || !take('>')) {
                    return false;
                }
                open_.pop_back();
                continue;
            }
            roots += open_.empty() ? 1 : 0;
            if (!take_attributes()) {
                return false;
            }
            const bool is_empty = take('/');
            if (!take('>')) {
                return false;
            }
            if (!is_empty) {
                open_.push_back(name);
            }
        }
        return at_ == text_.size() && open_.empty() && roots == 1;
    }

  private:
    // To the next element; outside the root only white space may be skipped.
    bool skip_text() {
        while (at_ < text_.size() && text_[at_] != '<') {
            if (text_[at_] == '>' || is_stray_ampersand() ||
                (open_.empty() && std::isspace(text_[at_]) == 0)) {
                return false;
            }
            ++at_;
        }
        return at_ < text_.size();
    }

    [[nodiscard]] bool is_stray_ampersand() const {
        if (text_[at_] != '&') {
            return false;
        }
        const std::string rest = text_.substr(at_, 6);
        return !rest.starts_with("&lt;") && !rest.starts_with("&gt;") && !rest.starts_with("&amp;") &&
               !rest.starts_with("&quot;");
    }

    bool take(char c) {
        if (at_ < text_.size() && text_[at_] == c) {
            ++at_;
            return true;
        }
        return false;
    }

    std::string take_name() {
        const std::size_t begin = at_;
        while (at_ < text_.size() &&
               (std::isalnum(text_[at_]) != 0 || text_[at_] == '-' || text_[at_] == ':')) {
            ++at_;
        }
        return text_.substr(begin, at_ - begin);
    }

    bool take_attributes() {
        while (take(' ')) {
            if (take_name().empty() || !take('=') || !take('"')) {
                return false;
            }
            while (at_ < text_.size() && text_[at_] != '"') {
                if (text_[at_] == '<' || is_stray_ampersand()) {
                    return false;
                }
                ++at_;
            }
            if (!take('"')) {
                return false;
            }
        }
        return true;
    }

    const std::string& text_;
    std::size_t at_ = 0;
    std::vector<std::string> open_;
};

/// How often `part` stands in the text.
inline long count_of(const std::string& text, const std::string& part) {
    long n = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + part.size())) {
        ++n;
    }
    return n;
}

inline bool well_formed(const std::string& xml) { return XmlScanner(xml).well_formed(); }

}  // namespace dumbbell_test
