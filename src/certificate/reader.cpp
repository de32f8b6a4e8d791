#include "certificate/reader.hpp"

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <filesystem>
#include <memory>
#include <string_view>
#include <vector>

#include "arith/error.hpp"
#include "certificate/names.hpp"

namespace dumbbell {
namespace {

constexpr int max_line = 8192;

/// Lines of a file, split into fields.
class Lines {
  public:
    explicit Lines(const std::string& path) : path_(path), file_(nullptr, &gzclose) {
        if (!std::filesystem::is_regular_file(path)) {
            throw InputError(
                fmt::format("cannot read '{}': {}", path,
                            std::filesystem::exists(path) ? "not a regular file" : "no such file"));
        }
        file_.reset(gzopen(path.c_str(), "rb"));
        if (!file_) {
            throw InputError(fmt::format("cannot read '{}'", path));
        }
    }

    /// The next line's fields; the first must be `keyword` and there must be `count` in all.
    const std::vector<std::string>& expect(std::string_view keyword, std::size_t count) {
        next();
        if (fields_.size() != count || fields_[0] != keyword) {
            fail();
        }
        return fields_;
    }

    const std::vector<std::string>& next() {
        std::string buffer(max_line, '\0');
        ++number_;
        if (gzgets(file_.get(), buffer.data(), max_line) == nullptr) {
            fail();
        }
        std::string_view line(buffer.c_str());
        if (line.empty() || line.back() != '\n') {
            fail();
        }
        line.remove_suffix(1);
        fields_.clear();
        for (std::size_t begin = 0; begin <= line.size();) {
            const std::size_t end = std::min(line.find(' ', begin), line.size());
            fields_.emplace_back(line.substr(begin, end - begin));
            begin = end + 1;
        }
        return fields_;
    }

    [[noreturn]] void fail() const {
        throw InputError(
            fmt::format("'{}' is not a certificate that this program can read (line {})", path_, number_));
    }

    long number(const std::string& text) const {
        long value = 0;
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
        if (error != std::errc() || end != text.data() + text.size() || value < 0) {
            fail();
        }
        return value;
    }

    Rational ratio(const std::string& text) const {
        try {
            return parse_rational(text, max_line);
        } catch (const InputError&) {
            fail();
        }
    }

    Rational dyadic(const std::string& text) const {
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

  private:
    std::string path_;
    std::unique_ptr<gzFile_s, int (*)(gzFile)> file_;
    std::vector<std::string> fields_;
    long number_ = 0;
};

Node node_from(Lines& lines, Chart chart) {
    const auto& fields = lines.next();
    const std::string& word = fields[0];
    if (word == "split" && fields.size() == 2) {
        if (const auto axis = axis_named(chart, fields[1])) {
            return {*axis, {}};
        }
    }
    const auto reason = reason_named(word);
    const std::size_t counts = reason != Reason::count ? 0 : counts_both_ways(chart) ? 2 : 1;
    if (reason && fields.size() == 1 + counts) {
        return {
            std::nullopt,
            {*reason, counts > 0 ? lines.number(fields[1]) : 0, counts > 1 ? lines.number(fields[2]) : 0}};
    }
    lines.fail();
}

ChartTree tree_from(Lines& lines, Chart chart) {
    Tree tree;
    for (long missing = 1; missing > 0;) {
        tree.push_back(node_from(lines, chart));
        missing += tree.back().split ? 1 : -1;
    }
    return {chart, std::move(tree)};
}

Cover cover_from(Lines& lines, const std::vector<Chart>& charts) {
    Cover cover;
    for (const Chart chart : charts) {
        const auto& fields = lines.next();
        if (cover.charts.empty() && fields.size() == 1 && fields[0] == "equal-masses") {
            cover.equal_masses = true;
            return cover;
        }
        if (fields.size() != 2 || fields[0] != "chart" || fields[1] != name(chart)) {
            lines.fail();
        }
        cover.charts.push_back(tree_from(lines, chart));
    }
    return cover;
}

constexpr std::array witness_charts{Chart::bridge, Chart::wedge};

Piece piece_from(Lines& lines, const std::vector<Chart>& charts) {
    Piece piece;
    const auto& range = lines.expect("piece", 3);
    piece.q_lo = lines.ratio(range[1]);
    piece.q_hi = lines.ratio(range[2]);
    piece.bits = static_cast<int>(std::min(lines.number(lines.expect("bits", 2)[1]), 4096L));
    const std::string upper = lines.expect("upper", 2)[1];
    if (upper != "none") {
        piece.upper = lines.number(upper);
        piece.cover = cover_from(lines, charts);
    }
    piece.lower = lines.number(lines.expect("lower", 2)[1]);
    if (piece.lower > 0) {
        const auto& w = lines.expect("witness", 6);
        const auto chart = std::find_if(witness_charts.begin(), witness_charts.end(),
                                        [&](Chart c) { return w[1] == name(c); });
        if (chart == witness_charts.end()) {
            lines.fail();
        }
        piece.witness =
            Witness{lines.dyadic(w[2]), lines.dyadic(w[3]), lines.number(w[4]), lines.number(w[5]), *chart};
    }
    return piece;
}

}  // namespace

Certificate read_certificate(const std::string& path) {
    Lines lines(path);
    if (lines.expect("dumbbell-certificate", 2)[1] != "1") {
        lines.fail();
    }
    Certificate certificate;
    const auto& generator = lines.expect("generator", 3);
    certificate.program = generator[1];
    certificate.version = generator[2];
    const std::string lemmas = lines.expect("lemmas", 2)[1];
    const auto scene = scene_named(lines.expect("scene", 2)[1]);
    const auto section = section_named(lines.expect("section", 2)[1], lemmas);
    const std::string claim = lines.expect("claim", 2)[1];
    if (claim == "initial-conditions") {
        throw InputError(
            fmt::format("'{}' is about initial conditions (dumbbell trace): a certificate about mass ratios "
                        "is needed here "
                        "(dumbbell certify RATIO --out FILE); dumbbell verify reads both",
                        path));
    }
    if (!scene || !section || claim != "collisions") {
        lines.fail();
    }
    certificate.scene = *scene;
    certificate.section = *section;
    const auto charts = charts_of(*scene, *section);
    lines.expect("ratio", 3);
    const long pieces = lines.number(lines.expect("pieces", 2)[1]);
    if (pieces == 0) {
        lines.fail();
    }
    for (long i = 0; i < pieces; ++i) {
        certificate.pieces.push_back(piece_from(lines, charts));
    }
    return certificate;
}

}  // namespace dumbbell
