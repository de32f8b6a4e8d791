// dumbbell-verify: verifies files and prints what came out.
#include <algorithm>
#include <cstdio>
#include <stdexcept>

#include "options.hpp"

namespace dumbbell_verify {
namespace {

constexpr const char* names[] = {"VERIFIED", "UNREADABLE", "UNSUPPORTED", "LIMIT", "REJECTED"};
constexpr int exit_codes[] = {0, 2, 3, 4, 1};

struct Result {
    std::string file;
    Failure why{Verdict::verified, 0, "", ""};
    Proof proof;
};

Result examine(const std::string& file, const Settings& settings) {
    Result result;
    result.file = file;
    try {
        result.proof = verify(file, settings);
        if (!settings.explain.empty() && !result.proof.explained)
            result.why = {Verdict::unreadable, 0, "usage", "there is no leaf " + settings.explain};
    } catch (const Failure& failure) {
        result.why = failure;
    } catch (const std::exception& error) {  // out of memory, no more threads
        result.why = {Verdict::limit, 0, "limit", error.what()};
    }
    return result;
}

std::string claim_text(const Proof& proof, const Settings& settings) {
    if (proof.initial) return proof.initial->text();
    const Collisions& claim = proof.claim;
    return "scene=" + settings.scene + " ratio=" + to_string(claim.lo) + ":" + to_string(claim.hi) +
           " upper=" + (claim.upper ? std::to_string(*claim.upper) : "none") +
           " lower=" + std::to_string(claim.lower) + " gaps=" + std::to_string(claim.gaps) +
           " open=" + std::to_string(claim.open);
}

void print(const Result& r, const Settings& settings) {
    std::string text;
    std::printf("%s\n", r.file.c_str());
    if (r.why.verdict == Verdict::verified) {
        for (const Tally& t : r.proof.tallies)
            std::printf("  %-15s%12s line(s)%11.5f %% of the root boxes\n", std::string(t.name).c_str(),
                        std::to_string(t.lines).c_str(), 100 * t.covered / std::max(1.0, r.proof.roots));
        text = " " + claim_text(r.proof, settings) + (r.proof.heavy_once ? " heavy-at-most=1" : "") +
               " sha256=" + r.proof.digest;
    } else {
        if (r.why.line > 0) text = " line=" + std::to_string(r.why.line);
        if (r.why.verdict == Verdict::rejected) text += " code=" + r.why.code;
        text += " " + r.why.text;
    }
    std::printf("s %s%s\n", names[static_cast<int>(r.why.verdict)], text.c_str());
}

std::string quoted(std::string_view text) {
    std::string result = "\"";
    for (const char c : text) {
        char code[8] = {c};
        if (c < 0x20 || c > 0x7e || c == '"' || c == '\\')
            std::snprintf(code, sizeof code, "\\u%04x", static_cast<unsigned>(static_cast<unsigned char>(c)));
        result += code;
    }
    return result + "\"";
}

std::string json(const Result& r, const Settings& settings) {
    const Collisions& claim = r.proof.claim;
    const bool verified = r.why.verdict == Verdict::verified;
    const auto unless = [](bool absent, const std::string& text) { return absent ? "null" : quoted(text); };
    const auto number = [](const char* name, std::uint64_t n) {
        return quoted(name) + ":" + std::to_string(n) + ",";
    };
    std::string leaves, coverage, said = "null,";
    for (const Tally& t : r.proof.tallies) {
        const std::string name = (leaves.empty() ? "" : ",") + quoted(t.name) + ":";
        leaves += name + std::to_string(t.lines);
        coverage += name + std::to_string(t.covered / std::max(1.0, r.proof.roots));
    }
    if (verified && r.proof.initial)
        said = r.proof.initial->json() + ",";
    else if (verified)
        said = "{\"scene\":" + quoted(settings.scene) + ",\"ratio\":{\"lo\":" + quoted(to_string(claim.lo)) +
               ",\"hi\":" + quoted(to_string(claim.hi)) + "}," +
               (claim.upper ? number("upper", *claim.upper) : "\"upper\":null,") +
               number("lower", claim.lower) + number("pieces", claim.pieces) + number("gaps", claim.gaps) +
               number("open", claim.open) + "\"heavy_at_most\":" + (r.proof.heavy_once ? "1" : "null") + "},";
    return "{\"file\":" + quoted(r.file) + ",\"verdict\":" + quoted(names[static_cast<int>(r.why.verdict)]) +
           ",\"claim\":" + said + "\"sha256\":" + unless(!verified, r.proof.digest) + ",\"leaves\":{" +
           leaves + "},\"coverage\":{" + coverage +
           "},\"line\":" + (r.why.line > 0 ? std::to_string(r.why.line) : "null") +
           ",\"code\":" + unless(verified, r.why.code) + ",\"reason\":" + unless(verified, r.why.text) + "}";
}

/// Both files are verified; only then are they compared. The verdict of the whole is the only line with `s`.
int run_lemma(const Options& options) {
    Result results[2];
    for (int i = 0; i < 2; ++i) {
        Settings settings = options.settings;
        settings.scene = i == 0 ? options.lemma->scene_a : options.lemma->scene_b;
        const Result& r = results[i] = examine(options.files[i], settings);
        if (r.why.verdict == Verdict::verified)
            std::printf("%s\n  %s sha256=%s\n", r.file.c_str(), claim_text(r.proof, settings).c_str(),
                        r.proof.digest.c_str());
    }
    const Result& worst = results[results[1].why.verdict > results[0].why.verdict];
    Verdict verdict = worst.why.verdict;
    std::string text = "lemma=" + std::string(options.lemma->name) + " " + worst.file +
                       " line=" + std::to_string(worst.why.line) + " " + worst.why.text;
    if (verdict == Verdict::verified) {
        const Comparison found = compare(*options.lemma, results[0].proof.claim, results[1].proof.claim);
        verdict = found.holds ? Verdict::verified : Verdict::rejected;
        text = found.text;
    }
    std::printf("s %s %s\n", names[static_cast<int>(verdict)], text.c_str());
    return exit_codes[static_cast<int>(verdict)];
}

int run(int argc, char** argv) {
    const Options options = parse_options(argc, argv);
    std::fputs(options.answer.c_str(), stdout);
    if (!options.answer.empty()) return 0;
    if (options.lemma) return run_lemma(options);
    Verdict worst = Verdict::verified;
    for (const std::string& file : options.files) {
        const Result result = examine(file, options.settings);
        worst = std::max(worst, result.why.verdict);
        if (options.json) {
            std::printf("%s%s", &file == options.files.data() ? "[" : ",\n",
                        json(result, options.settings).c_str());
        } else {
            print(result, options.settings);
        }
    }
    if (options.json) std::puts("]");
    return exit_codes[static_cast<int>(worst)];
}

}  // namespace
}  // namespace dumbbell_verify

int main(int argc, char** argv) {
    try {
        const int code = dumbbell_verify::run(argc, argv);
        if (std::fflush(stdout) != 0) throw std::invalid_argument("cannot write to the standard output");
        return code;
    } catch (const std::invalid_argument& error) {
        std::fprintf(stderr, "dumbbell-verify: %s\n", error.what());
        return 2;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "dumbbell-verify: resource limit: %s\n", error.what());
        return 4;
    }
}
