#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "base/observer.hpp"
#include "collisions/certificate.hpp"
#include "number/rational.hpp"

/// The exact audit: do the leaves of each chart tile its root box, and the pieces the range of mass ratios?
/// It says nothing about the leaves' reasons; those are the verifier's.
namespace dumbbell::audit {

struct Audit {
    std::size_t pieces = 0;
    std::size_t charts = 0;         ///< trees audited
    std::size_t leaves = 0;         ///< of these trees
    std::size_t pairs = 0;          ///< candidate pairs compared exactly
    std::size_t equal_masses = 0;   ///< pieces without boxes: proved by lemma L7
    std::size_t without_cover = 0;  ///< pieces without boxes: they claim no upper bound

    /// One line for each thing that is wrong; names piece, chart and leaves by their numbers in the file,
    /// counted from 1.
    std::vector<std::string> faults;

    [[nodiscard]] bool tiles() const { return faults.empty(); }
};

/// The observer is told of the leaves that are done. Audits a certificate that claims the mass ratios
/// [claimed.first, claimed.second].
[[nodiscard]] Audit audit(const collisions::Certificate& certificate,
                          const std::pair<Rational, Rational>& claimed, Observer& observer = nobody);

/// Reads the file, then audits it in a phase of its own. Throws InputError if it cannot be read,
/// or its last line is not the checksum of its text, or this program was built without CGAL.
[[nodiscard]] Audit audit_file(const std::string& path, Observer& observer = nobody);

}  // namespace dumbbell::audit
