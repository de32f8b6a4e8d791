#include <fmt/core.h>

#include <algorithm>
#include <filesystem>

#include "base/error.hpp"
#include "base/printable.hpp"
#include "campaign/kinds/kinds.hpp"
#include "certificates/any_reader.hpp"
#include "collisions/names.hpp"
#include "collisions/reader.hpp"
#include "file/atomic_file.hpp"
#include "file/file_contents.hpp"
#include "file/sealed_lines.hpp"
#include "file/verifier_program.hpp"

namespace dumbbell::campaign {
namespace {

constexpr std::string_view verifier_name = "dumbbell-verify";
constexpr std::string_view certificate_name = "certificate.dbc";
constexpr std::string_view packed_name = "certificate.dbc.gz";

/// `certify` writes at most two for each of a million steps, and some at the ends. The plan holds a line for
/// each, which is the memory that a file of a few kilobytes may ask for, unpacked.
constexpr std::size_t most_pieces = 3'000'000;

/// What an order is about.
struct Subject {
    std::string file;
    collisions::Scene scene = collisions::Scene::dumbbell;
    std::string digest;
    std::size_t of = 0;  ///< pieces of the file
};

std::string head_of(const Subject& subject) {
    return fmt::format("prove verified\nfile {}\nscene {}\ndigest {}\nof {}\n", subject.file,
                       name(subject.scene), subject.digest, subject.of);
}

[[noreturn]] void not_ours() { throw InputError("the order is about a certificate in a way that none is"); }

Subject subject_of(const Order& order) {
    const auto values = head_values(order, {"prove", "file", "scene", "digest", "of"});
    const auto scene = collisions::scene_named(values[2]);
    const std::string& digest = values[3];
    if ((values[1] != certificate_name && values[1] != packed_name) || !scene || digest.size() != 64 ||
        digest.find_first_not_of("0123456789abcdef") != std::string::npos) {
        not_ours();
    }
    Subject subject{values[1], *scene, digest, parse_size(values[4])};
    if (order.head != head_of(subject)) {
        not_ours();
    }
    return subject;
}

/// The numbers of the first and the last piece; they follow one another.
std::pair<std::size_t, std::size_t> pieces_of(const Order& order) {
    constexpr std::string_view keyword = "piece ";
    const auto number = [&](const std::string& unit) {
        return unit.starts_with(keyword) ? parse_size(std::string_view(unit).substr(keyword.size())) : 0;
    };
    const std::size_t first = order.units.empty() ? 0 : number(order.units.front());
    for (std::size_t i = 0; i < order.units.size(); ++i) {
        if (first == 0 || number(order.units[i]) != first + i) {
            not_ours();
        }
    }
    return {first, first + order.units.size() - 1};
}

std::string in(const std::string& folder, std::string_view name) {
    return fmt::format("{}/{}", folder, name);
}

/// How the claim ends, after the file's name.
std::string about(std::string_view ratio, const Subject& subject) {
    return fmt::format(", a certificate over {}, sha256 {}", ratio, subject.digest);
}

class VerifiedKind : public Kind {
  public:
    [[nodiscard]] Evidence evidence() const override { return Evidence::workers; }

    [[nodiscard]] std::optional<std::string> work(const Order& order, const std::string& folder,
                                                  const Interrupted& interrupted) const override {
        const Subject subject = subject_of(order);
        const auto [first, last] = pieces_of(order);
        if (interrupted()) {
            return std::nullopt;
        }
        Verdict verdict;
        try {
            verdict =
                ask_verifier({"--jobs=1", "--quiet", "--max-bits=4096", "--budget=99999h",
                              fmt::format("--scene={}", name(subject.scene)),
                              fmt::format("--shards={}-{}", first, last), "--", in(folder, subject.file)},
                             in(folder, verifier_name));
        } catch (const NoVerdict&) {
            if (interrupted()) {
                return std::nullopt;  // a signal ended the verifier, too
            }
            throw;
        }
        if (!verdict.accepts) {
            throw InputError(fmt::format("the verifier: {}", verdict.line));
        }
        return fmt::format("{}\n", verdict.line);
    }

