#include "corpus.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <stdexcept>
#include <utility>

namespace dumbbell_mutation {
namespace {

constexpr std::size_t most_of_a_group = 100;

/// Reasons that differ in numbers only are the same.
std::string without_digits(std::string text) {
    std::erase_if(text, [](char c) { return c >= '0' && c <= '9'; });
    return text;
}

}  // namespace

void Corpus::add(const Base& base, const std::vector<Trial>& trials, const std::vector<Result>& results) {
    for (std::size_t i = 0; i < trials.size(); ++i) {
        const Trial& trial = trials[i];
        const Result& r = results[i];
        const bool accepted = r.fate == Fate::accepted;
        if (!accepted && r.fate != Fate::rejected) continue;
        Entry entry{"",
                    trial.demand ? trial.what : "",
                    exit_code(r.verdict),
                    accepted ? 0 : r.line,
                    accepted ? "-" : r.code,
                    r.text,
                    fmt::format("{}, {}: {}", base.name, trial.kind, trial.what)};
        const std::string group = fmt::format("{}\t{}\t{}\t{}", base.name, entry.exit, entry.code,
                                              accepted ? std::string(trial.kind) : without_digits(r.text));
        Group& all = groups_[group];
        std::vector<Candidate>& sample = all.sample;
        const std::size_t place = random_() % ++all.seen;
        if (sample.size() < most_of_a_group) {
            sample.push_back({trial.text, std::move(entry)});
            std::swap(sample.back(), sample[place]);
        } else if (place < most_of_a_group) {
            sample[place] = {trial.text, std::move(entry)};
        }
    }
}

void Corpus::write(const std::string& folder, std::size_t most) const {
    std::filesystem::create_directories(folder);
    if (!std::filesystem::is_empty(folder)) throw std::runtime_error(folder + " is not empty");
    std::vector<Entry> entries;
    for (std::size_t round = 0; round < most_of_a_group; ++round)
        for (const auto& [name, group] : groups_) {
            if (round >= group.sample.size() || entries.size() >= most) continue;
            Entry entry = group.sample[round].entry;
            entry.file = fmt::format("{:05}.dbc", entries.size() + 1);
            write_file(folder + "/" + entry.file, group.sample[round].text);
            entries.push_back(std::move(entry));
        }
    write_file(folder + "/manifest.tsv", manifest_text(entries));
}

}  // namespace dumbbell_mutation
