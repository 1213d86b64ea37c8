// SPDX-License-Identifier: Apache-2.0
// The command line as a contract: help, versions, exit statuses, messages.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "host/config/parameter.hpp"
#include "tests/cli/run_gnomon.hpp"
#include "tests/host/scene/files.hpp"

namespace gnomon {
namespace {

using test::HowToRun;
using test::Outcome;
using test::run_gnomon;
using testing::HasSubstr;
using testing::StartsWith;

/// Exit status 2, exactly one line on stderr, nothing on stdout.
void expect_refusal(const Outcome& outcome, const std::string& words) {
  EXPECT_EQ(outcome.status, 2);
  EXPECT_EQ(test::line_count(outcome.err), 1U) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr(words));
  EXPECT_EQ(outcome.out, "");
}

TEST(Help, EveryCommandHasOneWithAnExample) {
  const Outcome program = run_gnomon({"--help"});
  EXPECT_EQ(program.status, 0);
  EXPECT_EQ(program.err, "");
  for (const std::string command : {"run", "verify", "voxelize", "mesh", "slb", "wave", "params", "doctor"}) {
    SCOPED_TRACE(command);
    EXPECT_THAT(program.out, HasSubstr("\n  " + command + " "));
    const Outcome help = run_gnomon({command, "--help"});
    EXPECT_EQ(help.status, 0);
    EXPECT_THAT(help.out, HasSubstr("Example:\n  gnomon " + command));
    EXPECT_EQ(help.err, "");
  }
}

TEST(Version, NamesTheToolsItWasBuiltWith) {
  const Outcome outcome = run_gnomon({"--version"});
  EXPECT_EQ(outcome.status, 0);
  EXPECT_THAT(outcome.out, StartsWith("gnomon "));
  for (const char* tool : {"Verilator 5.", "OpenSubdiv 3.", "Embree 3.", "OpenVDB 10.", "compiler "}) {
    EXPECT_THAT(outcome.out, HasSubstr(tool));
  }
}

TEST(Usage, MistakesAreRefusedInOneLine) {
  expect_refusal(run_gnomon({}), "no command given, expected one of ");
  expect_refusal(run_gnomon({"voxelise"}), "unknown command 'voxelise', did you mean 'voxelize'?");
  expect_refusal(run_gnomon({"frobnicate", "--hard", "x"}), "unknown command 'frobnicate', expected one of ");
  expect_refusal(run_gnomon({"--nonsense"}),
                 "unknown option '--nonsense', expected one of --help, --version");
  expect_refusal(run_gnomon({"params", "--jsn"}), "did you mean '--json'?");
  expect_refusal(run_gnomon({"params", "extra"}), "extra");
  expect_refusal(run_gnomon({"voxelize"}), "required");
  expect_refusal(run_gnomon({"voxelize", "a.obj"}), "--output is required");
  expect_refusal(run_gnomon({"voxelize", "a.obj", "-o"}), "--output");
  expect_refusal(run_gnomon({"voxelize", "a.obj", "-o", "a.png"}),
                 "-o a.png: expected a name that ends in .npy or .vdb");
  expect_refusal(run_gnomon({"wave", "a.obj", "-o", "a.fst"}), "a window is needed");
  expect_refusal(run_gnomon({"wave", "a.obj", "--from", "9", "--to", "3", "-o", "a.fst"}),
                 "--from 9 is after --to 3");
  expect_refusal(run_gnomon({"wave", "a.obj", "--from", "x", "--to", "3", "-o", "a.fst"}), "--from");
  expect_refusal(run_gnomon({"wave", "a.obj", "--from", "1", "--to", "3", "-o", "a.vcd"}), "ends in .fst");
}

class ParameterMessages : public testing::Test {
 protected:
  ParameterMessages() : model_(directory_.write("cube.obj", test::cube_text())) {}
  Outcome voxelize(std::vector<std::string> arguments, const HowToRun& how = {}) const {
    arguments.insert(arguments.begin(),
                     {"voxelize", model_.string(), "-o", (directory_.path() / "cube.npy").string()});
    return run_gnomon(arguments, how);
  }
  test::TempDir directory_;
  std::filesystem::path model_;
};

TEST_F(ParameterMessages, NameTheirOrigin) {
  expect_refusal(voxelize({"--set", "rse=64"}),
                 "command line: error: unknown key 'rse', did you mean 'res'?\n");
  expect_refusal(voxelize({"--set", "res=9"}), "command line: error: res=9 is out of range 16..2048\n");
  expect_refusal(voxelize({"--res", "9"}), "command line: error: res=9 is out of range 16..2048\n");
  expect_refusal(voxelize({"--adjacency", "7"}), "adjacency=7 is out of range 6 | 18 | 26\n");
  expect_refusal(voxelize({"--set", "res"}), "expected --set key=value");
  expect_refusal(voxelize({"--set", "frac_bits=9"}), "frac_bits=9 is out of range 3..8");
  HowToRun how;
  how.environment = {"GNOMON_SET_RES=big"};
  expect_refusal(voxelize({}, how), "environment GNOMON_SET_RES: error: res=big is not an integer\n");
  const auto scene = directory_.write(
      "scene.toml", "[parameters]\nres = 64\ndepth_bits = 99\n[[models]]\npath = \"cube.obj\"\n");
  expect_refusal(run_gnomon({"voxelize", scene.string(), "-o", (directory_.path() / "x.npy").string()}),
                 scene.string() + ":3: error: depth_bits=99 is out of range 8..24\n");
  EXPECT_FALSE(std::filesystem::exists(directory_.path() / "cube.npy"));
}

TEST_F(ParameterMessages, FlagsWinOverTheEnvironmentAndThatOverTheFile) {
  const auto scene =
      directory_.write("scene.toml", "[parameters]\nres = 20\n[[models]]\npath = \"cube.obj\"\n");
  const auto res_of = [&](std::vector<std::string> flags, const HowToRun& how) {
    flags.insert(flags.begin(),
                 {"voxelize", scene.string(), "--json", "-o", (directory_.path() / "x.npy").string()});
    return nlohmann::json::parse(run_gnomon(flags, how).out).at("grid").at("res").get<int>();
  };
  HowToRun how;
  EXPECT_EQ(res_of({}, how), 20);
  how.environment = {"GNOMON_SET_RES=24"};
  EXPECT_EQ(res_of({}, how), 24);
  EXPECT_EQ(res_of({"--set", "res=28"}, how), 28);
}

TEST(Params, PrintsTheRegistry) {
  const Outcome json = run_gnomon({"params", "--json"});
  EXPECT_EQ(json.status, 0);
  EXPECT_EQ(json.err, "");
  std::set<std::string> keys;
  std::map<std::string, std::string> types;
  for (const auto& entry : nlohmann::json::parse(json.out)) {
    keys.insert(entry.at("key"));
    types[entry.at("key")] = entry.at("type");
    for (const char* field : {"type", "range", "default", "unit", "environment", "help"})
      EXPECT_TRUE(entry.contains(field));
  }
  const Outcome table = run_gnomon({"params"});
  EXPECT_EQ(table.status, 0);
  EXPECT_EQ(keys.size(), config::parameters().size());
  EXPECT_EQ(types["res"], "integer");
  EXPECT_EQ(types["pitch"], "number");
  EXPECT_EQ(types["frame_buffer"], "choice");
  EXPECT_EQ(types["technique"], "choices");
  EXPECT_EQ(types["light"], "vector");
  for (const config::Parameter& parameter : config::parameters()) {
    EXPECT_TRUE(keys.contains(std::string(parameter.key)));
    EXPECT_THAT(table.out, HasSubstr(std::string(parameter.key) + " "));
  }
}

TEST(Doctor, FindsWhatThisMachineHas) {
  const Outcome outcome = run_gnomon({"doctor", "--json"});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  const auto findings = nlohmann::json::parse(outcome.out);
  EXPECT_GE(findings.size(), 5U);
  for (const auto& finding : findings)
    EXPECT_TRUE(finding.at("found").get<bool>() || !finding.at("required").get<bool>());
}

TEST(Doctor, SaysWhatIsMissing) {
  HowToRun how;
  how.environment = {"VERILATOR=no-such-verilator", "GNOMON_RTL_DIR=/nowhere"};
  const Outcome outcome = run_gnomon({"doctor"}, how);
  EXPECT_EQ(outcome.status, 2);
  EXPECT_EQ(outcome.err, "gnomon: error: required but missing: no-such-verilator, rtl sources\n");
  EXPECT_THAT(outcome.out, HasSubstr("MISSING  no-such-verilator"));
}

}  // namespace
}  // namespace gnomon
