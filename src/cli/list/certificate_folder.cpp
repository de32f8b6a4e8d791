#include "cli/list/certificate_folder.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <utility>

#include "base/error.hpp"
#include "file/atomic_file.hpp"
#include "file/file_contents.hpp"

namespace dumbbell::cli {
namespace {

namespace fs = std::filesystem;

/// By which files are sorted as their lines are.
std::string name_of(long line) { return fmt::format("{:06}.dbc", line); }

}  // namespace

CertificateFolder::CertificateFolder(std::string folder, const std::string& claims_of)
    : folder_(std::move(folder)),
      not_complete_(fmt::format(
          "NOT COMPLETE: lines of the list have no claim here; the same command goes on ({})\n", claims_of)) {
    if (folder_.empty()) {
        return;
    }
    if (folder_ == "-") {
        throw InputError("--out -: with --list give a new folder for the certificates");
    }
    fs::create_directory(folder_);
    if (!lock_.take(folder_)) {
        throw InputError(fmt::format("--out: '{}' is in use by another run", folder_));
    }
    claims_file_ = claims_of.empty() ? "" : (fs::path(folder_) / "claims.tsv").string();
    const bool goes_on = !claims_file_.empty() && fs::is_regular_file(claims_file_) &&
                         file_contents(claims_file_).starts_with(not_complete_);
    const std::string unfinished = temporary_name(claims_file_);
    const auto is_other = [&](const fs::path& file) { return file != unfinished; };
    if (!goes_on &&
        std::ranges::any_of(fs::directory_iterator(folder_), is_other, &fs::directory_entry::path)) {
        throw InputError(
            fmt::format("--out: '{}' has files: with --list give a new or an empty folder{}", folder_,
                        claims_file_.empty() ? "" : ", or go on with the command that has left it"));
    }
    finish(false);
}

std::string CertificateFolder::file(long line) const {
    return folder_.empty() ? "" : (fs::path(folder_) / name_of(line)).string();
}

void CertificateFolder::keep(long line, const std::string& certificate, const std::string& claim) {
    // They can be made again, and waiting for the disk takes longer than a proof.
    write_atomically(file(line), certificate, Survives::program);
    if (!claim.empty()) {
        claims_ += fmt::format("{}\t{}\n", name_of(line), claim);
    }
}

void CertificateFolder::finish(bool is_complete) const {
    if (!claims_file_.empty()) {
        write_atomically(claims_file_, (is_complete ? "" : not_complete_) + claims_);
    }
}

}  // namespace dumbbell::cli
