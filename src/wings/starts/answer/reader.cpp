#include "starts/answer/reader.hpp"

#include <algorithm>

#include "file/limits.hpp"
#include "file/lines.hpp"
#include "starts/cover/incoming.hpp"

namespace dumbbell::starts {
namespace {

Node split_from(const Lines& lines, bool incoming, const std::string& axis) {
    const auto& names = incoming ? incoming_names : axis_names;
    const auto* const found = std::find(names.begin(), names.end(), axis);
    if (found == names.end() || axis.empty()) {
        lines.fail();
    }
    return {static_cast<Axis>(found - names.begin()), {}};
}

/// `open`, `exactly K [MASS T0 T1]`, `between A B [MASS T0 T1]`
Leaf leaf_from(const Lines& lines, const std::vector<std::string>& fields) {
    if (fields.size() == 1 && fields[0] == "open") {
        return {};
    }
    const std::size_t counts = fields[0] == "exactly" ? 1 : fields[0] == "between" ? 2 : 0;
    if (counts == 0 || (fields.size() != 1 + counts && fields.size() != 4 + counts)) {
        lines.fail();
    }
    Leaf leaf{lines.number(fields[1]), lines.number(fields[counts]), {}};
    if (fields.size() == 4 + counts) {
        const std::string& mass = fields[1 + counts];
        if (mass != "light" && mass != "heavy") {
            lines.fail();
        }
        leaf.first =
            FirstContact{mass == "heavy", lines.dyadic(fields[2 + counts]), lines.dyadic(fields[3 + counts])};
    }
    return leaf;
}

}  // namespace

Certificate read_certificate(const NamedFile& file) {
    Lines lines(file);
    const Head head = lines.expect_head();
    Certificate certificate;
    certificate.generator = head.generator;
    certificate.incoming = head.claim == "incoming";
    if (head.claim != "initial-conditions" && !certificate.incoming) {
        lines.fail();
    }
    // The ratio comes first, and of incoming trajectories there is nothing else.
    for (std::size_t i = 0; i < (certificate.incoming ? 1 : axis_count); ++i) {
        const std::size_t number = (i + 4) % axis_count;
        const auto& ends = lines.expect(i == 0 ? "ratio" : axis_names.at(number), 3);
        certificate.box.lo[number] = lines.signed_ratio(ends[1]);
        certificate.box.hi[number] = lines.signed_ratio(ends[2]);
        if (certificate.box.hi[number] < certificate.box.lo[number]) {
            lines.fail();
        }
    }
    if (certificate.incoming) {
        if (certificate.box.lo[4] != certificate.box.hi[4]) {
            lines.fail();
        }
        certificate.box = incoming_box(certificate.box.lo[4]);
    }
    certificate.bits =
        static_cast<int>(std::min(lines.number(lines.expect("bits", 2)[1]), long{most_file_bits}));
    lines.expect("between", 3);
    for (long missing = 1; missing > 0;) {
        const auto& fields = lines.next();
        const bool is_split = fields[0] == "split" && fields.size() == 2;
        certificate.tree.push_back(is_split ? split_from(lines, certificate.incoming, fields[1])
                                            : Node{{}, leaf_from(lines, fields)});
        missing += is_split ? 1 : -1;
    }
    certificate.sha256 = lines.digest();
    return certificate;
}

}  // namespace dumbbell::starts
