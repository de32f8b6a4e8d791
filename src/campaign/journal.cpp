#include "campaign/journal.hpp"

#include <fcntl.h>
#include <fmt/core.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <filesystem>
#include <optional>
#include <sstream>
#include <string_view>

#include "base/error.hpp"
#include "base/fields.hpp"
#include "base/printable.hpp"
#include "file/file_contents.hpp"

namespace dumbbell::campaign {
namespace {

constexpr std::array<std::string_view, 8> words_of{"begin",    "end",    "done",  "again",
                                                   "rejected", "failed", "split", "state"};

std::string field(const std::string& text) { return printable(text, 1000); }

std::string line_of(const JournalEntry& event) {
    return fmt::format("{:.3f}\t{}\t{}\t{}\t{:.3f}\t{}\n", event.time,
                       words_of[static_cast<std::size_t>(event.what)], field(event.id), field(event.worker),
                       event.seconds, field(event.text));
}

std::optional<JournalEntry> event_of(std::string_view line) {
    std::array<std::string_view, 6> fields;
    for (std::size_t i = 0; i < fields.size(); ++i) {
        const std::size_t tab = i + 1 < fields.size() ? line.find('\t') : line.size();
        if (tab == std::string_view::npos) {
            return std::nullopt;
        }
        fields[i] = line.substr(0, tab);
        line.remove_prefix(std::min(tab + 1, line.size()));
    }
    const auto word = std::find(words_of.begin(), words_of.end(), fields[1]);
    const auto time = number_of<double>(fields[0]);
    const auto seconds = number_of<double>(fields[4]);
    if (word == words_of.end() || !time || !seconds) {
        return std::nullopt;
    }
    return JournalEntry{*time,
                        static_cast<JournalEntry::What>(word - words_of.begin()),
                        std::string(fields[2]),
                        std::string(fields[3]),
                        *seconds,
                        std::string(fields[5])};
}

}  // namespace

double seconds_since_1970() {
    return std::chrono::duration<double>(std::chrono::system_clock::now().time_since_epoch()).count();
}

void Journal::append(JournalEntry event) {
    if (file_.get() < 0) {
        file_ = Descriptor(::open(path_.c_str(), O_RDWR | O_CREAT | O_APPEND | O_NOFOLLOW | O_CLOEXEC, 0666));
    }
    event.time = seconds_since_1970();
    std::string line = line_of(event);
    // What a crash cut off must not run into this line.
    char last = '\n';
    const off_t size = file_.get() < 0 ? 0 : ::lseek(file_.get(), 0, SEEK_END);
    if (size > 0 && ::pread(file_.get(), &last, 1, size - 1) == 1 && last != '\n') {
        line.insert(0, 1, '\n');
    }
    errno = file_.get() < 0 ? errno : ENOSPC;  // which a write that stops half-way does not say
    if (file_.get() < 0 ||
        ::write(file_.get(), line.data(), line.size()) != static_cast<ssize_t>(line.size())) {
        throw InputError(fmt::format("cannot write '{}': {}", path_, std::strerror(errno)));
    }
}

std::vector<JournalEntry> Journal::read() const {
    std::vector<JournalEntry> events;
    std::error_code failed;
    if (std::filesystem::status(path_, failed).type() == std::filesystem::file_type::not_found) {
        return events;
    }
    std::istringstream in(file_contents(path_));
    for (std::string line; std::getline(in, line);) {
        if (auto event = event_of(line)) {
            events.push_back(std::move(*event));
        }
    }
    return events;
}

}  // namespace dumbbell::campaign
