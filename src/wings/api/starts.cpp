#include "dumbbell/starts.hpp"

#include <algorithm>

#include "api/caller_stops.hpp"
#include "api/checked.hpp"
#include "api/exact_ratio.hpp"
#include "api/start.hpp"
#include "api/translate.hpp"
#include "file/limits.hpp"
#include "starts/answer/mean.hpp"
#include "starts/answer/shares.hpp"
#include "starts/answer/trace.hpp"
#include "starts/answer/writer.hpp"
#include "starts/cover/incoming.hpp"
#include "starts/cover/subdivide.hpp"

namespace dumbbell::api {
inline namespace DUMBBELL_ABI {
namespace {

void add_shares(StartsProof& proof, const starts::PackedTree& tree) {
    for (const starts::ShareBounds& share : share_bounds(tree)) {
        proof.shares.push_back({share.least, share.most, to_fraction(share.lo), to_fraction(share.hi)});
    }
    const starts::MeanBounds mean = mean_bounds(tree);
    proof.mean_lo = to_fraction(mean.lo);
    proof.mean_hi = mean.hi ? std::optional(to_fraction(*mean.hi)) : std::nullopt;
}

StartsProof proof_of(const starts::Box& box, bool incoming, const StartsOptions& options) {
    const int bits = incoming ? double_bits : std::min(starts::working_bits(options.digits), most_file_bits);
    const CallerStops stops(options.stopped);
    const starts::Subdivision parts = subdivide(
        box,
        starts::SubdivideOptions{.max_boxes = checked<std::size_t>("boxes", options.boxes, 1, most_parts),
                                 .jobs = checked_jobs(options.jobs),
                                 .incoming = incoming,
                                 .bits = bits,
                                 .interrupted = deadline(options.budget)});
    StartsProof proof;
    proof.least = parts.least;
    proof.most = parts.most;
    proof.undecided = to_fraction(parts.undecided.share);
    add_shares(proof, parts.tree);
    const starts::Certificate frame{.box = box, .bits = parts.bits, .tree = {}, .incoming = incoming};
    proof.demand = claim_options(incoming, box, parts.least, parts.most, Rational(1) - parts.undecided.share);
    proof.sha256 = render(frame, parts.tree, [&](std::string_view part) { proof.certificate.append(part); });
    return proof;
}

}  // namespace

StartsProof certify_starts(const MassRatio& ratio, const InitialCondition& box,
                           const StartsOptions& options) {
    return guarded([&] {
        const int bits = std::min(starts::bits_of_bounds(checked_digits(options.digits)), most_angle_bits);
        return proof_of(start_of(ratio, box, bits), false, options);
    });
}

StartsProof certify_incoming(const MassRatio& ratio, const StartsOptions& options) {
    return guarded([&] {
        return proof_of(starts::incoming_box(single_ratio(ratio, "certify_incoming")), true, options);
    });
}

Interval mean_collisions(const MassRatio& ratio) {
    return guarded([&]() -> Interval {
        const starts::ExactMean mean = starts::exact_mean(single_ratio(ratio, "mean_collisions"));
        return {mean.all.lo(), mean.all.hi()};
    });
}

}  // namespace DUMBBELL_ABI
}  // namespace dumbbell::api
