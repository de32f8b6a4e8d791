#pragma once

#include <string>

namespace dumbbell {

/// A file that appears under its final name complete or not at all: written to a temporary name beside it,
/// synced, renamed. The temporary file is made by the constructor, which so finds out at once whether the
/// place is writable; without a commit() it is removed again. Throws InputError (naming the file and the
/// cause) on any failure.
class AtomicFile {
  public:
    /// A name that ends in `.gz` is written gzip-compressed.
    explicit AtomicFile(std::string path);
    ~AtomicFile();
    AtomicFile(const AtomicFile&) = delete;
    AtomicFile& operator=(const AtomicFile&) = delete;

    /// Writes the contents, makes them durable and gives the file its final name, replacing what was there.
    void commit(const std::string& contents);

  private:
    [[noreturn]] void fail(const char* doing) const;

    std::string path_;
    std::string temporary_;
    int descriptor_ = -1;
};

}  // namespace dumbbell
