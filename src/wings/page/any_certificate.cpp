#include "page/any_certificate.hpp"

#include <fmt/core.h>

#include "adiabatic/reader.hpp"
#include "base/error.hpp"
#include "collisions/reader.hpp"
#include "file/lines.hpp"
#include "starts/answer/reader.hpp"

namespace dumbbell::page {

AnyCertificate read_any_certificate(const NamedFile& file) {
    const Head head = Lines(file).expect_head();
    const std::string& claim = head.claim;
    if (claim == "initial-conditions" || claim == "incoming") {
        return starts::read_certificate(file);
    }
    if (claim.starts_with("adiabatic-")) {
        return adiabatic::read_certificate(file);
    }
    if (claim == "law") {
        throw InputError(
            fmt::format("'{}' is about the law for every mass ratio (dumbbell law): no page and no picture "
                        "shows that; dumbbell verify checks it",
                        file.path));
    }
    if (head.section == "cells") {
        throw InputError(
            fmt::format("'{}' is about a rectangle of bodies: no page shows that; dumbbell plot "
                        "body draws it, dumbbell verify checks it",
                        file.path));
    }
    return collisions::read_certificate(file);
}

}  // namespace dumbbell::page
