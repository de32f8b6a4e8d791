#include <gmpxx.h>

#include <algorithm>
#include <optional>

#include "mutations.hpp"

namespace dumbbell_mutation {
namespace {

struct Change {
    std::string_view kind;
    std::string word;
};
using Changes = std::vector<Change>;

bool is_digits(std::string_view text) {
    return !text.empty() && text.find_first_not_of("0123456789") == std::string_view::npos;
}

Changes of_natural(const std::string& word) {
    const mpz_class n(word);
    return {{"+1", mpz_class(n + 1).get_str()},
            {"-1", mpz_class(n - 1).get_str()},
            {"negated", "-" + word},
            {"zero", "0"},
            {"huge", "999999999999999999"},
            {"huge", "18446744073709551617"},
            {"spelling", "0" + word},
            {"spelling", "+" + word},
            {"spelling", word + ".0"},
            {"other class", word + "/1"},
            {"other class", "nan"}};
}

/// In lowest terms if the denominator is not 0.
std::string fraction(const mpz_class& p, const mpz_class& q) {
    if (q == 0) return p.get_str() + "/0";
    mpq_class x(p, q);
    x.canonicalize();
    return x.get_num().get_str() + "/" + x.get_den().get_str();
}

Changes of_ratio(const std::string& word) {
    const bool negative = word[0] == '-';
    const std::size_t slash = word.find('/');
    const mpz_class p(word.substr(0, slash)), q(word.substr(slash + 1));
    mpz_class fine;
    mpz_ui_pow_ui(fine.get_mpz_t(), 10, 15);
    return {{"+1", fraction(p + 1, q)},
            {"+1", fraction(p, q + 1)},
            {"+1", fraction(p + q, q)},
            {"-1", fraction(p - 1, q)},
            {"-1", fraction(p, q - 1)},
            {"-1", fraction(p - q, q)},
            {"nearly the same", fraction(p * fine + q, q * fine)},
            {"nearly the same", fraction(p * fine - q, q * fine)},
            {"negated", negative ? word.substr(1) : "-" + word},
            {"negated", mpz_class(p).get_str() + "/-" + q.get_str()},
            {"zero", "0/1"},
            {"zero", p.get_str() + "/0"},
            {"huge", word.substr(0, slash) + std::string(30, '0') + "/1"},
            {"huge", "1/" + q.get_str() + std::string(2200, '0')},
            {"inverted", negative || p == 0 ? "1/0" : fraction(q, p)},
            {"spelling", mpz_class(2 * p).get_str() + "/" + mpz_class(2 * q).get_str()},
            {"spelling", p.get_str()},
            {"spelling", "0" + word},
            {"other class", p.get_str() + "b0"}};
}

/// MbK in its canonical spelling.
std::string dyadic(mpz_class m, long k) {
    if (m == 0) return "0b0";
    for (; mpz_even_p(m.get_mpz_t()); ++k) m /= 2;
    return m.get_str() + "b" + std::to_string(k);
}

Changes of_dyadic(const std::string& word) {
    const std::size_t b = word.find('b');
    const mpz_class m(word.substr(0, b));
    const long k = std::stol(word.substr(b + 1));
    const mpz_class fine = m << 60;
    Changes changes = {{"+1", dyadic(m + 1, k)},
                       {"-1", m > 0 ? dyadic(m - 1, k) : "-1b0"},
                       {"+1", dyadic(m, k + 1)},
                       {"-1", dyadic(m, k - 1)},
                       {"nearly the same", dyadic(fine + 1, k - 60)},
                       {"nearly the same", m > 0 ? dyadic(fine - 1, k - 60) : "1b-400"},
                       {"negated", "-" + word},
                       {"zero", "0b0"},
                       {"huge", m.get_str() + "b400"},
                       {"huge", m.get_str() + "b-400"},
                       {"huge", m.get_str() + "b401"},
                       {"huge", std::string(126, '9') + "b" + std::to_string(k)},
                       {"spelling", mpz_class(2 * m).get_str() + "b" + std::to_string(k - 1)},
                       {"spelling", m.get_str() + "b+" + std::to_string(k)},
                       {"other class", m.get_str() + "/1"}};
    for (const int bits : {8, 20, 40}) {  // the value moved by a 256th, a millionth, ...
        changes.push_back({"moved", dyadic((m << bits) + m, k - bits)});
        changes.push_back({"moved", dyadic((m << bits) - m, k - bits)});
    }
    return changes;
}

/// The words of the format that may stand in the same place.
constexpr std::string_view classes[][12] = {
    {"dumbbell", "body", "none"},
    {"turning", "full", "none", "perpendicular"},
    {"collisions", "initial-conditions", "incoming", "heavy-collisions", "adiabatic-bounce", "adiabatic-run",
     "adiabatic-scattering"},
    {"bridge", "light", "contact", "departure", "again"},
    {"e", "eta", "lambda", "t", "q", "rho", "phi", "phidot", "y", "ydot", "s"},
    {"u", "s", "v", "delta", "sigma", "q"},
    {"bound", "outside", "split", "attained", "cell", "end"},
    {"light", "heavy"},
    {"count", "outside", "meets", "meets-reversed", "once", "exactly", "between", "open", "equal-masses",
     "split", "witness", "orbits"},
    {"1", "minimal", "2"},
    {"none", "0", "1"}};

Changes of_word(const std::string& word) {
    Changes changes = {{"spelling", word + "x"}, {"zero", "0"}};
    for (const auto& group : classes) {
        if (std::find(std::begin(group), std::end(group), word) == std::end(group)) continue;
        for (const std::string_view other : group)
            if (!other.empty() && other != word) changes.push_back({"other word", std::string(other)});
    }
    if (word[0] >= 'a' && word[0] <= 'z')
        changes.push_back({"spelling", static_cast<char>(word[0] - 'a' + 'A') + word.substr(1)});
    return changes;
}

Changes of_any(const std::string& word) {
    const std::string digits = word.substr(word.starts_with('-') ? 1 : 0);
    const std::size_t mark = digits.find_first_of("/b");
    const bool two = mark != std::string::npos && is_digits(digits.substr(0, mark));
    const std::string rest = two ? digits.substr(mark + 1) : "";
    if (is_digits(word) && word.size() <= 18) return of_natural(word);
    if (two && digits[mark] == '/' && is_digits(rest)) return of_ratio(word);
    if (two && digits[mark] == 'b' && is_digits(rest.substr(rest.starts_with('-') ? 1 : 0)))
        return of_dyadic(word);
    return of_word(word);
}

}  // namespace

std::vector<ChangedLine> changed_lines(const std::string& line) {
    std::vector<ChangedLine> result;
    const Words words = words_of(line);
    for (std::size_t j = 0; j < words.size(); ++j) {
        const auto at = static_cast<std::ptrdiff_t>(j);
        Words changed = words;
        changed.erase(changed.begin() + at);
        result.push_back({"word deleted", line_of(changed)});
        changed = words;
        changed.insert(changed.begin() + at, words[j]);
        result.push_back({"word doubled", line_of(changed)});
        changed = words;
        if (j + 1 < words.size()) {
            std::swap(changed[j], changed[j + 1]);
            result.push_back({"words exchanged", line_of(changed)});
        }
        changed = words;
        for (const Change& change : words[j].empty() ? Changes{} : of_any(words[j])) {
            changed[j] = change.word;
            result.push_back({change.kind, line_of(changed)});
        }
    }
    return result;
}

void word_mutations(const std::string& text, const Sink& sink) {
    Lines lines = lines_of(text);
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const std::string original = lines[i];
        for (const ChangedLine& changed : changed_lines(original)) {
            lines[i] = changed.line;
            sink({changed.kind, "line " + std::to_string(i + 1) + ": " + original + " -> " + lines[i],
                  text_of(lines)});
        }
        lines[i] = original;
    }
}

}  // namespace dumbbell_mutation
