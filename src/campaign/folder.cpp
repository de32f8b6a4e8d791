#include "campaign/folder.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <set>
#include <string_view>
#include <system_error>

#include "base/ended_early.hpp"
#include "base/error.hpp"
#include "collisions/writer.hpp"
#include "file/atomic_file.hpp"
#include "file/file_contents.hpp"
#include "file/sha256.hpp"

namespace dumbbell::campaign {
namespace {

namespace fs = std::filesystem;

constexpr std::array<std::string_view, 4> folders{"results", "splits", "rejected", "arrived"};
constexpr std::array<std::string_view, 3> files{"plan", "journal", "password"};

bool is_id(std::string_view name) {
    return name.size() == 32 && name.find_first_not_of("0123456789abcdef") == std::string_view::npos;
}

/// What a killed program may leave.
bool is_temporary(const std::string& name) { return name.ends_with(temporary_name("")); }

void make_folder(const std::string& path) {
    std::error_code failed;
    fs::create_directory(path, failed);
    if (failed) {
        throw InputError(fmt::format("cannot make the folder '{}': {}", path, failed.message()));
    }
}

[[noreturn]] void foreign(const fs::path& file) {
    throw InputError(
        fmt::format("'{}' is not a file of a campaign: move it elsewhere, and try again", file.string()));
}

/// Nothing that a reader might wait for; or it has just gone, as what a run is writing may.
bool is_file(const fs::directory_entry& entry) {
    const fs::file_type type = entry.status().type();
    return type == fs::file_type::regular || type == fs::file_type::not_found;
}

/// What belongs to a plan, into its empty folder.
void fill(const std::string& path, const Plan& plan, const std::vector<std::string>& sources,
          const Interrupted& interrupted) {
    for (const std::string_view name : folders) {
        make_folder(fmt::format("{}/{}", path, name));
    }
    for (std::size_t i = 0; i < sources.size(); ++i) {
        go_on(interrupted);
        const std::string copy = path + "/" + plan.inputs[i];
        std::error_code failed;
        if (!fs::copy_file(sources[i], copy, failed)) {
            throw InputError(fmt::format("cannot copy '{}' to '{}': {}", sources[i], copy, failed.message()));
        }
    }
    const std::string text = render(plan);
    go_on(interrupted);
    write_atomically(path + "/plan", text);  // last: with it the folder is a campaign
}

}  // namespace

void CampaignFolder::require_new(const std::string& path) {
    std::error_code failed;
    if (fs::exists(fs::symlink_status(path, failed)) &&
        (!fs::is_directory(path, failed) || !fs::is_empty(path, failed))) {
        throw InputError(fmt::format(
            "'{}' is there already: take a folder that is new or empty, so that nothing is lost", path));
    }
}

void CampaignFolder::create(const std::string& path, const Plan& plan,
                            const std::vector<std::string>& sources, const Interrupted& interrupted) {
    require(sources.size() == plan.inputs.size(), "a plan whose inputs are not there");
    require_new(path);
    std::error_code failed;
    const bool is_new = !fs::exists(path, failed);
    make_folder(path);
    try {
        fill(path, plan, sources, interrupted);
    } catch (...) {
        for (const fs::directory_entry& entry : fs::directory_iterator(path, failed)) {
            fs::remove_all(entry.path(), failed);  // all made above: the folder was empty
        }
        if (is_new) {
            fs::remove(path, failed);
        }
        throw;
    }
}

CampaignFolder::CampaignFolder(std::string path) : path_(std::move(path)), journal_(path_ + "/journal") {
    const std::string file = path_ + "/plan";
    std::error_code failed;
    if (fs::status(file, failed).type() == fs::file_type::not_found) {
        throw InputError(fmt::format(
            "'{}' is not a campaign: it has no file 'plan'; make one with dumbbell campaign plan", path_));
    }
    const std::string text = file_contents(file);
    try {
        plan_ = parse_plan(text);
    } catch (const InputError& error) {
        throw InputError(fmt::format("'{}': {}", file, error.what()));
    }
    try {
        require_own_files();
    } catch (const fs::filesystem_error& error) {
        throw InputError(fmt::format("cannot read '{}': {}", error.path1().string(), error.code().message()));
    }
    plan_digest_ = sha256_hex(text);
    for (const Plan::Shard& shard : plan_.shards) {
        ids_.push_back(plan_.order(shard.first, shard.end).id());
    }
    for (const JournalEntry& event : journal_.read()) {
        if (event.what == JournalEntry::What::begin && event.text != plan_digest_) {
            throw InputError(
                fmt::format("'{}' was changed after the start of the campaign: put the plan with "
                            "the SHA-256 {} back, or plan the claim anew in another folder",
                            file, event.text.substr(0, 64)));
        }
    }
    require_known_results();
}

void CampaignFolder::require_own_files() const {
    const auto is_one_of = [](const auto& names, const std::string& name) {
        return std::find(names.begin(), names.end(), name) != names.end();
    };
    for (const fs::directory_entry& entry : fs::directory_iterator(path_)) {
        const std::string name = entry.path().filename();
        const bool is_folder = entry.symlink_status().type() == fs::file_type::directory;
        const bool is_own = is_folder ? is_one_of(folders, name)
                                      : is_file(entry) && (is_one_of(files, name) || is_temporary(name) ||
                                                           is_one_of(plan_.inputs, name));
        if (!is_own) {
            foreign(entry.path());
        }
    }
    for (const std::string_view folder : folders) {
        const std::string below = fmt::format("{}/{}", path_, folder);
        if (!fs::is_directory(below)) {
            throw InputError(fmt::format("'{}' is missing: make it (mkdir), and try again", below));
        }
        for (const fs::directory_entry& entry : fs::directory_iterator(below)) {
            const std::string name = entry.path().filename();
            if (!is_file(entry) || (!is_id(name) && !is_temporary(name))) {
                foreign(entry.path());
            }
        }
    }
}

void CampaignFolder::require_known_results() const {
    std::set<std::string> unknown;  // listed first: a run that is at work only adds shards
    for (const fs::directory_entry& entry : fs::directory_iterator(path_ + "/results")) {
        if (is_id(entry.path().filename().string())) {
            unknown.insert(entry.path().filename());
        }
    }
    for (const Part& part : parts()) {
        unknown.erase(part.id);
    }
    if (!unknown.empty()) {
        throw InputError(fmt::format(
            "'{}/results/{}' belongs to no shard of the plan: either the plan was changed after the "
            "start, or the file comes from elsewhere; put the plan back, or move the file away",
            path_, *unknown.begin()));
    }
}

void CampaignFolder::lock() {
    if (!lock_.take(path_)) {
        throw InputError(fmt::format("'{}' is in use by another run: wait for it, or stop it first", path_));
    }
}

bool CampaignFolder::holds(const std::string& file) const {
    std::error_code failed;  // the path is empty then, and nothing can be written there
    const fs::path place = fs::weakly_canonical(fs::absolute(file).parent_path(), failed);
    const fs::path from_here = place.lexically_relative(fs::weakly_canonical(path_, failed));
    return !from_here.empty() && *from_here.begin() != "..";
}

bool CampaignFolder::has_result(const std::string& id) const { return fs::exists(result_file(id)); }

void CampaignFolder::add_parts(const Part& part, std::vector<Part>& all) const {
    if (!part.finished && fs::exists(fmt::format("{}/splits/{}", path_, part.id))) {
        for (const Part& half : halves(part)) {
            add_parts(half, all);
        }
        return;
    }
    all.push_back(part);
}

std::vector<CampaignFolder::Part> CampaignFolder::parts() const {
    std::vector<Part> all;
    for (std::size_t i = 0; i < ids_.size(); ++i) {
        const Plan::Shard& shard = plan_.shards[i];
        add_parts({shard.first, shard.end, static_cast<double>(shard.cost), ids_[i], has_result(ids_[i])},
                  all);
    }
    return all;
}

std::vector<CampaignFolder::Part> CampaignFolder::halves(const Part& part) const {
    require(part.end - part.first > 1, "one unit has no halves");
    const std::size_t middle = part.first + (part.end - part.first) / 2;
    std::vector<Part> both{{part.first, middle, part.cost / 2, {}, false},
                           {middle, part.end, part.cost / 2, {}, false}};
    for (Part& half : both) {
        half.id = order(half).id();
        half.finished = has_result(half.id);
    }
    return both;
}

CampaignFolder::Kept CampaignFolder::keep_result(const std::string& id, const std::string& bytes) const {
    if (!has_result(id)) {
        write_atomically(result_file(id), bytes);
        return Kept::now;
    }
    return file_contents(result_file(id)) == bytes ? Kept::before : Kept::other;
}

void CampaignFolder::split(const std::string& id) const {
    write_atomically(fmt::format("{}/splits/{}", path_, id), "");
}

std::string CampaignFolder::arrived(const std::string& id, const std::string& bytes) const {
    std::string file = fmt::format("{}/arrived/{}", path_, id);
    write_atomically(file, bytes, Survives::program);
    return file;
}

void CampaignFolder::forget_arrived(const std::string& id) const {
    std::error_code ignored;
    fs::remove(fmt::format("{}/arrived/{}", path_, id), ignored);
}

void CampaignFolder::reject(const std::string& id, const std::string& bytes) const {
    write_atomically(fmt::format("{}/rejected/{}", path_, id), bytes, Survives::program);
}

void CampaignFolder::withdraw_result(const std::string& id) const {
    std::error_code failed;
    fs::rename(result_file(id), fmt::format("{}/rejected/{}", path_, id), failed);
    if (failed) {
        throw InputError(fmt::format("cannot move '{}' away: {}", result_file(id), failed.message()));
    }
}

}  // namespace dumbbell::campaign
