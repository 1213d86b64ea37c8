// SPDX-License-Identifier: Apache-2.0
// gnomon doctor: is everything here that the program needs at run time?
#include <fmt/format.h>
#include <sys/sysinfo.h>
#include <unistd.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <thread>

#include "host/cli/command.hpp"
#include "sim/toolchain.hpp"

namespace gnomon::cli {
namespace {

namespace fs = std::filesystem;

/// One thing looked at.
struct Finding {
  std::string name;
  bool required = false;
  bool found = false;
  std::string detail;  ///< a version, a place, or what is missing and what it is for
};

struct ClosePipe {
  void operator()(std::FILE* pipe) const { pclose(pipe); }
};

/// A word as the shell takes it literally.
std::string quoted(const std::string& word) {
  std::string text = "'";
  for (const char c : word) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return text + "'";
}

/// The first line that the program prints about itself; nothing if it does not run.
std::optional<std::string> version_of(const std::string& program, const std::string& flag) {
  const std::unique_ptr<std::FILE, ClosePipe> pipe(
      popen((quoted(program) + " " + flag + " 2>/dev/null").c_str(), "r"));
  std::array<char, 256> line{};
  if (pipe == nullptr || std::fgets(line.data(), static_cast<int>(line.size()), pipe.get()) == nullptr)
    return std::nullopt;
  const std::string_view text(line.data());
  return std::string(text.substr(0, text.find('\n')));
}

Finding look_for(const std::string& program, const std::string& flag, bool required,
                 const std::string& purpose) {
  const std::optional<std::string> version = version_of(program, flag);
  return {program, required, version.has_value(), version.value_or("not found; needed " + purpose)};
}

Finding look_at_rtl(const fs::path& directory) {
  const bool found = fs::exists(directory / "gnomon.f");
  return {"rtl sources", true, found,
          directory.string() + (found ? "" : " has no gnomon.f; set GNOMON_RTL_DIR")};
}

/// The nearest ancestor that exists: the cache makes the rest itself.
Finding look_at_cache(fs::path directory) {
  const fs::path wanted = directory;
  while (!directory.empty() && !fs::exists(directory) && directory != directory.parent_path())
    directory = directory.parent_path();
  const bool writable = access(directory.c_str(), W_OK) == 0;
  return {"model cache", true, writable,
          wanted.string() + (writable ? "" : " cannot be written; set GNOMON_CACHE_DIR")};
}

Finding look_at_machine() {
  struct sysinfo info {};
  sysinfo(&info);
  const double gib = static_cast<double>(info.totalram) * info.mem_unit / (1U << 30U);
  return {"machine", false, true,
          fmt::format("{} cores, {:.1f} GiB memory", std::thread::hardware_concurrency(), gib)};
}

std::vector<Finding> examine() {
  const sim::Toolchain tools = sim::Toolchain::from_environment();
  return {look_at_machine(),
          look_for(tools.verilator, "--version", true, "by the rtl engine"),
          look_for(tools.compiler.back(), "--version", true, "by the rtl engine"),
          look_at_rtl(tools.rtl_dir),
          look_at_cache(tools.cache_dir),
          look_for("ccache", "--version", false, "to compile models again quickly"),
          look_for("gtkwave", "--version", false, "to look at waveforms"),
          look_for("yosys", "-V", false, "for synthesis estimates and proofs")};
}

class DoctorCommand : public Command {
 public:
  CLI::App* add_to(CLI::App& program) override {
    CLI::App* command = program.add_subcommand("doctor", "Check the tools that are needed at run time");
    command->add_flag("--json", json_, "Print as JSON");
    command->footer("Exit status 2 if something required is missing.\n\nExample:\n  gnomon doctor");
    return command;
  }

  Result<int> run(Context&) override {
    const std::vector<Finding> findings = examine();
    std::string missing;
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (const Finding& finding : findings) {
      if (finding.required && !finding.found) missing += (missing.empty() ? "" : ", ") + finding.name;
      list.push_back({{"name", finding.name},
                      {"required", finding.required},
                      {"found", finding.found},
                      {"detail", finding.detail}});
      const char* verdict = finding.found ? "ok" : finding.required ? "MISSING" : "absent";
      if (!json_) fmt::print("{:<8} {:<14} {}\n", verdict, finding.name, finding.detail);
    }
    if (json_) fmt::print("{}\n", list.dump(2));
    if (!missing.empty()) return fail("required but missing: " + missing);
    return kDone;
  }

 private:
  bool json_ = false;
};

}  // namespace

std::unique_ptr<Command> make_doctor_command() {
  return std::make_unique<DoctorCommand>();
}

}  // namespace gnomon::cli
