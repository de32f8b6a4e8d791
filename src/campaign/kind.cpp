#include "campaign/kind.hpp"

#include <fmt/core.h>

#include <array>
#include <fstream>

#include "base/error.hpp"
#include "base/printable.hpp"
#include "campaign/kinds/kinds.hpp"
#include "file/verifier_program.hpp"

namespace dumbbell::campaign {
namespace {

/// Whether it begins as gzip does: a reader would unpack up to a thousand times its size.
bool is_packed(const std::string& file) {
    std::array<char, 2> first{};
    std::ifstream(file, std::ios::binary).read(first.data(), first.size());
    return first[0] == '\x1f' && first[1] == '\x8b';
}

}  // namespace

Judgement Kind::judge(const Order& order, const std::string& folder, const std::string& file,
                      Scrutiny scrutiny) const {
    try {
        if (is_packed(file)) {
            return {Judgement::Verdict::wrong, "it is compressed, and results are plain text"};
        }
        Judgement looks = form(order, file);
        if (looks.verdict == Judgement::Verdict::wrong || scrutiny == Scrutiny::form) {
            return looks;
        }
        const std::string reason = refutation(order, folder, file);
        return reason.empty() ? looks : Judgement{Judgement::Verdict::wrong, reason};
    } catch (const NoVerdict& error) {
        return {Judgement::Verdict::none, error.what()};
    } catch (const InputError& error) {
        return {Judgement::Verdict::wrong, error.what()};
    }
}

void Kind::require_tiling(bool tiles) {
    if (!tiles) {
        throw InputError("the results do not tile the claim: run the campaign again, and merge then");
    }
}

std::string Kind::refuted(const std::string& demand, const std::string& file) {
    const Verdict verdict =
        ask_verifier({"--jobs=1", "--quiet", "--budget=10h", "--max-bits=4096", demand, "--", file});
    return verdict.accepts ? "" : fmt::format("not verified: {}", verdict.line);
}

const Kind& kind_named(std::string_view name) {
    if (name == "adiabatic") {
        return adiabatic_kind();
    }
    if (name == "collisions") {
        return collisions_kind();
    }
    if (name == "critical") {
        return critical_kind();
    }
    if (name == "verified") {
        return verified_kind();
    }
    throw InputError(fmt::format("there are no campaigns of the kind '{}'", printable(name, 40)));
}

}  // namespace dumbbell::campaign
