#pragma once

#include <functional>
#include <string>
#include <string_view>

namespace dumbbell {

/// Takes a text, part after part.
using Sink = std::function<void(std::string_view)>;
/// Hands a text to a sink, so that it is never in memory as a whole.
using Writing = std::function<void(const Sink&)>;

/// Whose death the contents survive: the program's, or the machine's too (which waits for the disk).
enum class Survives { program, machine };

/// Writes a file that appears under its name complete or not at all: next to it under the name
/// `FILE.dumbbell-tmp`, made durable, renamed, so that it replaces what was there. A program that is killed
/// leaves at most that one file, which the next one that writes FILE removes; writers of the same FILE wait
/// for one another, and the last one wins. A file that is replaced passes its access rights on, and its owner
/// if this program may give them; a link is replaced itself. A name that ends in `.gz` is written
/// gzip-compressed. With Survives::program the file may be found damaged, empty or missing when the machine
/// comes back after a crash: for files with a checksum whose contents can be made again. Throws InputError
/// (naming the file and the cause) on any failure, and then leaves nothing; also if `write` throws.
void write_atomically(const std::string& path, const Writing& write,
                      Survives whose_death = Survives::machine);
void write_atomically(const std::string& path, const std::string& contents,
                      Survives whose_death = Survives::machine);

/// A file that will be written so when its contents are known.
class AtomicFile {
  public:
    /// Finds out at once whether the place is writable, by a file that is removed again; throws as above.
    explicit AtomicFile(std::string path);

    void commit(const Writing& write) const { write_atomically(path_, write); }
    void commit(const std::string& contents) const { write_atomically(path_, contents); }

  private:
    std::string path_;
};

/// The file that a name given by a user stands for: links are followed to their end, which need not be there,
/// so that it is written and they stay. Throws InputError if a link or the end lies below /dev (but /dev/shm,
/// which has ordinary files) or /proc, or if the links lead in a circle.
[[nodiscard]] std::string output_target(const std::string& name);

/// What a killed program may leave next to `path`.
[[nodiscard]] std::string temporary_name(const std::string& path);

}  // namespace dumbbell
