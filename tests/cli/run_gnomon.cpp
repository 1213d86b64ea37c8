// SPDX-License-Identifier: Apache-2.0
// Runs the gnomon program as a user would.
#include "tests/cli/run_gnomon.hpp"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <sstream>
#include <system_error>
#include <thread>

#include "tests/host/scene/files.hpp"

namespace gnomon::test {
namespace {

constexpr int kNobody = 65534;
constexpr int kCannotStart = 126;

[[noreturn]] void become_gnomon(const std::vector<std::string>& arguments, const HowToRun& how,
                                const std::filesystem::path& out, const std::filesystem::path& err) {
  const int out_file = open(out.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0666);
  const int err_file = open(err.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0666);
  const int nothing = open("/dev/null", O_RDONLY);
  // Opened while we may: whoever we become need not be able to reach the build folder.
  const int program = open(GNOMON_PROGRAM, O_RDONLY | O_CLOEXEC);
  if (dup2(nothing, 0) < 0 || dup2(out_file, 1) < 0 || dup2(err_file, 2) < 0) _exit(kCannotStart);
  if (!how.directory.empty() && chdir(how.directory.c_str()) != 0) _exit(kCannotStart);
  if (how.as_nobody && geteuid() == 0 && setuid(kNobody) != 0) _exit(kCannotStart);
  for (const std::string& entry : how.environment) {
    const std::size_t equals = entry.find('=');
    setenv(entry.substr(0, equals).c_str(), entry.substr(equals + 1).c_str(), 1);
  }
  std::vector<char*> words;
  std::vector<std::string> copies{GNOMON_PROGRAM};
  copies.insert(copies.end(), arguments.begin(), arguments.end());
  words.reserve(copies.size() + 1);
  for (std::string& copy : copies) words.push_back(copy.data());
  words.push_back(nullptr);
  fexecve(program, words.data(), environ);
  _exit(kCannotStart);
}

std::string content(const std::filesystem::path& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

/// Until `so` or the child has ended.
template <typename Condition>
void wait_until(pid_t child, std::chrono::milliseconds between, const Condition& so) {
  while (!so()) {
    siginfo_t ended{};
    if (waitid(P_PID, static_cast<id_t>(child), &ended, WEXITED | WNOHANG | WNOWAIT) == 0 &&
        ended.si_pid == child)
      return;
    std::this_thread::sleep_for(between);
  }
}

/// Until the child has used this much of a processor, however busy the machine is, or has ended.
void wait_for_cpu_time(pid_t child, std::chrono::nanoseconds enough) {
  clockid_t clock{};
  if (clock_getcpuclockid(child, &clock) != 0) return;
  wait_until(child, std::chrono::milliseconds(5), [&] {
    timespec used{};
    return clock_gettime(clock, &used) != 0 ||
           std::chrono::seconds(used.tv_sec) + std::chrono::nanoseconds(used.tv_nsec) >= enough;
  });
}

}  // namespace

Outcome run_gnomon(const std::vector<std::string>& arguments, const HowToRun& how) {
  const TempDir directory;
  const auto out = directory.path() / "out", err = directory.path() / "err";
  const pid_t child = fork();
  if (child < 0) throw std::system_error(errno, std::generic_category(), "fork");
  if (child == 0) become_gnomon(arguments, how, out, err);
  if (how.interrupt_at) {
    wait_for_cpu_time(child, *how.interrupt_at);
    kill(child, SIGINT);
  }
  if (how.interrupt_when) {
    wait_until(child, std::chrono::milliseconds(1), how.interrupt_when);
    kill(child, SIGINT);
  }
  int status = 0;
  while (waitpid(child, &status, 0) < 0) {
    if (errno != EINTR) throw std::system_error(errno, std::generic_category(), "waitpid");
  }
  Outcome outcome{WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status), content(out),
                  content(err)};
  if (outcome.status == kCannotStart) throw std::runtime_error("gnomon could not be started");
  return outcome;
}

std::size_t line_count(const std::string& text) {
  std::size_t lines = 0;
  for (const char c : text) lines += c == '\n' ? 1U : 0U;
  return lines + (text.empty() || text.back() == '\n' ? 0U : 1U);
}

}  // namespace gnomon::test
