// SPDX-License-Identifier: Apache-2.0
// --engine system: the same words as the hardware alone gives, and what firmware, bus and DRAM did for them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/cli/run_gnomon.hpp"
#include "tests/host/scene/files.hpp"

namespace gnomon {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using test::Outcome;
using test::run_gnomon;
using testing::HasSubstr;

using Words = std::vector<std::string>;

class SystemTest : public testing::Test {
 protected:
  SystemTest() : model_(directory_.write("cube.obj", test::cube_text())) {}
  Outcome gnomon(Words arguments, const Words& more = {}) const {
    arguments.insert(arguments.end(), {model_.string(), "--set", "res=32", "-q"});
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run_gnomon(arguments);
  }
  /// The figures of a run.
  json run(const Words& more) const {
    Words arguments{"--set", "image_width=80", "--set", "image_height=60", "-o", results().string()};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Outcome outcome = gnomon({"run"}, arguments);
    EXPECT_EQ(outcome.status, 0) << outcome.out << outcome.err;
    return json::parse(std::ifstream(results() / "metrics.json"));
  }
  fs::path results() const { return directory_.path() / "results"; }
  std::string page() const {
    std::ostringstream text;
    text << std::ifstream(results() / "report.html").rdbuf();
    return text.str();
  }
  test::TempDir directory_;
  fs::path model_;
};

TEST_F(SystemTest, GivesTheWordsOfTheHardwareAlone) {
  for (const std::string technique : {"voxel-offset", "slb"}) {
    SCOPED_TRACE(technique);
    const Words set{"--set", "technique=" + technique, "--set", "plane=64"};
    Words rtl = set, system = set;
    rtl.insert(rtl.end(), {"--engine", "rtl"});
    system.insert(system.end(), {"--engine", "system", "--set", "system_hardware=core"});
    const json alone = run(rtl), within = run(system);
    EXPECT_EQ(within.at("engine"), "system");
    EXPECT_GT(within.at("compare").at("words"), 1000);
    EXPECT_EQ(within.at("compare"), alone.at("compare"));
    EXPECT_EQ(within.at("events"), alone.at("events"));
    EXPECT_GT(within.at("system").at("cycles"), within.at("cycles").at("total"));
    EXPECT_TRUE(alone.at("system").is_null());
  }
}

TEST_F(SystemTest, SaysWhatFirmwareBusAndMemoryDid) {
  const fs::path log = directory_.path() / "bus.jsonl";
  const json m = run({"--engine", "system", "--log-transactions", log.string()});
  EXPECT_EQ(m.at("system").at("inside"), "top");
  EXPECT_GT(m.at("compare").at("words"), 1000);
  EXPECT_EQ(m.at("compare").at("differing"), 0);
  const json& system = m.at("system");
  EXPECT_THAT(system.at("firmware").at("log").at(0).get<std::string>(), HasSubstr("gnomon firmware"));
  EXPECT_EQ(system.at("firmware").at("jobs"), 1);
  EXPECT_GT(system.at("firmware").at("instructions_per_job"), 100);
  EXPECT_GT(system.at("firmware").at("asleep_share"), 0.2);
  EXPECT_EQ(system.at("firmware").at("cycles_polling"), 0) << "it waits for interrupts";
  EXPECT_EQ(system.at("bus").at(0).at("target"), "dram");
  // Commands once, results once.
  const auto words = m.at("memory").at("command_stream_bits").get<std::uint64_t>() / 8 +
                     m.at("memory").at("result_stream_bits").get<std::uint64_t>() / 8;
  EXPECT_GE(system.at("dram").at("bytes"), words);
  std::uint64_t causes = 0, transactions = 0, on_bus = 0;
  for (const auto& [name, pass] : m.at("cycles").at("by_pass").items())
    for (const auto& [cause, cycles] : pass.at("causes").items()) causes += cycles.get<std::uint64_t>();
  EXPECT_EQ(m.at("cycles").at("total"), causes);
  EXPECT_NEAR(static_cast<double>(causes), system.at("cycles").get<double>(), 100) << "each has a cause";
  std::ifstream lines(log);
  for (std::string line; std::getline(lines, line);)
    transactions += json::parse(line).at("event") == "transaction" ? 1U : 0U;
  for (const json& target : system.at("bus"))
    on_bus += target.at("reads").get<std::uint64_t>() + target.at("writes").get<std::uint64_t>();
  EXPECT_EQ(transactions, on_bus);
  EXPECT_THAT(page(), HasSubstr("Log of the firmware"));
  EXPECT_THAT(page(), HasSubstr("gnomon firmware: hardware"));
}

TEST_F(SystemTest, ItsParametersChangeCyclesNeverWords) {
  const Words fast{"--engine", "system", "--set", "system_hardware=golden"};
  Words slow = fast;
  slow.insert(slow.end(), {"--set", "memory_latency=200", "--set", "dram_banks=1", "--set", "quantum=10"});
  const json a = run(fast), b = run(slow);
  EXPECT_TRUE(a.at("cycles").is_null()) << "golden has none";
  EXPECT_EQ(a.at("system").at("inside"), "golden");
  EXPECT_EQ(a.at("compare"), b.at("compare"));
  EXPECT_GT(b.at("system").at("cycles").get<double>(), 1.5 * a.at("system").at("cycles").get<double>());
  const Outcome outcome = gnomon({"run"}, {"--set", "dram_banks=0"});
  EXPECT_EQ(outcome.status, 2);
  EXPECT_THAT(outcome.err, HasSubstr("dram_banks=0 is out of range 1..1024"));
}

TEST_F(SystemTest, VerifiesAndSaysHowToRepeatAFailure) {
  const Words technique{"--engine", "system",   "--set", "technique=voxel-offset,slb",
                        "--set",    "plane=64", "--set", "system_hardware=core"};
  const Outcome sound = gnomon({"verify"}, technique);
  EXPECT_EQ(sound.status, 0) << sound.out << sound.err;
  EXPECT_EQ(test::line_count(sound.out), 2U) << sound.out;
  EXPECT_THAT(sound.out, HasSubstr(" 0 differ "));
  const Outcome faulty = gnomon({"verify"}, {"--engine", "system", "--set", "system_hardware=core",
                                             "--define", "GNOMON_MUTATE_ROUND_DEPTH"});
  EXPECT_EQ(faulty.status, 1);
  EXPECT_THAT(faulty.out, HasSubstr("--engine system --set res=32"));
  EXPECT_THAT(faulty.out, HasSubstr("--define GNOMON_MUTATE_ROUND_DEPTH"));
}

TEST_F(SystemTest, EndsAfterSoManyCyclesAndSaysSo) {
  std::string limit;
  for (const std::string engine : {"system", "rtl"}) {
    const auto all = run({"--engine", engine}).at("cycles").at("total").get<std::uint64_t>();
    limit = std::to_string(all * 85 / 100);  // while voxels are answered
    const json m = run({"--engine", engine, "--term-after-cycles", limit});
    EXPECT_EQ(m.at("compare").at("partial"), "stopped after " + limit + " cycles");
    EXPECT_THAT(m.at("compare").at("verdict").get<std::string>(), HasSubstr("partial, stopped after"));
    EXPECT_GT(m.at("compare").at("words"), 10);
    EXPECT_EQ(m.at("compare").at("differing"), 0);
    EXPECT_LT(m.at("compare").at("words").get<double>() * 64,
              m.at("memory").at("result_stream_bits").get<double>());
    EXPECT_THAT(page(), HasSubstr("partial, stopped after " + limit + " cycles"));
  }
  EXPECT_EQ(gnomon({"run"}, {"--engine", "golden", "--term-after-cycles", "9"}).status, 2);
  const Outcome verify = gnomon({"verify"}, {"--term-after-cycles", limit});
  EXPECT_EQ(verify.status, 0) << verify.out << verify.err;
  EXPECT_THAT(verify.out, HasSubstr("partial: stopped after " + limit + " cycles"));
}

TEST_F(SystemTest, CtrlCLeavesAReportThatSaysItIsPartial) {
  const fs::path log = directory_.path() / "bus.jsonl";
  test::HowToRun how;
  // The hardware works: its first accesses are in the log, which still has another name.
  how.interrupt_when = [&] {
    std::error_code renamed;
    for (const fs::directory_entry& file : fs::directory_iterator(directory_.path()))
      if (file.path().extension() == ".jsonl" && file.file_size(renamed) > 0 && !renamed) return true;
    return false;
  };
  const Outcome outcome =
      run_gnomon({"run", model_.string(), "-q", "--set", "res=256", "--set", "image_width=16", "--set",
                  "image_height=16", "--engine", "system", "--set", "system_hardware=golden", "--set",
                  "quantum=100", "--log-transactions", log.string(), "-o", results().string()},
                 how);
  EXPECT_EQ(outcome.status, 130);
  EXPECT_THAT(outcome.err, HasSubstr("interrupted, the comparison is partial"));
  const json compare = json::parse(std::ifstream(results() / "metrics.json")).at("compare");
  EXPECT_THAT(compare.at("partial").get<std::string>(), HasSubstr("interrupted at cycle "));
  EXPECT_THAT(compare.at("verdict").get<std::string>(), HasSubstr("partial, interrupted at cycle "));
  EXPECT_EQ(compare.at("differing"), 0);
  EXPECT_THAT(page(), HasSubstr("partial, interrupted at cycle "));
}

TEST_F(SystemTest, WritesWaveformsOfTriggers) {
  const auto wave = [&](const char* name, Words how) {
    how.insert(how.end(), {"-o", (directory_.path() / name).string()});
    return gnomon({"wave"}, how);
  };
  const Outcome query =
      wave("query.fst", {"--set", "technique=slb", "--set", "plane=64", "--first", "query"});
  EXPECT_EQ(query.status, 0) << query.err;
  EXPECT_THAT(query.out, HasSubstr("query.fst: cycles "));
  EXPECT_GT(fs::file_size(directory_.path() / "query.fst"), 1000U);
  // The first place of the command ring, where the host puts it.
  const Outcome ring = wave("ring.fst", {"--engine", "system", "--address", "2147487744"});
  EXPECT_EQ(ring.status, 0) << ring.err;
  EXPECT_GT(fs::file_size(directory_.path() / "ring.fst"), 1000U);
  const Outcome nowhere = wave("none.fst", {"--engine", "system", "--address", "64"});
  EXPECT_EQ(nowhere.status, 2);
  EXPECT_THAT(nowhere.err, HasSubstr("no access of the hardware touches it"));
  EXPECT_THAT(wave("none.fst", {"--first", "teleport"}).err, HasSubstr("no such command"));
  EXPECT_THAT(wave("none.fst", {"--address", "64"}).err, HasSubstr("--engine system"));
  EXPECT_FALSE(fs::exists(directory_.path() / "none.fst"));
}

TEST_F(SystemTest, CtrlCEndsTheSearchForAnAddress) {
  test::HowToRun how;
  how.interrupt_at = std::chrono::milliseconds(1500);  // half of what the search takes
  const Outcome outcome =
      run_gnomon({"wave", model_.string(), "-q", "--set", "res=1024", "--engine", "system", "--set",
                  "system_hardware=golden", "--address", "64", "-o", (directory_.path() / "w.fst").string()},
                 how);
  EXPECT_EQ(outcome.status, 130);
  EXPECT_EQ(outcome.err, "gnomon: interrupted, nothing was written\n");
}

TEST_F(SystemTest, RunsAndVerifiesWithWaveforms) {
  const fs::path window = directory_.path() / "window.fst", fault = directory_.path() / "fault.fst";
  run({"--trace", window.string(), "--trace-from", "50", "--trace-to", "90"});
  EXPECT_GT(fs::file_size(window), 1000U);
  EXPECT_EQ(gnomon({"verify"}, {"--trace", fault.string()}).status, 0);
  EXPECT_FALSE(fs::exists(fault)) << "no difference, no waveform";
  const Outcome faulty =
      gnomon({"verify"}, {"--trace", fault.string(), "--define", "GNOMON_MUTATE_ROUND_DEPTH"});
  EXPECT_EQ(faulty.status, 1) << faulty.err;
  EXPECT_THAT(faulty.out, HasSubstr("fault.fst: cycles "));
  EXPECT_GT(fs::file_size(fault), 1000U);
  EXPECT_EQ(gnomon({"run"}, {"--trace", "w.vcd"}).status, 2);
  EXPECT_EQ(gnomon({"run"}, {"--log-transactions", "b.jsonl"}).status, 2) << "there is no bus";
}

}  // namespace
}  // namespace gnomon
