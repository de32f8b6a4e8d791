#include "cli/list/certificate_folder.hpp"

#include <fmt/core.h>

#include <filesystem>
#include <utility>

#include "base/error.hpp"
#include "file/atomic_file.hpp"

namespace dumbbell::cli {
namespace {

/// By which files are sorted as their lines are.
std::string name_of(long line) { return fmt::format("{:06}.dbc", line); }

}  // namespace

CertificateFolder::CertificateFolder(std::string folder) : folder_(std::move(folder)) {
    if (folder_.empty()) {
        return;
    }
    if (folder_ == "-") {
        throw InputError("--out -: with --list give a new folder for the certificates");
    }
    if (!std::filesystem::create_directory(folder_) && !std::filesystem::is_empty(folder_)) {
        throw InputError(
            fmt::format("--out: '{}' has files: with --list give a new or an empty folder", folder_));
    }
}

std::string CertificateFolder::file(long line) const {
    return folder_.empty() ? "" : (std::filesystem::path(folder_) / name_of(line)).string();
}

void CertificateFolder::keep(long line, const std::string& certificate, const std::string& claim) {
    // They can be made again, and waiting for the disk takes longer than a proof.
    write_atomically(file(line), certificate, Survives::program);
    if (claim.empty()) {
        return;
    }
    const std::string claims = (std::filesystem::path(folder_) / "claims.tsv").string();
    if (!claims_.is_open()) {
        claims_.open(claims);
    }
    if (!(claims_ << name_of(line) << '\t' << claim << '\n' << std::flush)) {
        throw InputError(fmt::format("cannot write '{}': is the disk full?", claims));
    }
}

}  // namespace dumbbell::cli
