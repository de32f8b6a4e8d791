// Certificates of initial conditions as they are written, read by dumbbell-verify's own code.
#pragma once

#include <optional>

#include "rooms/verify/core/make_certificate.hpp"
#include "starts/answer/writer.hpp"
#include "starts/cover/subdivide.hpp"
#include "verify/program/verify.hpp"

namespace dumbbell_trace_test {

inline std::string written(const dumbbell::starts::Box& box, const dumbbell::starts::Subdivision& parts) {
    return render(dumbbell::starts::Certificate{.generator = {"dumbbell", "test"},
                                                .box = box,
                                                .bits = parts.bits,
                                                .tree = parts.tree.nodes()})
        .text;
}

/// What the verifier finds in this text, with the shares.
inline dumbbell_verify::starts::Claim checked(const std::string& text) {
    const make::File file(text);
    dumbbell_verify::Request settings;
    settings.shares = true;
    return dynamic_cast<const dumbbell_verify::starts::Claim&>(
        *dumbbell_verify::verify(file.path(), settings).other);
}

/// The leaves of a tree with their boxes.
template <class Use>
void for_each_leaf(const dumbbell::starts::PackedTree& tree, dumbbell::starts::Box root, const Use& use) {
    std::vector<dumbbell::starts::Box> boxes{std::move(root)};
    tree.for_each([&](const dumbbell::starts::Node& node) {
        auto here = std::move(boxes.back());
        boxes.pop_back();
        if (!node.split) {
            use(here, node.leaf);
            return;
        }
        const auto i = static_cast<std::size_t>(*node.split);
        auto lower = here;
        here.lo[i] = lower.hi[i] = (here.lo[i] + here.hi[i]) / 2;
        boxes.push_back(std::move(here));
        boxes.push_back(std::move(lower));
    });
}

/// What the verifier says of this text: its failure, or nothing.
inline std::string refusal(const std::string& text, dumbbell_verify::Verified* proof = nullptr) {
    const make::File file(text);
    try {
        dumbbell_verify::Request settings;
        settings.max_bits = 4096;
        auto found = dumbbell_verify::verify(file.path(), settings);
        if (proof != nullptr) {
            *proof = std::move(found);
        }
        return "";
    } catch (const dumbbell_verify::Failure& failure) {
        return "line " + std::to_string(failure.line) + ": " + failure.code + " " + failure.text;
    }
}

}  // namespace dumbbell_trace_test
