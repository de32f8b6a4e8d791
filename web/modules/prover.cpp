// The prover of `dumbbell certify`, and what the page shows of a certificate, as a WebAssembly module.
#include "base/error.hpp"
#include "collisions/certify.hpp"
#include "collisions/claim.hpp"
#include "collisions/writer.hpp"
#include "number/ratio_argument.hpp"
#include "page/data.hpp"
#include "system.hpp"

namespace dumbbell {
namespace {

using collisions::Claim;

/// Of the page: how many parts of all are done.
extern "C" __attribute__((import_module("page"), import_name("progress"))) void show_progress(double done,
                                                                                              double total);
class Page : public Observer {
    void update(std::size_t done, std::size_t total, std::optional<long> /*count*/) override {
        show_progress(static_cast<double>(done), static_cast<double>(total));
    }
};

/// `ratio RATIO`, `rod RATIO MASS` or `body RHO INERTIA`, a word a line.
Claim claim_in(const std::vector<std::string>& words) {
    require(words.size() >= 2, "the page asks for no claim");
    const auto& [kind, first, second] = std::tuple(words[0], words[1], words.back());
    if (kind == "body") return collisions::claim_of_body(first, second);
    const RatioArgument ratio = parse_ratio_argument(first);
    if (kind == "ratio") return {.range = {ratio.lo, ratio.hi}};
    if (ratio.lo != ratio.hi)
        throw InputError("with a mass of the rod one mass ratio is asked for, not a range");
    return claim_of(collisions::Rod{ratio.lo, parse_number("the rod's mass", second)});
}

/// Longer proofs are the program's: here a number of collisions has 32 bits, and one core works.
bool is_short(const Claim& claim) {
    return claim.range.hi <= (claim.range.is_single() ? 1'000'000'000 : 1000);
}

Json certified() {
    Claim claim = claim_in(words_given());
    if (claim.range.is_single()) claim.gap = 0;  // there is none to be named
    if (const auto reason = out_of_reach(claim)) throw InputError(*reason);
    Json json = Json::object({{"command", command(claim)}});
    if (!is_short(claim)) {
        json.add("why", "this page proves single ratios up to 10^9, and ranges up to 1:1000");
        return json;
    }
    Page page;
    const auto proved = collisions::certify(
        {.claim = claim, .budget = std::chrono::seconds(30), .describes = false, .observer = &page});
    std::vector<const collisions::Piece*> pieces;
    for (const collisions::ProvedPiece& each : proved) {
        pieces.push_back(&each.piece);
        if (each.piece.status() == collisions::Status::open) {
            const bool is_late = each.obstacle == collisions::Obstacle::time;
            json.add("why", is_late ? "30 seconds did not suffice" : "the search came to no proof");
            return json;
        }
    }
    json.add("certificate", render({.pieces = {}, .system = claim.system}, pieces).text);
    json.add("claim", options_to_check(claim, pieces));
    return json;
}

/// Of a file: its name, a line feed, its bytes.
Json shown() {
    constexpr std::size_t most_boxes = 200'000;
    const std::size_t end = room.find('\n');
    return page::page_data({page::read_reported(room.substr(0, end), room.substr(end + 1), false)},
                           most_boxes);
}

template <Json (*make)()>
std::string answer() try {
    return make().text();
} catch (const InputError& error) {
    return Json::object({{"usage", error.what()}}).text();
}

}  // namespace
}  // namespace dumbbell

extern "C" {
__attribute__((export_name("certify"))) const char* certify() {
    return answered(dumbbell::answer<dumbbell::certified>);
}
__attribute__((export_name("show"))) const char* show() {
    return answered(dumbbell::answer<dumbbell::shown>);
}
}
