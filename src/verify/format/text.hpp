// The text of a certificate, line by line: bytes, gzip, SHA-256 and the lexical classes (format.md, section
// 1). Memory does not grow with the file.
#pragma once
#include <fcntl.h>
#include <gmpxx.h>
#include <openssl/evp.h>
#include <sys/stat.h>
#include <unistd.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <memory>
#include <new>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "verify/number/work.hpp"

namespace dumbbell_verify {

/// With several files the last one of these counts. Only `verified` says that a whole file was checked;
/// `part`: what was asked for is a part of it, which was; `combined`: nothing was, lines say that all parts
/// were.
enum class Verdict { verified, part, combined, unreadable, unsupported, limit, rejected };

/// Why a file is not verified; thrown, and reported as it is.
struct Failure {
    Verdict verdict;
    std::uint64_t line;
    std::string code, text;
};

/// What a file may cost, in the units of work.hpp; its reader and what it reads share it.
class Budget {
  public:
    explicit Budget(std::uint64_t units) : all_(units), left_(units) {}
    [[nodiscard]] std::uint64_t left() const { return left_; }
    [[nodiscard]] std::uint64_t taken() const { return all_ - left_; }
    /// Throws Failure if there is not so much; then nothing is left.
    void take(std::uint64_t units, std::uint64_t line) {
        const bool enough = units <= left_;
        left_ -= enough ? units : left_;
        if (!enough)
            throw Failure{Verdict::limit, line, "limit",
                          "more work than the budget of " + std::to_string(all_ / units_per_second) +
                              " s: --budget allows more"};
    }

