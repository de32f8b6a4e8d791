// The text of a certificate, line by line: SHA-256 and the lexical classes (format.md, section 1).
#pragma once
#include <gmpxx.h>
#include <nettle/sha2.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "verify/core/outside.hpp"

namespace dumbbell_verify {

/// With several files the last one of these counts.
enum class Verdict { verified, unreadable, open, unsupported, limit, rejected };

/// Why a file is not verified; thrown, and reported as it is.
struct Failure {
    Verdict verdict;
    std::uint64_t line;
    std::string code, text;
};

constexpr std::size_t longest_integer = 2100;  ///< digits of one in a file

/// A natural number without leading zero and with at most `most` digits.
inline bool is_natural(std::string_view text, std::size_t most) {
    return !text.empty() && text.size() <= most && (text[0] != '0' || text.size() == 1) &&
           text.find_first_not_of("0123456789") == std::string_view::npos;
}

class Text {
  public:
    Text(Source& source, std::uint64_t units) : budget(units), source_(source) { sha256_init(&hash_); }

    Budget budget;
    std::uint64_t line = 0;                ///< number of the present line
    std::vector<std::string_view> fields;  ///< of the present line: at least one, none of them empty

    [[noreturn]] void reject(std::string code, std::string text) const {
        throw Failure{Verdict::rejected, line, std::move(code), std::move(text)};
    }
    [[noreturn]] void unsupported(std::string text) const {
        throw Failure{Verdict::unsupported, line, "unsupported", std::move(text)};
    }

    /// Reads the next line, which must exist.
    void next() {
        sha256_update(&hash_, line_.size(), reinterpret_cast<const std::uint8_t*>(line_.data()));
        budget.take(line_.size() * units_per_byte, line);
        line_.clear();
        fields.clear();
        ++line;
        while (!line_.ends_with('\n')) {
            if (rest_.empty() && !fill()) reject("truncated", "the text ends too early");
            const std::size_t size =
                1 + std::min({rest_.find('\n'), rest_.size() - 1, most_bytes - line_.size()});
            const auto bad = [](char c) { return (c < 0x20 || c > 0x7e) && c != '\n'; };
            if (std::any_of(rest_.begin(), rest_.begin() + size, bad)) {
                const std::string named = source_.foreign(rest_.substr(0, size), line == 1 && line_.empty());
                named.empty() ? reject("byte", "not printable ASCII") : reject("encoding", named);
            }
            line_ += rest_.substr(0, size);
            rest_.remove_prefix(size);
            if (line_.size() > most_bytes) reject("line", "more than 4096 bytes");
        }
        std::size_t begin = 0;
        do {
            const std::size_t end = std::min(line_.find(' ', begin), line_.size() - 1);
            if (end == begin) reject("line", "empty, or a space too many");
            fields.push_back(std::string_view(line_).substr(begin, end - begin));
            begin = end + 1;
        } while (begin < line_.size());
    }
    /// next(), and the line must be `keyword` with n values.
    void expect(std::string_view keyword, std::size_t n) {
        next();
        if (fields[0] != keyword || fields.size() != n + 1)
            reject("syntax",
                   "expected `" + std::string(keyword) + "` with " + std::to_string(n) + " value(s)");
    }
    /// Nothing may follow.
    void end() {
        if (!rest_.empty() || fill()) reject("trailing", "bytes after the last line");
    }
    /// SHA-256 of all lines before the present one, in hexadecimal; once.
    std::string digest() {
        std::array<std::uint8_t, SHA256_DIGEST_SIZE> bytes;
        sha256_digest(&hash_, bytes.size(), bytes.data());
        std::string hex;
        for (const int b : bytes) (hex += "0123456789abcdef"[b / 16]) += "0123456789abcdef"[b % 16];
        return hex;
    }

    // Field i as a value of its class.
    [[nodiscard]] std::uint64_t natural(std::size_t i) const {
        if (!is_natural(fields[i], 18)) reject("number", "not a natural number, or of more than 18 digits");
        return std::stoull(std::string(fields[i]));
    }
    [[nodiscard]] mpz_class long_natural(std::size_t i) const {
        if (!is_natural(fields[i], longest_integer)) reject("number", "not a natural number");
        return mpz_class(std::string(fields[i]));
    }
    [[nodiscard]] mpq_class ratio(std::size_t i) const { return ratio(fields[i]); }
    [[nodiscard]] mpq_class ratio(std::string_view text) const {
        const auto [p, q] = halves(text, '/');
        if (!is_natural(p, longest_integer) || !is_natural(q, longest_integer) || p == "0" || q == "0")
            reject("number", "not a ratio P/Q");
        const mpq_class x{mpz_class(std::string(p)), mpz_class(std::string(q))};
        if (gcd(x.get_num(), x.get_den()) != 1) reject("number", "a ratio that is not in lowest terms");
        return x;
    }
    [[nodiscard]] mpq_class dyadic(std::size_t i) const {
        const auto [m, exponent] = halves(fields[i], 'b');
        const bool minus = exponent.starts_with('-');
        const std::string k(exponent.substr(minus));
        const bool canonical =
            m == "0" ? exponent == "0" : is_natural(m, most_digits) && (m.back() - '0') % 2 == 1;
        if (!canonical || !is_natural(k, 4) || (minus && k == "0") || std::stoul(k) > most_places)
            reject("number", "not MbK");
        const mpq_class x = mpz_class(std::string(m));
        return minus ? mpq_class(x >> std::stoul(k)) : mpq_class(x << std::stoul(k));
    }
    void require_word(std::size_t i, bool digit_may_lead = false) const {
        constexpr std::string_view rest = "abcdefghijklmnopqrstuvwxyz0123456789-.";
        if (fields[i].size() > 32 || rest.find(fields[i][0]) >= (digit_may_lead ? 36 : 26) ||
            fields[i].find_first_not_of(rest) != std::string_view::npos)
            reject("word", "not a word");
    }
    [[nodiscard]] std::string word(std::size_t i) const {
        require_word(i);
        return std::string(fields[i]);
    }

  private:
    static constexpr std::uint64_t units_per_byte = 128;
    static constexpr std::size_t most_bytes = 4096;   ///< of a line, with its line feed
    static constexpr std::size_t most_places = 4096;  ///< of a dyadic: as many as a piece has bits
    static constexpr std::size_t most_digits = 1250;  ///< of its odd part: as many places, and 56 bits before

    static std::pair<std::string_view, std::string_view> halves(std::string_view text, char mark) {
        const std::size_t at = std::min(text.find(mark), text.size());
        return {text.substr(0, at), text.substr(std::min(at + 1, text.size()))};
    }
    /// The next block of text; false at its end.
    bool fill() { return !(rest_ = source_.next(line)).empty(); }

    Source& source_;
    sha256_ctx hash_{};
    std::string_view rest_;  ///< of the block
    std::string line_;       ///< with its line feed
};

}  // namespace dumbbell_verify
