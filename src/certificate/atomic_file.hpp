#pragma once

#include <string>

namespace dumbbell {

/// Whose death the contents survive: the program's, or the machine's too (which waits for the disk).
enum class Survives { program, machine };

/// A file that appears under its final name complete or not at all: written beside it under the name
/// `FILE.dumbbell-tmp`, synced, renamed. A program that is killed leaves at most that one file, which the
/// next one that writes FILE takes over; writers of the same FILE wait for one another, and the last one
/// wins. Throws InputError (naming the file and the cause) on any failure, and then leaves nothing.
class AtomicFile {
  public:
    /// A name that ends in `.gz` is written gzip-compressed. Finds out at once whether the place is writable,
    /// by a file that is removed again.
    explicit AtomicFile(std::string path);

    /// Writes the contents, makes them durable and gives the file its final name, replacing what was there.
    /// With Survives::program the file may be found damaged, empty or missing when the machine comes back
    /// after a crash: for files with a checksum whose contents can be made again.
    void commit(const std::string& contents, Survives whose_death = Survives::machine) const;

  private:
    std::string path_;
};

/// What a killed program may leave beside `path`.
[[nodiscard]] std::string temporary_name(const std::string& path);

}  // namespace dumbbell