    [[nodiscard]] Merged merge(const Plan& plan, const std::string& folder,
                               const std::vector<std::string>& files) const override {
        std::string lines;
        for (const std::string& file : files) {
            lines += file_contents(file);
        }
        const std::string parts = in(folder, "arrived") + "/" + plan.whole.id();
        write_atomically(parts, lines, Survives::program);
        const Subject subject = subject_of(plan.whole);
        const Verdict verdict =
            ask_verifier({"--quiet", fmt::format("--scene={}", name(subject.scene)),
                          fmt::format("--combine={}", parts), "--", in(folder, subject.file)},
                         in(folder, verifier_name));
        std::filesystem::remove(parts);
        const std::string& line = verdict.line;
        if (!verdict.accepts || line.find(fmt::format(" sha256={} ", subject.digest)) == std::string::npos) {
            throw InputError(fmt::format("the parts do not combine: {}", line));
        }
        constexpr std::string_view before_ratio = " ratio=";
        const std::size_t ratio = line.find(before_ratio) + before_ratio.size();
        require_tiling(
            plan.claim.ends_with(about(line.substr(ratio, line.find(' ', ratio) - ratio), subject)));
        return {lines, false};
    }

  private:
    [[nodiscard]] Judgement form(const Order& order, const std::string& file) const override {
        const Subject subject = subject_of(order);
        const auto [first, last] = pieces_of(order);
        const std::string text = file_contents(file);
        const bool fits =
            text.starts_with(fmt::format("s PART pieces={}-{} of={} ", first, last, subject.of)) &&
            text.ends_with(fmt::format(" sha256={}\n", subject.digest)) &&
            std::count(text.begin(), text.end(), '\n') == 1;
        if (!fits) {
            return {Judgement::Verdict::wrong,
                    fmt::format("it is not a verification of these pieces: {}", printable(text, 100))};
        }
        return {Judgement::Verdict::proved, ""};
    }

    [[nodiscard]] std::string refutation(const Order& /*order*/, const std::string& /*folder*/,
                                         const std::string& /*file*/) const override {
        return "";  // it is a verification itself
    }
};

}  // namespace

const Kind& verified_kind() {
    static const VerifiedKind kind;
    return kind;
}

VerifiedPlan plan_verified(const std::string& file, std::optional<std::size_t> shards,
                           const Interrupted& interrupted, Observer& observer) {
    observer.enter("reading", "pieces");
    collisions::PieceReader in(file, collisions::Trees::passed_over, interrupted);
    if (in.pieces() > most_pieces) {
        throw InputError(fmt::format("'{}' has {} pieces, more than {}: certify the range in parts", file,
                                     in.pieces(), most_pieces));
    }
    std::vector<std::string> units;
    std::vector<std::size_t> costs;
    Rational q_lo = 0;
    Rational q_hi = 0;
    for (std::size_t i = 0; i < in.pieces(); ++i) {
        const collisions::Piece piece = in.next();
        q_lo = i == 0 ? piece.q_lo : q_lo;
        q_hi = piece.q_hi;
        units.push_back(fmt::format("piece {}", i + 1));
        const Count upper = std::min(piece.upper.value_or(0), Count(1'000'000'000));
        costs.push_back(static_cast<std::size_t>(upper) + 10);
        observer.update(i + 1, in.pieces(), std::nullopt);
    }
    observer.enter("computing its checksum", "");
    const Subject subject{std::string(file.ends_with(".gz") ? packed_name : certificate_name),
                          in.head().scene, certificates::sealed_digest(file, interrupted), in.pieces()};
    return {{fmt::format("verify {}{}", printable(std::filesystem::path(file).filename().string(), 100),
                         about(fmt::format("{}:{}", to_fraction(q_lo), to_fraction(q_hi)), subject)),
             {head_of(subject), std::move(units)},
             cut(costs, shards, collisions_per_shard),
             {subject.file, std::string(verifier_name)}},
            {file, verifier_path()}};
}

}  // namespace dumbbell::campaign
