#include "file/lines.hpp"

#include <fmt/core.h>

#include "base/error.hpp"
#include "base/fields.hpp"
#include "file/dyadic.hpp"

namespace dumbbell {
namespace {

/// What another system has done to a line, and how to mend it; empty: nothing that has a name.
std::string_view foreign(std::string_view line, bool is_first) {
    if (is_first && (line.starts_with("\xff\xfe") || line.starts_with("\xfe\xff"))) {
        return "is UTF-16: mend it with iconv -f UTF-16 -t ASCII <OLD >NEW";
    }
    if (is_first && line.starts_with("\xef\xbb\xbf")) {
        return "begins with a byte-order mark of UTF-8: mend it with tail -c +4 <OLD >NEW";
    }
    return line.ends_with("\r\n") ? "has line ends of Windows (CR LF): mend it with tr -d '\\r' <OLD >NEW"
                                  : "";
}

}  // namespace

Lines::Lines(const NamedFile& file) : path_(file.path), text_(file) {}

bool Lines::read(std::string& line) {
    ++number_;
    line = text_.next_line();
    if (const auto named = foreign(line, number_ == 1); !named.empty()) {
        throw InputError(fmt::format("'{}' {}", path_, named));
    }
    return line.ends_with('\n') && line.find('\0') == std::string::npos;
}

const std::vector<std::string>& Lines::next() {
    std::string line;
    if (!read(line)) {
        fail();
    }
    digest_.add(line);
    line.pop_back();
    const auto parts = split(line, ' ');
    fields_.assign(parts.begin(), parts.end());
    return fields_;
}

const std::vector<std::string>& Lines::expect(std::string_view keyword, std::size_t count) {
    next();
    if (fields_.size() != count || fields_[0] != keyword) {
        fail();
    }
    return fields_;
}

Head Lines::expect_head() {
    if (expect("dumbbell-certificate", 2)[1] != "1") {
        fail();
    }
    Head head;
    const auto& words = expect("generator", 3);
    head.generator = {words[1], words[2]};
    head.lemmas = expect("lemmas", 2)[1];
    head.scene = expect("scene", 2)[1];
    head.section = expect("section", 2)[1];
    head.claim = expect("claim", 2)[1];
    return head;
}

std::string Lines::digest() {
    constexpr std::string_view seal = "sha256 ";
    for (std::string line; read(line); digest_.add(line)) {
        if (line.starts_with(seal)) {
            std::string hex = digest_.hex();
            const bool is_right = line.substr(seal.size()) == hex + '\n';
            return is_right && text_.next_line().empty() ? hex : "";
        }
    }
    return "";
}

void Lines::fail() const {
    throw InputError(
        fmt::format("'{}' is not a certificate that this program can read (line {})", path_, number_));
}

long Lines::number(const std::string& text) const {
    const auto value = number_of<long>(text);
    if (!value || *value < 0) {
        fail();
    }
    return *value;
}

Count Lines::count(const std::string& text) const {
    if (text.empty() || text.find_first_not_of("0123456789") != std::string::npos) {
        fail();
    }
    return Count(Integer(text));
}

Rational Lines::ratio(const std::string& text) const {
    try {
        return parse_rational(text, UnpackedText::longest_line);
    } catch (const InputError&) {
        fail();
    }
}

Rational Lines::signed_ratio(const std::string& text) const {
    return text.starts_with('-') ? Rational(-ratio(text.substr(1))) : ratio(text);
}

Rational Lines::dyadic(const std::string& text) const {
    const std::size_t b = text.find('b');
    if (b == std::string::npos) {
        fail();
    }
    const bool negative = text.compare(b + 1, 1, "-") == 0;
    const long exponent = number(text.substr(b + (negative ? 2 : 1)));
    if (exponent > most_binary_places) {
        fail();
    }
    const Rational power(Integer(1) << static_cast<unsigned>(exponent));
    const std::string digits = text.substr(0, b);
    if (digits.find_first_not_of("0123456789") != std::string::npos) {
        fail();  // a fraction or a decimal would not be dyadic
    }
    const Rational mantissa = ratio(digits);
    return negative ? mantissa / power : mantissa * power;
}

}  // namespace dumbbell
