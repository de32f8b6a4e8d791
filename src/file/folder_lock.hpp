#pragma once

#include <string>

#include "file/descriptor.hpp"

namespace dumbbell {

/// One program at a time changes a folder. Given back at the end, also when the program is killed.
class FolderLock {
  public:
    /// False if another one has it. Throws InputError if the folder cannot be opened or locked.
    [[nodiscard]] bool take(const std::string& folder);

  private:
    Descriptor folder_;
};

}  // namespace dumbbell
