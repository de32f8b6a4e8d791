#include "report/html_data.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "arith/decimal.hpp"
#include "arith/error.hpp"
#include "model/growth_constant.hpp"
#include "report/html_file.hpp"

namespace dumbbell {
namespace {

constexpr int constant_digits = 20;
constexpr int constant_bits = 128;

struct LeavesOf {
    std::size_t operator()(const Certificate& certificate) const {
        long leaves = 0;
        for (const Piece& piece : certificate.pieces) {
            leaves += piece.cover.leaves();
        }
        return static_cast<std::size_t>(leaves);
    }
    std::size_t operator()(const InitialCertificate& certificate) const { return closed(certificate.tree); }
    std::size_t operator()(const AdiabaticCertificate& certificate) const { return closed(certificate.tree); }

  private:
    template <class Tree>
    static std::size_t closed(const Tree& tree) {
        return static_cast<std::size_t>(
            std::ranges::count_if(tree, [](const auto& node) { return !node.split; }));
    }
};

/// As a shell takes it: whatever is no plain word is quoted.
std::string shell_word(const std::string& text) {
    constexpr const char* plain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_./:=@%+,-";
    if (!text.empty() && text.find_first_not_of(plain) == std::string::npos) {
        return text;
    }
    std::string quoted = "'";
    for (const char c : text) {
        quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
    }
    return quoted + "'";
}

std::string growth_digits() {
    const PrecisionScope scope(constant_bits);
    const BigInterval c = growth_constant();
    const auto digits = shared_digits(exact_lo(c), exact_hi(c), constant_digits);
    require(digits.has_value(), "report: the constant C is not known to 20 digits");
    return to_text(*digits);
}

nlohmann::ordered_json one_file(const ReportedFile& file, const BoxBudget& budget) {
    nlohmann::ordered_json json =
        std::visit([&](const auto& of) { return file_json(of, budget); }, file.certificate);
    const auto [program, version, options] =
        std::visit([](const auto& of) { return std::tuple(of.program, of.version, claim_options(of)); },
                   file.certificate);
    json["name"] = std::filesystem::path(file.path).filename().string();
    json["generator"] = program + " " + version;
    json["sha256"] = file.sha256;
    // A name that begins with a dash would be an option.
    json["verify_options"] = options;
    json["verify_file"] = shell_word(file.path.starts_with('-') ? "./" + file.path : file.path);
    return json;
}

}  // namespace

std::size_t leaves_of(const AnyCertificate& certificate) { return std::visit(LeavesOf(), certificate); }

nlohmann::ordered_json page_data(const std::vector<ReportedFile>& files, std::size_t most_boxes) {
    BoxBudget budget{0, most_boxes};
    std::size_t pieces = 0;
    for (const ReportedFile& file : files) {
        budget.total += leaves_of(file.certificate);
        if (const auto* certificate = std::get_if<Certificate>(&file.certificate)) {
            pieces += certificate->pieces.size();
        }
    }
    if (pieces > most_pieces) {
        throw InputError(
            fmt::format("the files have {} pieces, a page takes {}: report on fewer files, or on a part "
                        "of the range (dumbbell certify LO:HI --out FILE)",
                        pieces, most_pieces));
    }
    nlohmann::ordered_json json{{"schema", "dumbbell-report-1"},
                                {"version", DUMBBELL_VERSION},
                                {"growth_constant", growth_digits()},
                                {"boxes", {{"total", budget.total}, {"most", budget.most}}},
                                {"files", nlohmann::ordered_json::array()}};
    for (const ReportedFile& file : files) {
        json["files"].push_back(one_file(file, budget));
    }
    return json;
}

}  // namespace dumbbell
