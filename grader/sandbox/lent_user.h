#pragma once

#include <sys/types.h>

#include <filesystem>

#include "grader/base/process.h"

namespace meshgrade {

/// A user that is in no list of users and owns nothing, lent for one run. No two runs on this
/// machine have the same at the same time, so that all its processes can be ended at the end.
/// Nor is a user lent who has processes already, whoever started them.
/// The number of a user and its group are the same.
class LentUser {
 public:
  /// @throws GraderError unless this process is root, or if all users are lent
  LentUser();
  LentUser(const LentUser&) = delete;
  LentUser& operator=(const LentUser&) = delete;
  ~LentUser();

  uid_t number() const { return number_; }

 private:
  uid_t number_ = 0;
  FileDescriptor lock_;
};

/// While this lives, the folder belongs to that user alone; then to this process alone.
class LentFolder {
 public:
  /// @throws GraderError if the folder cannot be given away
  LentFolder(std::filesystem::path folder, const LentUser& user);
  LentFolder(const LentFolder&) = delete;
  LentFolder& operator=(const LentFolder&) = delete;
  ~LentFolder();

 private:
  std::filesystem::path folder_;
};

}  // namespace meshgrade
