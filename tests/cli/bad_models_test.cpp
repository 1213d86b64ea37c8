// SPDX-License-Identifier: Apache-2.0
// Malformed models end in one line, exit status 2, and nothing written.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include "tests/cli/run_gnomon.hpp"
#include "tests/host/scene/files.hpp"
#include "tests/host/scene/malformed_obj.hpp"

namespace gnomon {
namespace {

namespace fs = std::filesystem;
using test::Outcome;
using testing::HasSubstr;
using testing::StartsWith;

class BadModel : public testing::Test {
 protected:
  BadModel() { fs::create_directory(results()); }
  fs::path results() const { return directory_.path() / "results"; }
  Outcome voxelize(const fs::path& model, const test::HowToRun& how = {}) const {
    return test::run_gnomon({"voxelize", model.string(), "-o", (results() / "x.npy").string(), "-o",
                             (results() / "x.vdb").string()},
                            how);
  }
  void expect_refusal(const Outcome& outcome, const std::string& start, const std::string& words) const {
    EXPECT_EQ(outcome.status, 2);
    EXPECT_EQ(test::line_count(outcome.err), 1U) << outcome.err;
    EXPECT_THAT(outcome.err, StartsWith(start));
    EXPECT_THAT(outcome.err, HasSubstr(words));
    EXPECT_EQ(outcome.out, "");
    EXPECT_TRUE(fs::is_empty(results()));
  }
  test::TempDir directory_;
};

TEST_F(BadModel, OfEveryKindIsRefused) {
  std::size_t refused = 0;
  for (const test::MalformedObj& bad : test::malformed_objs()) {
    SCOPED_TRACE(bad.name);
    const fs::path model = directory_.write(bad.name + ".obj", bad.text);
    const std::string place =
        bad.line == 0 ? model.string() : model.string() + ":" + std::to_string(bad.line);
    expect_refusal(voxelize(model), place + ": error: ", bad.words);
    ++refused;
  }
  EXPECT_GE(refused, 50U);
}

TEST_F(BadModel, ThatIsMissingADirectoryOrUnreadable) {
  expect_refusal(voxelize(directory_.path() / "none.obj"), (directory_.path() / "none.obj").string(),
                 "No such file or directory");
  expect_refusal(voxelize(directory_.path()), directory_.path().string(), "is a directory");
  const fs::path secret = directory_.write("secret.obj", test::cube_text());
  ASSERT_EQ(chmod(secret.c_str(), 0), 0);
  ASSERT_EQ(chmod(results().c_str(), 0777), 0);
  test::HowToRun how;
  how.as_nobody = true;
  expect_refusal(voxelize(secret, how), secret.string() + ": error: ", "Permission denied");
}

TEST_F(BadModel, InASceneFileIsNamed) {
  directory_.write("bad.obj", "v 0 0 0\nv 1 0 0\nf 1 2\n");
  const fs::path scene = directory_.write("scene.toml", "[[models]]\npath = \"bad.obj\"\n");
  expect_refusal(voxelize(scene),
                 (directory_.path() / "bad.obj").string() + ":3: error: ", "face has 2 vertices");
  expect_refusal(voxelize(directory_.write("typo.toml", "[[model]]\npath = \"bad.obj\"\n")),
                 (directory_.path() / "typo.toml").string() + ":1: error: ", "did you mean 'models'?");
}

}  // namespace
}  // namespace gnomon
