// SPDX-License-Identifier: Apache-2.0
// Verilates and compiles models. The Verilator runtime is compiled once for all of them.
#include "sim/model_cache.hpp"

#include <unistd.h>

#include <algorithm>
#include <set>
#include <sstream>
#include <system_error>

#include "sim/content_hash.hpp"
#include "sim/model_source.hpp"
#include "sim/process.hpp"

namespace gnomon::sim {

namespace fs = std::filesystem;

namespace {

constexpr const char* kRuntime = "libruntime.a";
constexpr const char* kModel = "model.so";
constexpr const char* kLog = "build.log";
constexpr const char* kRuntimeSources[] = {"verilated", "verilated_threads", "verilated_save",
                                           "verilated_fst_c", "verilated_cov"};

using Arguments = std::vector<std::string>;

Arguments joined(Arguments first, const Arguments& second) {
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

std::string one_line(const Arguments& arguments) {
  std::string text;
  for (const std::string& argument : arguments) text += argument + " ";
  return text;
}

/// Flags of everything that goes into a model. Hidden symbols keep the runtimes of several loaded models
/// apart.
Arguments compile_flags() {
  return {"-std=gnu++17",
          "-fPIC",
          "-fvisibility=hidden",
          "-fno-gnu-unique",
          "-fcf-protection=none",
          "-w",
          "-DVM_SC=0",
          "-include",
          "gnomon_model_print.h",
          "-DVL_PRINTF=gnomon_model_printf"};
}
/// Of what every cycle runs through.
Arguments level(const ModelSpec& spec) {
  return {spec.quick_build ? "-O1" : "-O2"};
}
const Arguments kSlow{"-O0"};  // constructors and the like run once
const Arguments kRuntimeLevel{"-O2"};

Arguments include_flags(const Toolchain& tools) {
  const std::string include = tools.verilator_root + "/include";
  return {"-I.", "-I" + include, "-I" + include + "/vltstd"};
}

/// "file:line:column: message" of the first complaint, with `folder` left out. What the RTL says itself
/// ($error) comes before what Verilator finds because of it.
std::string first_error(const fs::path& log, const fs::path& folder) {
  std::istringstream lines(read_file(log));
  std::string first, line;
  while (std::getline(lines, line)) {
    const bool by_rtl = line.find("-USERERROR: ") != std::string::npos;
    const bool complaint = line.starts_with("%Error") ||
                           line.starts_with("%Warning") ||  // warnings are fatal
                           line.find(" error: ") != std::string::npos;
    if (by_rtl || (complaint && first.empty())) first = line;
    if (by_rtl) break;
  }
  if (first.empty()) return "no error message";
  if (first.starts_with("%")) first.erase(0, first.find(": ") + 2);
  const std::string prefix = folder.string() + "/";
  if (const auto at = first.find(prefix); at != std::string::npos) first.erase(at, prefix.size());
  return first;
}

/// One translation unit out of many, so that a cycle's functions are optimised together.
void write_includes(const fs::path& path, const std::set<fs::path>& sources) {
  std::string text;
  for (const fs::path& source : sources) text += "#include \"" + source.filename().string() + "\"\n";
  write_file(path, text);
}

bool is_rtl(const fs::path& path) {
  static const std::set<std::string> extensions{".f", ".sv", ".svh", ".v", ".vh", ".vlt"};
  return extensions.contains(path.extension().string());
}

/// "relative name, hash" of every RTL file, sorted by name.
std::string rtl_manifest(const fs::path& rtl_dir) {
  std::set<fs::path> files;
  std::error_code error;
  for (auto it = fs::recursive_directory_iterator(rtl_dir, error);
       !error && it != fs::recursive_directory_iterator(); it.increment(error)) {
    if (it->is_regular_file() && is_rtl(it->path())) files.insert(it->path());
  }
  if (error) throw ModelBuildError("cannot read the RTL in " + rtl_dir.string() + ": " + error.message());
  if (!files.contains(rtl_dir / "gnomon.f"))
    throw ModelBuildError("no gnomon.f in the RTL folder " + rtl_dir.string());
  std::string text;
  for (const fs::path& file : files) {
    text += "rtl " + fs::relative(file, rtl_dir).string() + " " + content_hash(read_file(file)) + "\n";
  }
  return text;
}

Arguments verilator_command(const Toolchain& tools, const ModelSpec& spec, const fs::path& mdir) {
  Arguments command{tools.verilator, "--Mdir", mdir.string(), "-F", (tools.rtl_dir / "gnomon.f").string()};
  return joined(std::move(command), verilator_arguments(spec));
}

/// What drives a model, and how it is reached.
struct Driver {
  std::string_view source, abi_source, abi_file, function;
  int abi;
};

Driver driver_of(ModelTop top) {
  if (top == ModelTop::Bus) return {kTopSource, kTopAbiSource, "top_abi.h", "gnomon_top_api", GNOMON_TOP_ABI};
  return {kModelSource, kModelAbiSource, "model_abi.h", "gnomon_model_api", GNOMON_MODEL_ABI};
}

/// What stands beside Verilator's output: the driver, and one source that includes the fast and one the slow
/// parts.
void write_sources(const Driver& driver, const fs::path& work) {
  write_file(work / "model.cpp", driver.source);
  write_file(work / driver.abi_file, driver.abi_source);
  write_file(work / "verilated_top.hpp", kVerilatedTopSource);
  write_file(work / "gnomon_model_print.h", kModelPrintSource);
  write_file(work / "exports.map", "{ global: " + std::string(driver.function) + "; local: *; };\n");
  std::set<fs::path> fast, slow;
  for (const fs::directory_entry& file : fs::directory_iterator(work)) {
    if (file.path().extension() != ".cpp") continue;
    const std::string name = file.path().stem().string();
    (name.ends_with("Slow") || name.ends_with("Syms") ? slow : fast).insert(file.path());
  }
  write_includes(work / "fast.cc", fast);
  write_includes(work / "slow.cc", slow);
}

bool compile_and_link(const Toolchain& tools, const ModelSpec& spec, const fs::path& runtime,
                      const fs::path& work) {
  const std::string trace = spec.trace ? "1" : "0";
  const Arguments instrumentation{"-DVM_TRACE=" + trace, "-DVM_TRACE_FST=" + trace, "-DVM_TRACE_VCD=0",
                                  std::string("-DVM_COVERAGE=") + (spec.coverage ? "1" : "0"),
                                  std::string("-DGNOMON_SAVABLE=") + (spec.coverage ? "0" : "1")};
  const Arguments compile =
      joined(joined(tools.compiler, compile_flags()), joined(instrumentation, include_flags(tools)));
  Process slow(joined(compile, joined(kSlow, {"-c", "slow.cc", "-o", "slow.o"})), work, work / kLog);
  Process fast(joined(compile, joined(level(spec), {"-c", "fast.cc", "-o", "fast.o"})), work, work / kLog);
  const bool compiled = fast.succeeded();
  if (!slow.succeeded() || !compiled) return false;
  const Arguments link{tools.compiler.back(),
                       "-shared",
                       "-o",
                       kModel,
                       "fast.o",
                       "slow.o",
                       runtime.string(),
                       "-lz",
                       "-pthread",
                       "-Wl,--version-script=exports.map",
                       "-Wl,-z,defs"};
  return Process(link, work, work / kLog).succeeded();
}

}  // namespace

ModelCache::ModelCache(Toolchain tools, Notice notice)
    : tools_(std::move(tools)),
      notice_(std::move(notice)),
      artifacts_(tools_.cache_dir),
      versions_(tools_.versions()) {}

Artifact ModelCache::artifact(const ModelSpec& spec) const {
  const Driver driver = driver_of(spec.top);
  std::string manifest = "model abi " + std::to_string(driver.abi) + "\n" + versions_;
  for (const std::string_view source :
       {driver.source, driver.abi_source, kVerilatedTopSource, kModelPrintSource}) {
    manifest += "driver " + content_hash(source) + "\n";
  }
  manifest += "compile " +
              one_line(joined(joined(joined(compile_flags(), level(spec)), kSlow), kRuntimeLevel)) + "\n";
  manifest += "verilate " + one_line(verilator_arguments(spec)) + "\n";
  return {"model", manifest + rtl_manifest(tools_.rtl_dir), kModel};
}

fs::path ModelCache::entry(const ModelSpec& spec) const {
  return artifacts_.entry(artifact(spec));
}

fs::path ModelCache::product(const ModelSpec& spec) {
  const Artifact wanted = artifact(spec);
  if (const auto found = find_artifact(tools_.prebuilt_dir, wanted)) return *found;
  const ArtifactCache::Found found =
      artifacts_.get(wanted, [&](const fs::path& work) { build_model(spec, work); });
  if (found.built) ++built_;
  return found.product;
}

std::shared_ptr<const ModelLibrary> ModelCache::load(const ModelSpec& spec) {
  return std::make_shared<const ModelLibrary>(product(spec));
}

std::shared_ptr<const TopLibrary> ModelCache::load_top(ModelSpec spec) {
  spec.top = ModelTop::Bus;
  return std::make_shared<const TopLibrary>(product(spec));
}

std::optional<std::string> ModelCache::refusal(const ModelSpec& spec) const {
  const fs::path log =
      tools_.cache_dir / ("elaborate-" + content_hash(one_line(verilator_arguments(spec))) + ".log");
  const Arguments command = joined(verilator_command(tools_, spec, tools_.cache_dir), {"--lint-only"});
  const bool accepted = Process(command, tools_.cache_dir, log).succeeded();
  std::optional<std::string> error;
  if (!accepted) error = first_error(log, tools_.rtl_dir);
  fs::remove(log);
  return error;
}

fs::path ModelCache::runtime() {
  const std::string manifest = "verilator runtime\n" + versions_ +
                               one_line(joined(compile_flags(), kRuntimeLevel)) +
                               content_hash(kModelPrintSource);
  const Artifact artifact{"runtime", manifest, kRuntime};
  return artifacts_.get(artifact, [&](const fs::path& work) { build_runtime(work); }).product;
}

void ModelCache::build_runtime(const fs::path& work) const {
  if (notice_) notice_("compiling the Verilator runtime (once)");
  write_file(work / "gnomon_model_print.h", kModelPrintSource);
  const Arguments compile =
      joined(joined(tools_.compiler, compile_flags()), joined(kRuntimeLevel, include_flags(tools_)));
  std::vector<std::unique_ptr<Process>> running;
  Arguments archive{"ar", "rcs", kRuntime};
  for (const std::string name : kRuntimeSources) {
    const std::string source = tools_.verilator_root + "/include/" + name + ".cpp";
    running.push_back(
        std::make_unique<Process>(joined(compile, {"-c", source, "-o", name + ".o"}), work, work / kLog));
    archive.push_back(name + ".o");
  }
  bool succeeded = true;
  for (const auto& process : running) succeeded = process->succeeded() && succeeded;
  if (!succeeded || !Process(archive, work, work / kLog).succeeded()) {
    throw ModelBuildError("the Verilator runtime does not compile: " + first_error(work / kLog, work));
  }
}

void ModelCache::build_model(const ModelSpec& spec, const fs::path& work) {
  const fs::path runtime_archive = runtime();
  if (notice_) notice_("compiling an RTL model with " + describe(spec));
  if (!Process(verilator_command(tools_, spec, work), work, work / kLog).succeeded()) {
    throw ModelBuildError("the RTL refuses " + describe(spec) + ": " +
                          first_error(work / kLog, tools_.rtl_dir));
  }
  write_sources(driver_of(spec.top), work);
  if (!compile_and_link(tools_, spec, runtime_archive, work)) {
    throw ModelBuildError("the model with " + describe(spec) +
                          " does not compile: " + first_error(work / kLog, work));
  }
  for (const fs::directory_entry& file : fs::directory_iterator(work)) {
    const std::string name = file.path().filename().string();
    if (name != kModel && name != kLog) fs::remove(file.path());
  }
}

}  // namespace gnomon::sim
