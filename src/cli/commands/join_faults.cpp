#include "cli/commands/join_faults.hpp"

#include <fmt/core.h>

#include <filesystem>

#include "base/error.hpp"
#include "base/printable.hpp"
#include "cli/terminal/output.hpp"

namespace dumbbell::cli {
namespace {

/// The first file that is believed, whose kind all others have; nullptr: there is none.
const PartFile* first_believed(const Parts& parts, const std::vector<PartFile>& files) {
    const PartFile* first = nullptr;
    for (const PartFile& file : files) {
        if (!file.fault.empty()) {
            continue;
        }
        first = first == nullptr ? &file : first;
        if (file.kind != first->kind) {
            throw InputError(fmt::format("'{}' and '{}' are of different claims: {}, and {}", first->name,
                                         file.name, parts.command(*first->range, first),
                                         parts.command(*file.range, &file)));
        }
    }
    return first;
}

/// With an ending that certify takes.
std::string file_name(const std::string& name) {
    return name + (fault_of_name(name, Content::certificate).empty() ? "" : ".dbc");
}

}  // namespace

std::vector<std::string> faults_of(const Parts& parts, const std::vector<PartFile>& files,
                                   const collisions::Range& whole) {
    std::vector<std::string> faults;
    const PartFile* believed = first_believed(parts, files);
    int missing = 0;
    const auto reach = [&](const Rational& from, const Rational& to) {
        if (from < to) {
            std::string name;
            do {
                name = fmt::format("missing-{}.dbc", ++missing);
            } while (std::filesystem::exists(name));
            faults.push_back(fmt::format("missing: {}; to make them: {} --out {}", parts.words({from, to}),
                                         parts.command({from, to}, believed), name));
        }
    };
    Rational reached = whole.lo;
    const PartFile* furthest = nullptr;
    for (const PartFile& file : files) {
        if (!file.fault.empty()) {
            faults.push_back(with_command(parts, file, file.fault));
        }
        if (!file.range) {
            continue;
        }
        const auto& [begin, end] = *file.range;
        reach(reached, begin);
        if (furthest != nullptr && begin < reached) {
            faults.push_back(
                fmt::format("'{}' and '{}' overlap: leave one of them out", furthest->name, file.name));
        }
        if (begin < whole.lo || end > whole.hi) {
            faults.push_back(
                fmt::format("'{}' ({}) reaches beyond --range", file.name, parts.words(*file.range)));
        }
        if (end >= reached) {
            reached = end;
            furthest = &file;
        }
    }
    reach(reached, whole.hi);
    return faults;
}

std::string with_command(const Parts& parts, const PartFile& file, const std::string& line) {
    return !file.range ? line
                       : fmt::format("{}; to make it again: {} --out {}", line,
                                     parts.command(*file.range, &file), shell_file(file_name(file.name)));
}

}  // namespace dumbbell::cli
