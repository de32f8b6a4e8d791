// Certificates for tests: text with a correct trailer around any body, and a plain search for real trees. The
// search asks the section's own check what it accepts, so it shows that the verifier accepts true claims;
// that it refuses false ones is shown by mutating what comes out.
#pragma once
#include <nettle/sha2.h>
#include <unistd.h>
#include <zlib.h>

#include <array>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>

#include "verify/core/section.hpp"

namespace make {

using dumbbell_verify::Box;
using dumbbell_verify::Leaf;

inline std::string sha256(const std::string& text) {
    std::array<std::uint8_t, SHA256_DIGEST_SIZE> bytes{};
    sha256_ctx context{};
    sha256_init(&context);
    sha256_update(&context, text.size(), reinterpret_cast<const std::uint8_t*>(text.data()));
    sha256_digest(&context, bytes.size(), bytes.data());
    std::string hex;
    for (const std::uint8_t b : bytes) (hex += "0123456789abcdef"[b / 16]) += "0123456789abcdef"[b % 16];
    return hex;
}

/// The totals that belong to these lines.
inline std::string totals(const std::string& body) {
    std::map<std::string, int> count;
    std::istringstream in(body);
    for (std::string line; std::getline(in, line);)
        ++count[line == "upper none" ? "open" : line.substr(0, line.find(' '))];
    const bool full = body.find("\nsection full\n") != std::string::npos;
    const bool bodies = body.find("\nscene body\n") != std::string::npos;
    std::string text;
    for (const std::string kind : {"split", "count", "outside", "meets", "meets-reversed", "equal-masses",
                                   "witness", "once", "symmetric", "open"})
        if ((kind != "once" || (full && !bodies)) && (kind != "symmetric" || bodies))
            text += "total " + kind + " " + std::to_string(count[kind]) + "\n";
    return text;
}

inline std::string hashed(const std::string& text) { return text + "sha256 " + sha256(text) + "\n"; }
inline std::string closed(const std::string& body) { return hashed(body + totals(body)); }
/// The same of a text about the adiabatic invariant.
inline std::string closed_adiabatic(const std::string& text) {
    std::map<std::string, int> count;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);) ++count[line.substr(0, line.find(' '))];
    --count["bound"];  // that of the header
    std::string all = text;
    for (const std::string kind : {"split", "bound", "outside"})
        all += "total " + kind + " " + std::to_string(count[kind]) + "\n";
    return hashed(all);
}

inline std::string header(const std::string& lo, const std::string& hi, int pieces) {
    return "dumbbell-certificate 1\ngenerator test 1.0\nlemmas 1\nscene dumbbell\nsection turning\nclaim "
           "collisions\n"
           "ratio " +
           lo + " " + hi + "\npieces " + std::to_string(pieces) + "\n";
}

/// A copy of the text with `from` (which must occur) replaced once.
inline std::string replaced(std::string text, const std::string& from, const std::string& to) {
    const std::size_t at = text.find(from);
    if (at == std::string::npos) throw std::logic_error("not in the text: " + from);
    return text.replace(at, from.size(), to);
}

/// The same with the trailer made anew, so that nothing but the change itself is wrong.
inline std::string mutated(const std::string& text, const std::string& from, const std::string& to) {
    const std::string changed = replaced(text, from, to);
    return closed(changed.substr(0, changed.find("total split")));
}

using dumbbell_verify::count_leaf, dumbbell_verify::meets, dumbbell_verify::meets_reversed,
    dumbbell_verify::outside;

inline bool accepts(Leaf leaf, std::size_t opcode, const mpz_class& a = 0, const mpz_class& b = 0) {
    leaf.opcode = opcode;
    leaf.a = a;
    leaf.b = b;
    return dumbbell_verify::turning().check(leaf, nullptr) == nullptr;
}

