#include <fmt/core.h>

#include <algorithm>

#include "base/error.hpp"
#include "base/fields.hpp"
#include "campaign/kinds/kinds.hpp"
#include "certificates/any_reader.hpp"
#include "collisions/names.hpp"
#include "collisions/reader.hpp"
#include "collisions/steps.hpp"
#include "collisions/writer.hpp"
#include "file/sealed_lines.hpp"

namespace dumbbell::campaign {

using collisions::Piece;
using collisions::PlannedPiece;
using collisions::Section;

namespace {

/// What all pieces have in common.
struct Common {
    collisions::Scene scene;
    Section section;
};

std::string head_of(const Common& common) {
    return fmt::format("prove collisions\nlemmas {}\nscene {}\nsection {}\n", lemma_set(common.section),
                       name(common.scene), name(common.section));
}

Common common_of(const Order& order) {
    const auto values = head_values(order, {"prove", "lemmas", "scene", "section"});
    const auto scene = collisions::scene_named(values[2]);
    const auto section = collisions::section_named(values[3], values[1]);
    if (!scene || !section || order.head != head_of({*scene, *section})) {
        throw InputError("the order asks for a scene, section or lemma set that this program does not know");
    }
    return {*scene, *section};
}

PlannedPiece parse_piece(const std::string& unit) {
    constexpr std::size_t longest = 10'000;  // a ratio of the command line as a fraction
    const auto fields = split(unit, ' ');
    if (fields.size() == 5 && fields[0] == "piece") {
        const PlannedPiece piece{parse_rational(fields[1], longest), parse_rational(fields[2], longest),
                                 static_cast<long>(parse_size(fields[3])),
                                 static_cast<long>(parse_size(fields[4]))};
        if (piece.q_lo >= 1 && piece.q_lo <= piece.q_hi &&
            !collisions::out_of_reach(piece.q_lo, piece.q_hi) && piece.lower >= 1 &&
            piece.lower <= piece.upper && words_of(piece) == unit) {
            return piece;
        }
    }
    throw InputError("the order has a piece that is none");
}

std::string certificate_of(const Common& common, std::vector<Piece> pieces) {
    return render(collisions::Certificate{
                      .pieces = std::move(pieces), .scene = common.scene, .section = common.section})
        .text;
}

/// Whether it is this one, decided or not.
bool is_piece(const Piece& piece, const PlannedPiece& planned) {
    return piece.upper ? planned_as(piece) == planned
                       : piece.q_lo == planned.q_lo && piece.q_hi == planned.q_hi;
}

bool is_open(const Piece& piece) { return piece.status() == collisions::Status::open; }

/// Orbits are followed to their end; a section of all states takes many more.
std::size_t cost_of(const PlannedPiece& piece, Section section) {
    constexpr std::size_t of_short_orbits = 10;
    const std::size_t orbits = section == Section::turning ? 1 : 100;
    return orbits * (static_cast<std::size_t>(piece.upper) + of_short_orbits);
}

/// The claim that pieces over this range prove; how wide its gaps are, which comes after it, is seen in
/// them.
std::string claim_of(const Common& common, const Rational& q_lo, const Rational& q_hi) {
    std::string text = fmt::format("certify {}:{} ", to_fraction(q_lo), to_fraction(q_hi));
    if (common.scene != collisions::Scene::dumbbell) {
        text += fmt::format("--scene {} ", name(common.scene));
    }
    if (common.section != Section::turning) {
        text += "--section full ";
    }
    if (common.section == Section::plain) {
        text += "--lemmas none ";
    }
    return text + "--gap ";
}

class CollisionsKind : public Kind {
  public:
    [[nodiscard]] Evidence evidence() const override { return Evidence::file; }

