#include "page/data.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <limits>

#include "base/error.hpp"
#include "base/printable.hpp"
#include "collisions/reader.hpp"
#include "file/file_contents.hpp"
#include "file/sealed_lines.hpp"
#include "flight/growth_constant.hpp"
#include "number/decimal.hpp"
#include "page/any_certificate.hpp"
#include "page/file.hpp"
#include "pictures/palette.hpp"

namespace dumbbell::page {
namespace {

/// Where the data, the verifier and, in the page of ./run web, the prover go: once in the template, in this
/// order.
constexpr std::string_view data_place = "@DUMBBELL_DATA@", verifier_place = "@DUMBBELL_VERIFIER@",
                           prover_place = "@DUMBBELL_PROVER@";

constexpr int constant_digits = 20;
constexpr int constant_bits = 128;

std::string growth_digits() {
    const PrecisionScope scope(constant_bits);
    const BigInterval c = flight::growth_constant();
    const auto digits = shared_digits(exact_lo(c), exact_hi(c), constant_digits);
    require(digits.has_value(), "report: the constant C is not known to 20 digits");
    return to_text(*digits);
}

/// The colours of the page's pictures by their names in its style sheets: on light and on dark pages.
Json colours_json() {
    const auto both = [](const pictures::Shade& shade) { return Json::array({shade.light, shade.dark}); };
    return Json::object({{"proved", both(pictures::palette::proved)},
                         {"paper", both(pictures::palette::paper)},
                         {"growth", both(pictures::palette::growth)},
                         {"gap", both(pictures::palette::gap)},
                         {"hatch", both(pictures::palette::hatch)},
                         {"light", both(pictures::palette::light)},
                         {"heavy", both(pictures::palette::heavy)},
                         {"floor", both(pictures::palette::floor)},
                         {"mark", both(pictures::palette::witness)}});
}

void require_few(std::size_t pieces) {
    if (pieces > most_pieces) {
        throw InputError(
            fmt::format("the files have {} pieces, a page takes {}: report on fewer files, or on a part "
                        "of the range (dumbbell certify LO:HI --out FILE)",
                        pieces, most_pieces));
    }
}

Json one_file(const ReportedFile& file, const BoxBudget& budget) {
    return std::visit(
        [&](const auto& of) {
            Json json = file_json(of, budget);
            json.add("name", std::filesystem::path(file.path).filename().string());
            json.add("generator", of.generator.program + " " + of.generator.version);
            json.add("sha256", file.sha256);
            json.add("verify_options", claim_options(of));
            json.add("verify_file", shell_file(std::filesystem::path(file.path).filename()));
            json.add("bytes", base64(file.bytes));
            return json;
        },
        file.content);
}

Reported shown(AnyCertificate any, const std::string& path) {
    if (auto* of_starts = std::get_if<starts::Certificate>(&any)) {
        return std::move(*of_starts);
    }
    if (auto* of_collisions = std::get_if<collisions::Certificate>(&any)) {
        return std::move(*of_collisions);
    }
    throw InputError(fmt::format(
        "'{}' is about the adiabatic invariant: no page shows that; dumbbell verify checks it", path));
}

}  // namespace

void require_few_pieces(const std::vector<std::string>& paths) {
    std::size_t pieces = 0;
    for (const std::string& path : paths) {
        const std::size_t countable = std::numeric_limits<std::size_t>::max() - pieces;
        pieces += std::min(countable, collisions::claimed_pieces(path));
    }
    require_few(pieces);
}

ReportedFile read_reported(const std::string& path, std::string bytes, bool with_bytes) {
    const NamedFile file(path, bytes);
    std::string sha256 = sealed_digest(file);
    Reported content = shown(read_any_certificate(file), path);
    return {path, std::move(sha256), std::move(content), with_bytes ? std::move(bytes) : ""};
}

std::size_t leaves_of(const Reported& content) {
    return std::visit(
        [](const auto& of) {
            if constexpr (requires { of.pieces; }) {
                return static_cast<std::size_t>(of.leaves());
            } else {
                return of.tree.size() / 2 + 1;  // one more than the tree has splits
            }
        },
        content);
}

Json page_data(const std::vector<ReportedFile>& files, std::size_t most_boxes) {
    BoxBudget budget{0, most_boxes};
    std::size_t pieces = 0;
    for (const ReportedFile& file : files) {
        budget.total += leaves_of(file.content);
        if (const auto* certificate = std::get_if<collisions::Certificate>(&file.content)) {
            pieces += certificate->pieces.size();
        }
    }
    require_few(pieces);
    Json shown = Json::array();
    for (const ReportedFile& file : files) {
        shown.add(one_file(file, budget));
    }
    return Json::object({{"schema", "dumbbell-report-1"},
                         {"version", DUMBBELL_VERSION},
                         {"growth_constant", growth_digits()},
                         {"colours", colours_json()},
                         {"boxes", Json::object({{"total", budget.total}, {"most", budget.most}})},
                         {"files", shown}});
}

std::string html_page(const Json& data, std::string_view verifier) {
    std::string text;
    std::string_view rest = page_template();
    const auto put = [&](std::string_view place, const std::string& what) {
        const std::size_t at = rest.find(place);
        require(at != std::string_view::npos, "report: the page has no place for its data");
        text.append(rest.substr(0, at)).append(what);
        rest.remove_prefix(at + place.size());
    };
    put(data_place, respelled(data.text(), {{'<', "\\u003c"}}));
    put(verifier_place, base64(verifier));
    put(prover_place, "");
    require(rest.find("@DUMBBELL_") == std::string_view::npos,
            "report: the page has one more place for data");
    return text.append(rest);
}

std::string base64(std::string_view bytes) {
    constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (; !bytes.empty(); bytes.remove_prefix(std::min<std::size_t>(bytes.size(), 3))) {
        unsigned three = 0;
        for (std::size_t i = 0; i < 3; ++i) {
            three = three << 8 | (i < bytes.size() ? static_cast<unsigned char>(bytes[i]) : 0);
        }
        for (std::size_t i = 0; i < 4; ++i) {
            text += i <= bytes.size() ? digits[three >> (18 - 6 * i) & 63] : '=';
        }
    }
    return text;
}

}  // namespace dumbbell::page
