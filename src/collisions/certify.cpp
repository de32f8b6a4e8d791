#include "collisions/certify.hpp"

#include <fmt/core.h>

#include <atomic>
#include <cmath>

#include "base/deadline.hpp"
#include "base/printable.hpp"
#include "collisions/body/halving.hpp"
#include "collisions/plan.hpp"
#include "collisions/scene.hpp"
#include "number/decimal.hpp"
#include "number/parallel.hpp"
#include "number/self_test.hpp"

namespace dumbbell::collisions {
namespace {

using Clock = std::chrono::steady_clock;

/// Not even begun.
ProvedPiece open_piece(const Rational& q_lo, const Rational& q_hi) {
    ProvedPiece open;
    open.piece.q_lo = q_lo;
    open.piece.q_hi = q_hi;
    open.obstacle = Obstacle::time;
    return open;
}

template <class Prove>
ProvedPiece timed(Prove prove) {
    const auto start = Clock::now();
    ProvedPiece proved = prove();
    proved.seconds = std::chrono::duration<double>(Clock::now() - start).count();
    return proved;
}

/// From the store if it has the piece; else proved, and kept if that came to its end.
ProvedPiece prove_or_recall(const PlannedPiece& planned, const CertifyRequest& request,
                            const PieceOptions& options) {
    const PieceStore* store = request.store;
    auto kept = store ? store->find(planned, *request.observer) : std::nullopt;
    const bool late = options.interrupted();
    if (kept) {
        ProvedPiece recalled;
        recalled.piece = std::move(*kept);
        if (!late && options.describes) {
            describe_witness(recalled);
        }
        return recalled;
    }
    if (late) {
        return open_piece(planned.q_lo, planned.q_hi);
    }
    ProvedPiece proved = prove_piece(planned.q_lo, planned.q_hi, planned.upper, planned.lower, options);
    if (store && proved.piece.upper) {
        store->keep(proved.piece);
    }
    return proved;
}

/// The pieces with which the range begins that an earlier run has finished: their steps need not be looked
/// for again.
std::vector<ProvedPiece> recalled_beginning(const CertifyRequest& request, const PieceOptions& options) {
    std::vector<ProvedPiece> recalled;
    for (Piece& piece : request.store ? request.store->beginning() : std::vector<Piece>()) {
        recalled.emplace_back().piece = std::move(piece);
        if (options.describes && !options.interrupted()) {
            describe_witness(recalled.back());
        }
    }
    return recalled;
}

/// Symmetric bodies step where the wedges do (L72).
Scene staircase_of(const CertifyRequest& request) {
    const bool is_symmetric = request.heights && request.heights->lo == 1;
    return is_symmetric ? Scene::wedge : request.scene;
}

std::vector<ProvedPiece> prove_in_halves(const CertifyRequest& request, PieceOptions options) {
    options.max_nodes = 1'000'000;  // before it is halved
    const auto& bounds = std::get<BoundSearch<Interval>>(row_of(request.scene).bounds);
    const auto prove = [&](const Rational& q_lo, const Rational& q_hi, long upper, long lower) {
        request.observer->advance(1);
        return options.interrupted() ? open_piece(q_lo, q_hi)
                                     : timed([&] { return prove_piece(q_lo, q_hi, upper, lower, options); });
    };
    const auto maximum = [&](const Rational& q) {
        return options.interrupted() ? std::nullopt : bounds.maximum(q, options.heights, options.interrupted);
    };
    return prove_halved(request.q_lo, request.q_hi, {maximum, prove, request.gap});
}

/// Steps are looked for, and pieces proved between them, part by part: what is found in time is not lost.
std::vector<ProvedPiece> prove_range(const CertifyRequest& request, const PieceOptions& options) {
    std::vector<ProvedPiece> pieces = recalled_beginning(request, options);
    std::atomic<std::size_t> finished = pieces.size();
    Observer* looking = request.observer;
    while (pieces.empty() || pieces.back().piece.q_hi < request.q_hi) {
        const Rational from = pieces.empty() ? request.q_lo : pieces.back().piece.q_hi;
        const Plan plan = plan_staircase(staircase_of(request), from, request.q_hi, request.gap,
                                         options.interrupted, *looking);
        if (plan.pieces.empty()) {
            pieces.push_back(open_piece(from, request.q_hi));
            break;
        }
        request.observer->enter("proving", "pieces");
        looking = &nobody;
        const std::size_t before = pieces.size();
        pieces.resize(before + plan.pieces.size());
        const std::size_t total = pieces.size() + 2 * plan.steps_beyond;
        in_parallel(plan.pieces.size(), [&](std::size_t i) {
            const PlannedPiece& planned = plan.pieces[i];
            pieces[before + i] = timed([&] { return prove_or_recall(planned, request, options); });
            request.observer->update(++finished, total, planned.upper);
        });
    }
    return pieces;
}

}  // namespace

bool fit_a_line(const Rational& x, const Rational& y) {
    constexpr std::size_t most = 4084;  // of 4096 bytes, without the line's word
    return to_fraction(x).size() + to_fraction(y).size() <= most;
}

std::optional<std::string> out_of_reach(const Rational& q_lo, const Rational& q_hi, Scene scene,
                                        Section section) {
    constexpr int common = SceneRow{}.most_digits;
    const bool single = q_lo == q_hi && section == Section::turning;
    const int most = single ? row_of(scene).most_digits : common;
    const bool far = most > common;
    if (!fit_a_line(q_lo, q_hi)) {
        return fmt::format("{} is too long for a line of a certificate: write fewer digits",
                           printable(exact_text(q_lo), 40));
    }
    if (q_hi <= Rational(pow(Integer(10), static_cast<unsigned>(most)))) {
        return std::nullopt;
    }
    const std::string q = exact_text(q_hi);
    if (scene == Scene::body) {
        return fmt::format("Q = {} is beyond 10^{}, the greatest that is tried", printable(q, 40), most);
    }
    return fmt::format(
        "the mass ratio {} is beyond 10^{}, the greatest that is tried{}: one orbit has about 10^{} "
        "collisions there{}",
        printable(q, 40), most, far ? "" : " except for a single ratio of the dumbbell (section turning)",
        most / 2,
        far ? "; what the law for every mass ratio says: dumbbell law --ratio " +
                  (q.size() > 40 ? "RATIO" : q)
            : "");
}

std::vector<ProvedPiece> certify(const CertifyRequest& request) {
    require_sound_arithmetic();
    if (out_of_reach(request.q_lo, request.q_hi, request.scene, request.section)) {
        return {open_piece(request.q_lo, request.q_hi)};
    }
    PieceOptions options = piece_options(request.scene, request.section);
    options.describes = request.describes && row_of(request.scene).has_orbits;
    options.heights = request.heights;
    options.interrupted = deadline(request.budget);
    return with_threads(request.jobs, [&]() -> std::vector<ProvedPiece> {
        if (request.q_lo == request.q_hi) {
            options.parallel = true;
            options.observer = request.observer;
            std::vector<ProvedPiece> alone;  // moved to: its trees can be large
            alone.push_back(options.interrupted() ? open_piece(request.q_lo, request.q_hi) : timed([&] {
                return prove_single(request.q_lo, options);
            }));
            return alone;
        }
        return row_of(staircase_of(request)).step ? prove_range(request, options)
                                                  : prove_in_halves(request, options);
    });
}

Rational undecided_share(const std::vector<ProvedPiece>& pieces) {
    const Rational whole = pieces.back().piece.q_hi - pieces.front().piece.q_lo;
    if (whole == 0) {
        return pieces.front().piece.status() == Status::exact ? 0 : 1;
    }
    Rational undecided = 0;
    for (const ProvedPiece& proved : pieces) {
        if (proved.piece.status() != Status::exact) {
            undecided += proved.piece.q_hi - proved.piece.q_lo;
        }
    }
    return undecided / whole;
}

}  // namespace dumbbell::collisions