/// A tree that proves the bound on the box, or std::runtime_error.
inline std::string tree(Leaf leaf, int depth = 0) {
    if (depth > 40) throw std::runtime_error("the cover does not close");
    if (accepts(leaf, outside)) return "outside\n";
    if (leaf.chart == 1 && accepts(leaf, meets)) return "meets\n";
    if (leaf.chart == 1 && accepts(leaf, meets_reversed)) return "meets-reversed\n";
    for (std::uint64_t a = 0; a < leaf.claimed; ++a)
        if (accepts(leaf, count_leaf, a, leaf.claimed - 1 - a))
            return "count " + std::to_string(a) + " " + mpz_class(leaf.claimed - 1 - a).get_str() + "\n";
    const auto& axes = dumbbell_verify::turning().charts[leaf.chart].axes;
    const bool ratio = depth % 3 == 2 && leaf.box.hi[2] > leaf.box.lo[2];
    const std::size_t i =
        ratio                                                                                  ? 2
        : leaf.box.hi[0] - leaf.box.lo[0] > (leaf.box.hi[1] - leaf.box.lo[1]) / leaf.box.hi[2] ? 0
                                                                                               : 1;
    const mpq_class middle = (leaf.box.lo[i] + leaf.box.hi[i]) / 2;
    Leaf lower = leaf, upper = leaf;
    lower.box.hi[i] = upper.box.lo[i] = middle;
    return "split " + std::string(axes[i]) + "\n" + tree(lower, depth + 1) + tree(upper, depth + 1);
}

/// Both trees of a piece [a, b] for the bound `upper`.
inline std::string cover(const mpq_class& a, const mpq_class& b, std::uint64_t upper, unsigned bits = 53) {
    Leaf leaf;
    leaf.claimed = upper;
    leaf.bits = bits;
    leaf.box = dumbbell_verify::turning().root(0, a, b);
    std::string text = "chart bridge\n" + tree(leaf);
    leaf.chart = 1;
    return text + "chart light\n" + tree(leaf);
}

inline std::string fraction(const mpq_class& x) {
    return x.get_num().get_str() + "/" + x.get_den().get_str();
}

/// A whole piece; `witness` is the part of its line after the word, or empty for `lower 0`.
inline std::string piece(const mpq_class& a, const mpq_class& b, std::uint64_t upper, std::uint64_t lower,
                         const std::string& witness, unsigned bits = 53) {
    return "piece " + fraction(a) + " " + fraction(b) + "\nbits " + std::to_string(bits) + "\nupper " +
           std::to_string(upper) + "\n" + cover(a, b, upper, bits) + "lower " + std::to_string(lower) + "\n" +
           (lower > 0 ? "witness " + witness + "\n" : "");
}

/// A file with these bytes, removed at the end of the test.
class File {
  public:
    explicit File(const std::string& bytes) {
        path_ = std::filesystem::temp_directory_path().string() + "/dumbbell_verify_test_" +
                std::to_string(getpid()) + "_" + std::to_string(++serial);
        std::ofstream(path_, std::ios::binary) << bytes;
    }
    File(const File&) = delete;
    File& operator=(const File&) = delete;
    ~File() { unlink(path_.c_str()); }
    [[nodiscard]] const std::string& path() const { return path_; }

  private:
    inline static int serial = 0;
    std::string path_;
};

inline std::string gzipped(const std::string& text) {
    z_stream stream{};
    if (deflateInit2(&stream, 9, Z_DEFLATED, 15 + 16, 8, Z_DEFAULT_STRATEGY) != Z_OK) throw std::bad_alloc();
    std::string out(deflateBound(&stream, text.size()), '\0');
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(text.data()));
    stream.avail_in = static_cast<uInt>(text.size());
    stream.next_out = reinterpret_cast<Bytef*>(out.data());
    stream.avail_out = static_cast<uInt>(out.size());
    deflate(&stream, Z_FINISH);
    out.resize(stream.total_out);
    deflateEnd(&stream);
    return out;
}

/// One piece at q = 10, in one chart.
inline const std::string& ten() {
    static const std::string text = closed(header("10/1", "10/1", 1) + piece(10, 10, 4, 0, ""));
    return text;
}

}  // namespace make
