// Certificates of initial conditions as they are written, read by dumbbell-verify's own code.
#pragma once

#include <optional>

#include "rooms/verify/core/make_certificate.hpp"
#include "starts/subdivide.hpp"
#include "starts/writer.hpp"
#include "verify/program/verify.hpp"

namespace dumbbell_trace_test {

inline std::string written(const dumbbell::starts::Box& box, const dumbbell::starts::Subdivision& parts) {
    return render(dumbbell::starts::Certificate{.generator = {"dumbbell", "test"},
                                                .box = box,
                                                .bits = parts.bits,
                                                .tree = parts.tree.nodes()})
        .text;
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
