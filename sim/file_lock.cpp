// SPDX-License-Identifier: Apache-2.0
// flock on a file of its own, so that replacing the entry never touches the lock.
#include "sim/file_lock.hpp"

#include <fcntl.h>
#include <string.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <stdexcept>

namespace gnomon::sim {

FileLock::FileLock(const std::filesystem::path& path)
    : file_(open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644)) {
  if (file_ < 0) throw std::runtime_error("cannot open " + path.string() + ": " + strerrordesc_np(errno));
  int result = flock(file_, LOCK_EX);
  while (result != 0 && errno == EINTR) result = flock(file_, LOCK_EX);
  if (result != 0) {
    const int error = errno;
    close(file_);
    throw std::runtime_error("cannot lock " + path.string() + ": " + strerrordesc_np(error));
  }
}

FileLock::~FileLock() {
  close(file_);
}

}  // namespace gnomon::sim