  private:
    std::uint64_t all_, left_;
};

/// A file to read; `-` is the standard input. A pipe with a name is refused: if nobody writes to it, a reader
/// would wait for ever. nullptr: `why` says what is wrong.
inline std::FILE* open_file(const std::string& path, std::string& why) {
    const int file =
        path == "-" ? ::dup(STDIN_FILENO) : ::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
    struct stat what {};
    const bool unnamed = path == "-" || path.starts_with("/dev/") || path.starts_with("/proc/");
    if (!unnamed && file >= 0 && ::fstat(file, &what) == 0 && S_ISFIFO(what.st_mode)) {
        why = "a named pipe: give `-` and let the shell redirect it";
        ::close(file);
        return nullptr;
    }
    if (file >= 0 && path != "-") ::fcntl(file, F_SETFL, 0);  // from now on it may wait
    std::FILE* stream = file < 0 ? nullptr : ::fdopen(file, "rb");
    if (!stream) why = std::strerror(errno);
    return stream;
}

constexpr std::size_t longest_integer = 2100;  ///< digits of one in a file

/// A natural number without leading zero and with at most `most` digits.
inline bool is_natural(std::string_view text, std::size_t most) {
    return !text.empty() && text.size() <= most && (text[0] != '0' || text.size() == 1) &&
           text.find_first_not_of("0123456789") == std::string_view::npos;
}

class Text {
  public:
    Text(const std::string& path, std::uint64_t units) : budget(units), file_(nullptr, std::fclose) {
        std::string why;
        file_.reset(open_file(path, why));
        if (!file_) throw Failure{Verdict::unreadable, 0, "unreadable", why};
        need_memory(hash_ && EVP_DigestInit_ex(hash_.get(), EVP_sha256(), nullptr) == 1);
        rest_ = read();
        gzip_ = rest_.starts_with("\x1f\x8b");
        if (!gzip_) return;
        feed(std::exchange(rest_, {}));
        need_memory(inflateInit2(&stream_, 15 + 16) == Z_OK);
    }
    ~Text() { inflateEnd(&stream_); }
    Text(const Text&) = delete;
    Text& operator=(const Text&) = delete;

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
        need_memory(EVP_DigestUpdate(hash_.get(), line_.data(), line_.size()) == 1);
        budget.take(line_.size() * units_per_byte, line);
        line_.clear();
        fields.clear();
        ++line;
        while (!line_.ends_with('\n')) {
            if (rest_.empty() && !fill()) reject("truncated", "the text ends too early");
            const std::size_t size =
                1 + std::min({rest_.find('\n'), rest_.size() - 1, most_bytes - line_.size()});
            const auto bad = [](char c) { return (c < 0x20 || c > 0x7e) && c != '\n'; };
            if (std::any_of(rest_.begin(), rest_.begin() + size, bad)) reject("byte", "not printable ASCII");
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
        if (!rest_.empty() || fill()) reject("trailing", "bytes behind the last line");
    }
    /// SHA-256 of all lines before the present one, in hexadecimal; once.
    std::string digest() {
        std::array<unsigned char, 32> bytes;
        need_memory(EVP_DigestFinal_ex(hash_.get(), bytes.data(), nullptr) == 1);
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
    [[nodiscard]] mpq_class signed_ratio(std::size_t i) const {
        if (fields[i] == "0/1") return 0;
        return fields[i].starts_with('-') ? mpq_class(-ratio(fields[i].substr(1))) : ratio(i);
    }
    [[nodiscard]] mpq_class level(std::size_t i) const {
        return fields[i] == "0/1" ? mpq_class(0) : ratio(i);
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

    static void need_memory(bool enough) {
        if (!enough) throw std::bad_alloc();
    }
    static void need_file(bool readable) {
        if (!readable) throw Failure{Verdict::unreadable, 0, "unreadable", std::strerror(errno)};
    }
    static std::pair<std::string_view, std::string_view> halves(std::string_view text, char mark) {
        const std::size_t at = std::min(text.find(mark), text.size());
        return {text.substr(0, at), text.substr(std::min(at + 1, text.size()))};
    }
    [[nodiscard]] mpq_class ratio(std::string_view text) const {
        const auto [p, q] = halves(text, '/');
        if (!is_natural(p, longest_integer) || !is_natural(q, longest_integer) || p == "0" || q == "0")
            reject("number", "not a ratio P/Q");
        const mpq_class x{mpz_class(std::string(p)), mpz_class(std::string(q))};
        if (gcd(x.get_num(), x.get_den()) != 1) reject("number", "a ratio that is not in lowest terms");
        return x;
    }
    std::string_view read() {
        const std::size_t n = std::fread(raw_.data(), 1, raw_.size(), file_.get());
        need_file(std::ferror(file_.get()) == 0);
        return {raw_.data(), n};
    }
    void feed(std::string_view bytes) {
        stream_.next_in = reinterpret_cast<Bytef*>(raw_.data());
        stream_.avail_in = static_cast<uInt>(bytes.size());
    }
    /// The next block of text; false at its end. At most one gzip member, and nothing after it.
    bool fill() {
        if (!gzip_) return !(rest_ = read()).empty();
        stream_.next_out = reinterpret_cast<Bytef*>(block_.data());
        stream_.avail_out = static_cast<uInt>(block_.size());
        while (!ended_ && stream_.avail_out == block_.size()) {
            if (stream_.avail_in == 0) feed(read());
            if (stream_.avail_in == 0) reject("gzip", "the compressed file is truncated");
            const int state = inflate(&stream_, Z_NO_FLUSH);
            need_memory(state != Z_MEM_ERROR);
            if (state != Z_OK && state != Z_STREAM_END) reject("gzip", "the compressed file is damaged");
            ended_ = state == Z_STREAM_END;
            if (ended_ && (stream_.avail_in > 0 || !read().empty()))
                reject("gzip", "bytes behind the gzip member");
        }
        rest_ = {block_.data(), block_.size() - stream_.avail_out};
        return !rest_.empty();
    }

    std::unique_ptr<std::FILE, int (*)(std::FILE*)> file_;
    std::unique_ptr<EVP_MD_CTX, void (*)(EVP_MD_CTX*)> hash_{EVP_MD_CTX_new(), EVP_MD_CTX_free};
    z_stream stream_{};
    bool gzip_ = false, ended_ = false;
    std::vector<char> raw_ = std::vector<char>(1 << 16), block_ = raw_;  ///< not on the stack
    std::string_view rest_;  ///< of the block, or of the raw bytes of a plain file
    std::string line_;       ///< with its line feed
};

}  // namespace dumbbell_verify
