// SPDX-License-Identifier: Apache-2.0
// posix_spawn with redirected output.
#include "sim/process.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <stdexcept>

namespace gnomon::sim {

namespace {

/// Where the program reads and writes.
class FileActions {
 public:
  FileActions(const std::filesystem::path& directory, const std::filesystem::path& log) {
    posix_spawn_file_actions_init(&actions_);
    posix_spawn_file_actions_addopen(&actions_, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&actions_, STDOUT_FILENO, log.c_str(), O_WRONLY | O_CREAT | O_APPEND,
                                     0644);
    posix_spawn_file_actions_adddup2(&actions_, STDOUT_FILENO, STDERR_FILENO);
    posix_spawn_file_actions_addchdir_np(&actions_, directory.c_str());
  }
  ~FileActions() { posix_spawn_file_actions_destroy(&actions_); }
  FileActions(const FileActions&) = delete;
  FileActions& operator=(const FileActions&) = delete;

  const posix_spawn_file_actions_t* get() const { return &actions_; }

 private:
  posix_spawn_file_actions_t actions_{};
};

}  // namespace

Process::Process(const std::vector<std::string>& arguments, const std::filesystem::path& directory,
                 const std::filesystem::path& log) {
  std::vector<std::string> owned = arguments;
  std::vector<char*> argv;
  argv.reserve(owned.size() + 1);
  for (std::string& argument : owned) argv.push_back(argument.data());
  argv.push_back(nullptr);
  const FileActions actions(directory, log);
  const int error = posix_spawnp(&pid_, argv[0], actions.get(), nullptr, argv.data(), environ);
  if (error != 0) {
    pid_ = -1;
    throw std::runtime_error("cannot start " + arguments.front() + ": " + strerrordesc_np(error));
  }
}

Process::~Process() {
  succeeded();
}

bool Process::succeeded() {
  if (pid_ >= 0) {
    while (waitpid(pid_, &status_, 0) < 0 && errno == EINTR) {
    }
    pid_ = -1;
  }
  return WIFEXITED(status_) && WEXITSTATUS(status_) == 0;
}

}  // namespace gnomon::sim
