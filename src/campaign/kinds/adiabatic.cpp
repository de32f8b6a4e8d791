#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "adiabatic/case.hpp"
#include "adiabatic/prove.hpp"
#include "adiabatic/reader.hpp"
#include "adiabatic/writer.hpp"
#include "base/error.hpp"
#include "campaign/kinds/kinds.hpp"
#include "certificates/any_reader.hpp"
#include "number/decimal.hpp"

namespace dumbbell::campaign {

using adiabatic::AdiabaticHypotheses;

namespace {

std::string head_of(const Rational& accuracy) {
    return fmt::format("prove adiabatic\naccuracy {}\n", to_fraction(accuracy));
}

Rational accuracy_of(const Order& order) {
    constexpr std::size_t longest = 10'000;
    Rational accuracy = parse_rational(head_values(order, {"prove", "accuracy"})[1], longest);
    if (accuracy <= 0 || accuracy > 1 || order.head != head_of(accuracy)) {
        throw InputError("the order asks for an accuracy that this program does not know");
    }
    return accuracy;
}

AdiabaticHypotheses statement_of(const Order& order) {
    if (order.units.size() != 1) {
        throw InputError("the order has several statements: a certificate proves one");
    }
    return adiabatic::parse_case(order.units.front());
}

/// About, in proportion to what docs/6-adiabatic.md measured.
std::size_t cost_of(const AdiabaticHypotheses& of) {
    if (of.claim == adiabatic::AdiabaticClaim::bounce || of.claim == adiabatic::AdiabaticClaim::printed) {
        return 1;
    }
    constexpr int greatest = 1000;
    constexpr std::size_t of_a_range = 4;
    const Rational far = of.claim == adiabatic::AdiabaticClaim::run ? 11 : 50;
    const Rational cost = std::min(Rational(far / of.margin), Rational(greatest));
    return static_cast<std::size_t>(cost.convert_to<double>()) *
           (of.delta.first < of.delta.second ? of_a_range : 1);
}

constexpr std::string_view table_head =
    "# Constants of the adiabatic invariant: each line is a statement of dumbbell adiabatic. Its errors are "
    "at "
    "most C1 (and C2),\n"
    "# in its units, and enclosed orbits attain at least B1 (and B2). A certificate proves one statement, so "
    "this table proves\n"
    "# nothing: each line has a certificate of its own in the campaign's folder, which dumbbell-verify "
    "accepts; "
    "sha256 is the\n"
    "# one in its last line.\n"
    "# theorem\tdelta_lo\tdelta_hi\ty_lo\ty_hi\tmargin\tk\tC1\tC2\tB1\tB2\tsha256\tcertificate\n";

/// Exactly.
std::string cell(const Rational& x) { return x == 0 ? "0" : exact_text(x); }

std::string line_of(const adiabatic::AdiabaticCertificate& certificate, const std::string& digest,
                    const std::string& file) {
    std::vector<std::string> cells = columns_of(certificate.hypotheses);
    for (std::size_t i = 0; i < 2; ++i) {
        cells.push_back(i < certificate.bounds.size() ? cell(certificate.bounds[i]) : "-");
    }
    for (std::size_t i = 0; i < 2; ++i) {
        cells.push_back(i < certificate.attained.size() ? cell(certificate.attained[i].value) : "-");
    }
    return fmt::format("{}\t{}\t{}\n", fmt::join(cells, "\t"), digest, file);
}

std::string claim_of(const std::vector<AdiabaticHypotheses>& grid, const Rational& accuracy) {
    return fmt::format("adiabatic {} --accuracy {}", options_of(grid), cell(accuracy));
}

class AdiabaticKind : public Kind {
  public:
    [[nodiscard]] Evidence evidence() const override { return Evidence::results; }

    [[nodiscard]] std::optional<std::string> work(const Order& order, const std::string& /*folder*/,
                                                  const Interrupted& interrupted) const override {
        adiabatic::AdiabaticRequest request;
        request.of = statement_of(order);
        request.accuracy = accuracy_of(order);
        request.interrupted = interrupted;
        const adiabatic::AdiabaticProof proof = prove_adiabatic(request);
        if (interrupted()) {
            return std::nullopt;  // even of a complete proof: a search that ended early finds other orbits
        }
        if (!proof.complete()) {
            throw InputError(
                fmt::format("not certified: adiabatic {}; take a smaller delta (or range of them), a greater "
                            "--phi-margin or a higher --y",
                            adiabatic::options_of({request.of})));
        }
        return render(certificate_of(proof)).text;
    }

    [[nodiscard]] Merged merge(const Plan& plan, const std::string& /*folder*/,
                               const std::vector<std::string>& files) const override {
        const auto& units = plan.whole.units;
        bool tiles = files.size() == units.size();
        std::string text(table_head);
        std::vector<AdiabaticHypotheses> proved;
        for (std::size_t i = 0; tiles && i < files.size(); ++i) {
            const adiabatic::AdiabaticCertificate certificate =
                adiabatic::read_adiabatic_certificate(files[i]);
            tiles = case_of(certificate.hypotheses) == units[i];
            proved.push_back(certificate.hypotheses);
            text += line_of(certificate, certificates::sealed_digest(files[i]),
                            "results/" + plan.order(i, i + 1).id());
        }
        require_tiling(tiles && plan.claim == claim_of(proved, accuracy_of(plan.whole)));
        return {text, false};
    }

  private:
    [[nodiscard]] Judgement form(const Order& order, const std::string& file) const override {
        (void)certificates::sealed_digest(file);  // it is complete
        if (case_of(adiabatic::read_adiabatic_hypotheses(file)) != case_of(statement_of(order))) {
            return {Judgement::Verdict::wrong, "it proves something else"};
        }
        return {Judgement::Verdict::proved, ""};
    }

    [[nodiscard]] std::string refutation(const Order& order, const std::string& /*folder*/,
                                         const std::string& file) const override {
        return refuted(fmt::format("--claim={}", name(statement_of(order).claim)), file);
    }
};

}  // namespace

const Kind& adiabatic_kind() {
    static const AdiabaticKind kind;
    return kind;
}

Plan plan_adiabatic(const std::vector<AdiabaticHypotheses>& grid, const Rational& accuracy) {
    if (grid.size() == 1) {
        throw InputError(
            "a single statement is one shard: use dumbbell adiabatic --out, or give a list (--delta, "
            "--phi-margin, --k)");
    }
    Plan plan{claim_of(grid, accuracy), {head_of(accuracy), {}}, {}, {}};
    std::set<std::string> known;
    for (const AdiabaticHypotheses& of : grid) {
        const std::size_t number = plan.whole.units.size();
        plan.whole.units.push_back(case_of(of));
        plan.shards.push_back({number, number + 1, cost_of(of)});
        if (!known.insert(plan.whole.units.back()).second) {
            throw InputError(
                fmt::format("the lists have a statement twice: {}", adiabatic::options_of({of})));
        }
    }
    return plan;
}

}  // namespace dumbbell::campaign
