#include "cli/commands/open_pieces.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "collisions/section.hpp"
#include "file/dyadic.hpp"

namespace dumbbell::cli {

using collisions::CertifyRequest;
using collisions::Obstacle;
using collisions::ProvedPiece;

namespace {

bool is_range(const CertifyRequest& request) { return !request.claim.range.is_single(); }

/// What hinders the first open piece that was not only late; else time.
Obstacle worst_obstacle(const std::vector<ProvedPiece>& pieces) {
    const auto found = std::ranges::find_if(pieces, [](const ProvedPiece& p) {
        return p.obstacle != Obstacle::none && p.obstacle != Obstacle::time;
    });
    return found == pieces.end() ? Obstacle::time : found->obstacle;
}

/// Plain intervals meet the states that only just miss the floor in ever smaller boxes.
std::string plain_advice(const CertifyRequest& request) {
    const Rational widest(1, 100);
    if (!is_range(request)) {
        return ": --section plain needs many boxes, the more the nearer a step of the maximum is: leave it "
               "out, "
               "or allow more time (--budget)";
    }
    return request.claim.gap < widest
               ? ": --section plain needs boxes in inverse proportion to the gap: try --gap 0.01"
               : ": allow more time (--budget), a shorter range, or leave --section plain out";
}

std::string reason(const CertifyRequest& request, Obstacle obstacle) {
    const collisions::System& system = request.claim.system;
    if (row_of(system.section).section == "plain" &&
        (obstacle == Obstacle::time || obstacle == Obstacle::boxes)) {
        return plain_advice(request);
    }
    const char* wider = is_range(request) ? ": try a wider --gap" : "";
    const int most_bits = piece_options(system).max_bits;
    switch (obstacle) {
        case Obstacle::maximum:
            return fmt::format(": {} bits do not tell it from a critical ratio", most_bits);
        case Obstacle::witness:
            return fmt::format(
                ": found no orbit with so many collisions that fits a certificate ({} binary places) and "
                "that {} bits can follow{}",
                most_binary_places, most_bits, wider);
        case Obstacle::boxes:
            return fmt::format(": too many boxes, even with {} bits{}", most_bits, wider);
        default:
            return fmt::format(": allow more time (--budget){}",
                               is_range(request) ? ", or a wider --gap" : "");
    }
}

std::ptrdiff_t finished(const std::vector<ProvedPiece>& pieces) {
    return std::ranges::count_if(pieces, [](const ProvedPiece& p) { return p.piece.upper.has_value(); });
}

}  // namespace

std::string advice(const CertifyRequest& request, const std::vector<ProvedPiece>& pieces,
                   const std::optional<KeptPieces>& kept) {
    return fmt::format(
        "{}{}{}", is_range(request) ? "not everything was decided" : "not decided",
        reason(request, worst_obstacle(pieces)),
        !kept || kept->number == 0
            ? ""
            : fmt::format("; the same command goes on with the finished pieces in '{}'", kept->folder));
}

std::string kept_when_stopped(const CertifyRequest& request, const std::vector<ProvedPiece>& pieces,
                              const std::optional<KeptPieces>& kept) {
    if (!is_range(request)) {
        return request.claim.system.rho ? "nothing is kept of a single body"
                                        : "nothing is kept of a single ratio";
    }
    const auto now = finished(pieces);
    if (now == 0 && (!kept || kept->number == 0)) {
        return "no piece was finished yet";
    }
    const std::string so_many = fmt::format("{} pieces", now == 0 ? kept->number : now);
    return !kept ? fmt::format("{} were finished, and are lost: with --out FILE they are kept", so_many)
                 : fmt::format("{} are finished and kept in '{}': the same command goes on with them",
                               so_many, kept->folder);
}

}  // namespace dumbbell::cli
