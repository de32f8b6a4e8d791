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
#include <tuple>
#include <vector>

#include "verify/core/section.hpp"
#include "verify/program/verify.hpp"

namespace make {

using dumbbell_verify::Leaf;
using dumbbell_verify::Section;

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

/// What the trailer of such a text counts.
inline std::vector<std::string> kinds_of(const std::string& text) {
    const auto has = [&](const char* line) { return text.find(line) != std::string::npos; };
    if (has("\nclaim adiabatic-")) return {"split", "bound", "outside"};
    if (has("\nsection none\n")) return {"split", "exactly", "between", "open"};
    std::vector<std::string> kinds{"split",          "count",        "outside", "meets",
                                   "meets-reversed", "equal-masses", "witness"};
    if (has("\nclaim law\n"))
        kinds.insert(kinds.end(), {"slope", "beyond"});
    else if (has("\nscene body\n"))
        kinds.insert(kinds.end(), {has("\nsection full\n") ? "symmetric" : "orbits", "open"});
    else if (has("\nsection full\n"))
        kinds.insert(kinds.end(), {"once", "open"});
    else
        kinds.emplace_back("open");
    return kinds;
}

inline std::string hashed(const std::string& text) { return text + "sha256 " + sha256(text) + "\n"; }
/// The text with the totals of these kinds, and its hash.
inline std::string closed(const std::string& body, const std::vector<std::string>& kinds) {
    std::map<std::string, int> count;
    std::istringstream in(body);
    for (std::string line; std::getline(in, line);)
        ++count[line == "upper none" ? "open" : line.substr(0, line.find(' '))];
    --count["bound"], --count["between"];  // those of the header
    std::string text = body;
    for (const std::string& kind : kinds) text += "total " + kind + " " + std::to_string(count[kind]) + "\n";
    return hashed(text);
}
inline std::string closed(const std::string& body) { return closed(body, kinds_of(body)); }

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
    return closed(changed.substr(0, changed.find("total split")), kinds_of(text));
}

/// A tree of leaves that the section accepts with U = leaf.claimed on the leaf's box, or std::runtime_error.
inline std::string tree(const Section& section, Leaf leaf, int depth = 0) {
    if (depth > 40) throw std::runtime_error("the cover does not close");
    if (leaf.bits == 53)
        leaf.bits = 2;  // the second attempt at a leaf, dear and mostly in vain, is a short one
    const auto accepts = [&](std::size_t opcode) {
        leaf.opcode = opcode;
        return (section.opcodes[opcode].charts >> leaf.chart & 1) != 0 && !section.check(leaf, nullptr);
    };
    for (std::size_t i = 0; i < section.opcodes.size(); ++i)
        if (const auto& opcode = section.opcodes[i];
            opcode.place == dumbbell_verify::Place::leaf && opcode.hints == 0 && accepts(i))
            return std::string(opcode.name) + "\n";
    const bool two = section.opcodes[dumbbell_verify::count_leaf].hints == 2;
    const unsigned long most = leaf.claimed.get_ui() - 1;
    for (unsigned long i = 0; i <= (two ? most : 0); ++i) {  // a and b are mostly alike
        leaf.a = !two ? most : i % 2 == 0 ? (most - i) / 2 : (most + i + 1) / 2;
        leaf.b = most - leaf.a;
        if (accepts(dumbbell_verify::count_leaf))
            return "count " + leaf.a.get_str() + (two ? " " + leaf.b.get_str() : "") + "\n";
    }
    const mpq_class wide = two ? mpq_class(1 / leaf.box.hi[2]) : mpq_class(2);  // next to the other axis
    const bool ratio = two && depth % 3 == 2 && leaf.box.hi[2] > leaf.box.lo[2];
    const std::size_t i = ratio                                                                        ? 2
                          : leaf.box.hi[0] - leaf.box.lo[0] > wide * (leaf.box.hi[1] - leaf.box.lo[1]) ? 0
                                                                                                       : 1;
    Leaf lower = leaf, upper = leaf;
    lower.box.hi[i] = upper.box.lo[i] = (leaf.box.lo[i] + leaf.box.hi[i]) / 2;
    return "split " + std::string(section.charts[leaf.chart].axes[i]) + "\n" +
           tree(section, lower, depth + 1) + tree(section, upper, depth + 1);
}

/// All trees of a piece [a, b] for the bound `upper`, for bodies of these rho if there are some.
inline std::string cover(const Section& section, const mpq_class& a, const mpq_class& b, std::uint64_t upper,
                         unsigned bits = 53, const dumbbell_verify::Range& rho = {}) {
    Leaf leaf;
    leaf.claimed = upper;
    leaf.bits = bits;
    std::string text;
    for (leaf.chart = 0; leaf.chart < section.charts.size(); ++leaf.chart) {
        leaf.box = section.root(leaf.chart, a, b);
        std::tie(leaf.box.lo[3], leaf.box.hi[3]) = rho;
        text += "chart " + std::string(section.charts[leaf.chart].name) + "\n" + tree(section, leaf);
    }
    return text;
}

inline std::string fraction(const mpq_class& x) {
    return x.get_num().get_str() + "/" + x.get_den().get_str();
}

/// A whole piece; `witness` is the part of its line after the word, or empty for `lower 0`.
inline std::string piece(const mpq_class& a, const mpq_class& b, std::uint64_t upper, std::uint64_t lower,
                         const std::string& witness, unsigned bits = 53) {
    return "piece " + fraction(a) + " " + fraction(b) + "\nbits " + std::to_string(bits) + "\nupper " +
           std::to_string(upper) + "\n" + cover(dumbbell_verify::turning(), a, b, upper, bits) + "lower " +
           std::to_string(lower) + "\n" + (lower > 0 ? "witness " + witness + "\n" : "");
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

/// What is demanded of a scene, in this precision at least.
inline dumbbell_verify::Request asking(const std::string& scene, unsigned precision = 0) {
    dumbbell_verify::Request settings;
    settings.scene = scene;
    settings.precision = precision;
    return settings;
}
/// Why the file is not verified; its code is "verified" if it is.
inline dumbbell_verify::Failure failure(const std::string& bytes,
                                        const dumbbell_verify::Request& settings = {}) try {
    dumbbell_verify::verify(File(bytes).path(), settings);
    return {dumbbell_verify::Verdict::verified, 0, "verified", ""};
} catch (const dumbbell_verify::Failure& failure) {
    return failure;
}
inline std::string outcome(const std::string& bytes, const dumbbell_verify::Request& settings = {}) {
    return failure(bytes, settings).code;
}

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