    [[nodiscard]] std::optional<std::string> work(const Order& order, const std::string& /*folder*/,
                                                  const Interrupted& interrupted) const override {
        const Common common = common_of(order);
        collisions::PieceOptions options = piece_options(common.scene, common.section);
        options.interrupted = interrupted;
        options.describes = false;
        std::vector<Piece> pieces;
        for (const std::string& unit : order.units) {
            const PlannedPiece planned = parse_piece(unit);
            collisions::ProvedPiece proved =
                prove_piece(planned.q_lo, planned.q_hi, planned.upper, planned.lower, options);
            if (proved.obstacle == collisions::Obstacle::time) {
                return std::nullopt;
            }
            pieces.push_back(std::move(proved.piece));
        }
        return certificate_of(common, std::move(pieces));
    }

    [[nodiscard]] Merged merge(const Plan& plan, const std::string& /*folder*/,
                               const std::vector<std::string>& files) const override {
        const Common common = common_of(plan.whole);
        std::vector<Piece> pieces;
        pieces.reserve(plan.whole.units.size());
        for (const std::string& file : files) {
            collisions::Certificate part = collisions::read_certificate(file);
            std::move(part.pieces.begin(), part.pieces.end(), std::back_inserter(pieces));
        }
        // They tile the claim: each piece of the plan once, in its order, each beginning where the last one
        // ended.
        const auto& units = plan.whole.units;
        bool tiles = pieces.size() == units.size() &&
                     plan.claim.starts_with(claim_of(common, pieces.front().q_lo, pieces.back().q_hi));
        for (std::size_t i = 0; tiles && i < pieces.size(); ++i) {
            tiles = is_piece(pieces[i], parse_piece(units[i])) &&
                    (i == 0 || pieces[i].q_lo == pieces[i - 1].q_hi);
        }
        require_tiling(tiles);
        const bool open = std::any_of(pieces.begin(), pieces.end(), is_open);
        return {certificate_of(common, std::move(pieces)), open};
    }

  private:
    [[nodiscard]] Judgement form(const Order& order, const std::string& file) const override {
        const Common common = common_of(order);
        (void)certificates::sealed_digest(file);  // it is complete
        collisions::PieceReader in(file, collisions::Trees::passed_over);
        bool fits = in.head().scene == common.scene && in.head().section == common.section &&
                    in.pieces() == order.units.size();
        bool open = false;
        for (std::size_t i = 0; fits && i < order.units.size(); ++i) {
            const Piece piece = in.next();
            fits = is_piece(piece, parse_piece(order.units[i]));
            open = open || is_open(piece);
        }
        if (!fits) {
            return {Judgement::Verdict::wrong, "it proves something else"};
        }
        return open ? Judgement{Judgement::Verdict::open, "a piece stays undecided"}
                    : Judgement{Judgement::Verdict::proved, ""};
    }

    [[nodiscard]] std::string refutation(const Order& order, const std::string& /*folder*/,
                                         const std::string& file) const override {
        return refuted(fmt::format("--scene={}", name(common_of(order).scene)), file);
    }
};

}  // namespace

const Kind& collisions_kind() {
    static const CollisionsKind kind;
    return kind;
}

std::optional<Plan> plan_collisions(const collisions::CertifyRequest& request,
                                    std::optional<std::size_t> shards, const Interrupted& interrupted) {
    if (request.q_lo == request.q_hi) {
        throw InputError("a single ratio is one shard: use dumbbell certify, or give a range LO:HI");
    }
    if (const auto reason = collisions::out_of_reach(request.q_lo, request.q_hi)) {
        throw InputError(*reason);
    }
    const auto pieces = plan_staircase(request.scene, request.q_lo, request.q_hi, request.gap, interrupted,
                                       *request.observer);
    if (pieces.empty()) {
        return std::nullopt;
    }
    const Common common{request.scene, request.section};
    Plan plan{claim_of(common, request.q_lo, request.q_hi) + to_fraction(request.gap),
              {head_of(common), {}},
              {},
              {}};
    std::vector<std::size_t> costs;
    for (const PlannedPiece& piece : pieces) {
        plan.whole.units.push_back(words_of(piece));
        costs.push_back(cost_of(piece, request.section));
    }
    plan.shards = cut(costs, shards, collisions_per_shard);
    return plan;
}

}  // namespace dumbbell::campaign
