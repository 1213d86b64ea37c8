// SPDX-License-Identifier: Apache-2.0
// What cannot be a control cage is refused, with one line that says where and why.
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include "host/scene/obj_reader.hpp"
#include "tests/host/scene/files.hpp"
#include "tests/host/scene/malformed_obj.hpp"

namespace gnomon::scene {
namespace {

class MalformedObjTest : public testing::TestWithParam<test::MalformedObj> {};

TEST_P(MalformedObjTest, IsRefusedWithFileLineAndReason) {
  const test::TempDir directory;
  const std::string path = directory.write("bad.obj", GetParam().text).string();
  const Result<ObjModel> model = read_obj(path);
  ASSERT_FALSE(model.has_value());
  const std::string& message = model.error().message;
  const std::string place =
      GetParam().line == 0 ? path + ": error: " : path + ":" + std::to_string(GetParam().line) + ": error: ";
  EXPECT_TRUE(message.starts_with(place)) << message;
  EXPECT_NE(message.find(GetParam().words), std::string::npos) << message;
  EXPECT_EQ(message.find('\n'), std::string::npos) << message;
}

INSTANTIATE_TEST_SUITE_P(Files, MalformedObjTest, testing::ValuesIn(test::malformed_objs()),
                         [](const auto& file) { return file.param.name; });

TEST(ObjErrors, CountsLinesThroughCrLfAndContinuations) {
  const test::TempDir directory;
  const auto path =
      directory.write("bad.obj", "v 0 0 0\r\nv 1 0 0\r\nv 0 \\\r\n 1 \\\r\n 0\r\nf 1 2 \\\r\n 7\r\n");
  EXPECT_EQ(read_obj(path).error().message,
            path.string() + ":6: error: vertex index 7 is out of range, expected 1..3 or -3..-1");
}

TEST(ObjErrors, NamesTheFirstOfSeveralFaults) {
  const test::TempDir directory;
  const auto path = directory.write("bad.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 8\nf 1 2 9\nf 1 2 3\n");
  EXPECT_NE(read_obj(path).error().message.find(":4: error: vertex index 8"), std::string::npos);
}

TEST(ObjErrors, MissingFile) {
  const Result<ObjModel> model = read_obj("/nowhere/cube.obj");
  ASSERT_FALSE(model.has_value());
  EXPECT_EQ(model.error().message, "/nowhere/cube.obj: error: cannot be read: No such file or directory");
}

TEST(ObjErrors, Directory) {
  const test::TempDir directory;
  EXPECT_EQ(read_obj(directory.path()).error().message,
            directory.path().string() + ": error: is a directory, expected a file");
}

/// Gives up root's rights for a while: root may read everything.
class AsNobody {
 public:
  AsNobody() : changed_(geteuid() == 0 && seteuid(65534) == 0) {}
  ~AsNobody() {
    if (changed_ && seteuid(0) != 0) ADD_FAILURE() << "cannot become root again";
  }
  AsNobody(const AsNobody&) = delete;
  AsNobody& operator=(const AsNobody&) = delete;

 private:
  bool changed_;
};

TEST(ObjErrors, NoReadPermission) {
  const test::TempDir directory;
  const auto path = directory.write("secret.obj", test::cube_text());
  ASSERT_EQ(chmod(path.c_str(), 0), 0);
  const AsNobody nobody;
  ASSERT_NE(geteuid(), 0U);
  const Result<ObjModel> model = read_obj(path);
  ASSERT_FALSE(model.has_value());
  EXPECT_EQ(model.error().message, path.string() + ": error: cannot be read: Permission denied");
}

}  // namespace
}  // namespace gnomon::scene
