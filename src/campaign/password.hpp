#pragma once

#include <string>

namespace dumbbell::campaign {

/// 256 random bits of the operating system in hexadecimal. Throws BrokenInvariant if it has none.
[[nodiscard]] std::string random_digits();

/// The file `FOLDER/password`, the secret that a campaign shares with its workers: made if it is not there
/// (256 random bits in hexadecimal, for its owner alone), never replaced. Returns its path. Throws InputError
/// (naming the file and the cause) if it can be neither made nor read as by read_password.
[[nodiscard]] std::string password_file(const std::string& folder);

/// The secret in a file: all of it, the last newline included, as work_queue_worker reads it. Throws
/// InputError (naming the file, saying what to do) if the file cannot be read, is no regular file, can be
/// read by others than its owner, or does not hold one line of 16 to 256 printable characters.
[[nodiscard]] std::string read_password(const std::string& file);

}  // namespace dumbbell::campaign
