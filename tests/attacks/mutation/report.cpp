#include "report.hpp"

#include <fmt/format.h>

namespace dumbbell_mutation {
namespace {

std::size_t count(const std::map<Fate, std::size_t>& fates, Fate fate) {
    const auto found = fates.find(fate);
    return found == fates.end() ? 0 : found->second;
}

}  // namespace

std::size_t Report::Row::tried() const {
    std::size_t sum = 0;
    for (const auto& [fate, number] : fates) sum += number;
    return sum;
}
void Report::Row::add(const Row& other) {
    for (const auto& [fate, number] : other.fates) fates[fate] += number;
    other_verdicts += other.other_verdicts;
    stale += other.stale;
}
std::string Report::Row::text() const {
    std::string line = fmt::format("{}", tried());
    for (std::size_t i = 0; i < std::size(fate_names); ++i)
        line += fmt::format("\t{}", count(fates, static_cast<Fate>(i)));
    return line + fmt::format("\t{}\t{}\n", other_verdicts, stale);
}

void Report::add(const Base& base, const std::vector<Trial>& trials, const std::vector<Result>& results) {
    for (std::size_t i = 0; i < trials.size(); ++i) {
        const Trial& trial = trials[i];
        const Result& r = results[i];
        Row& row = rows_[{base.name, trial.kind}];
        ++row.fates[r.fate];
        row.other_verdicts +=
            r.fate == Fate::rejected && r.verdict != dumbbell_verify::Verdict::rejected ? 1 : 0;
        row.stale += r.stale_tried ? 1 : 0;
        const std::string line =
            fmt::format("{}\t{}\t{}\t{}\t{}\n", base.name, trial.kind, trial.what, r.text, r.argument);
        if (r.fate == Fate::accepted && !trial.demand) accepted_ += line;
        if (r.fate != Fate::accepted && r.fate != Fate::rejected)
            defects_ += fmt::format("{}\t{}", fate_names[static_cast<std::size_t>(r.fate)], line);
    }
}

std::string Report::summary() const {
    std::string text = "base\tkind\ttried";
    for (const std::string_view name : fate_names) text += fmt::format("\t{}", name);
    text += "\tof these not as REJECTED\talso with the old checksum\n";
    std::map<std::string_view, Row> kinds;
    for (const auto& [key, row] : rows_) {
        text += fmt::format("{}\t{}\t{}", key.first, key.second, row.text());
        kinds[key.second].add(row);
    }
    for (const auto& [kind, row] : kinds) text += fmt::format("all\t{}\t{}", kind, row.text());
    return text + fmt::format("all\tall\t{}", sum().text());
}

Report::Row Report::sum() const {
    Row all;
    for (const auto& [key, row] : rows_) all.add(row);
    return all;
}

std::size_t Report::tried() const { return sum().tried(); }

std::string Report::sentence() const {
    const Row all = sum();
    const auto number = [&](Fate fate) { return count(all.fates, fate); };
    return fmt::format(
        "{} mutants: {} refused, {} accepted, {} accepted and not shown to be true, {} demands decided "
        "wrongly, {} let through with the old checksum (of {}), {} crashes, {} hangs",
        all.tried(), number(Fate::rejected), number(Fate::accepted), number(Fate::unexplained),
        number(Fate::wrong_demand), number(Fate::unmasked), all.stale, number(Fate::crash),
        number(Fate::hang));
}

}  // namespace dumbbell_mutation
