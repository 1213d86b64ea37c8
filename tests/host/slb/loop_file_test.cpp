// SPDX-License-Identifier: Apache-2.0
// Loop files: what they hold, and where they say something is wrong.
#include "host/slb/loop_file.hpp"

#include <gmock/gmock.h>

#include "tests/host/scene/files.hpp"

namespace gnomon::slb {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

class LoopFileTest : public testing::Test {
 protected:
  Result<LoopFile> read(std::string_view text) const { return read_loops(directory_.write("l.json", text)); }
  /// The message without the file's path.
  std::string refusal(std::string_view text) const {
    const Result<LoopFile> file = read(text);
    if (file) return "not refused";
    const std::string path = (directory_.path() / "l.json").string();
    EXPECT_THAT(file.error().message, StartsWith(path));
    EXPECT_EQ(file.error().message.find('\n'), std::string::npos);
    return file.error().message.substr(path.size());
  }
  gnomon::test::TempDir directory_;
};

TEST_F(LoopFileTest, ReadsObjectsLoopsAndVertices) {
  const Result<LoopFile> file = read(R"({"objects":[
    {"depth":0.25,"loops":[[[1,2],[3.5,2],[3,4e0]],[[-1,0],[0,0],[0,-1e-3],[5,5]]]},
    {"loops":[],"depth":1}]})");
  ASSERT_TRUE(file) << file.error().message;
  ASSERT_EQ(file->scene.size(), 2U);
  EXPECT_EQ(file->scene[0].depth, 0.25);
  EXPECT_THAT(file->scene[0].loops[0], ElementsAre(Vec2(1, 2), Vec2(3.5, 2), Vec2(3, 4)));
  EXPECT_THAT(file->scene[0].loops[1], ElementsAre(Vec2(-1, 0), Vec2(0, 0), Vec2(0, -1e-3), Vec2(5, 5)));
  EXPECT_EQ(file->scene[1].depth, 1);
  EXPECT_TRUE(file->scene[1].loops.empty());
  EXPECT_TRUE(file->notes.empty());
}

TEST_F(LoopFileTest, LeavesOutAClosingVertexAndSaysSo) {
  const Result<LoopFile> file =
      read(R"({"objects":[{"depth":0,"loops":[[[0,0],[1,0],[0,1]],[[0,0],[1,0],[0,1],[0,0]]]}]})");
  ASSERT_TRUE(file);
  EXPECT_EQ(file->scene[0].loops[1], file->scene[0].loops[0]);
  ASSERT_EQ(file->notes.size(), 1U);
  EXPECT_THAT(file->notes[0],
              HasSubstr("object 0, loop 1 (objects[0].loops[1]): the last vertex repeats the first"));
}

TEST_F(LoopFileTest, NotesKeysThatItDoesNotKnow) {
  const Result<LoopFile> file =
      read(R"({"comment":"x","objects":[{"depth":0,"name":"a","loops":[[[0,0],[1,0],[0,1]]]}]})");
  ASSERT_TRUE(file);
  ASSERT_EQ(file->notes.size(), 2U);
  EXPECT_THAT(file->notes[0], HasSubstr("comment: key ignored"));
  EXPECT_THAT(file->notes[1], HasSubstr("object 0 (objects[0].name): key ignored"));
}

/// A file whose second object's third loop is `loop`.
std::string with_loop(const std::string& loop) {
  const std::string good = "[[0,0],[1,0],[0,1]]";
  return "{\"objects\":[{\"depth\":0,\"loops\":[]},\n{\"depth\":0.5,\"loops\":[" + good + "," + good + "," +
         loop + "]}]}";
}

TEST_F(LoopFileTest, NamesObjectLoopAndVertex) {
  const std::string vertex = ": error: object 1, loop 2, vertex 1 (objects[1].loops[2][1]): ";
  const std::string on_line = ":2" + vertex;
  EXPECT_EQ(refusal(with_loop("[[0,0],[1,null],[0,1]]")), vertex + "y is null, expected a finite number");
  EXPECT_EQ(refusal(with_loop("[[0,0],[\"1\",0],[0,1]]")), vertex + "x is \"1\", expected a finite number");
  EXPECT_LT(refusal(with_loop("[[0,0],[\"" + std::string(5000, 'x') + "\",0],[0,1]]")).size(), 200U);
  EXPECT_EQ(refusal(with_loop("[[0,0],[true,0],[0,1]]")), vertex + "x is true, expected a finite number");
  EXPECT_EQ(refusal(with_loop("[[0,0],[1],[0,1]]")), vertex + "an array of 1, expected [x, y]");
  EXPECT_EQ(refusal(with_loop("[[0,0],[1,0,0],[0,1]]")), vertex + "an array of 3, expected [x, y]");
  EXPECT_EQ(refusal(with_loop("[[0,0],{\"x\":1,\"y\":0},[0,1]]")), vertex + "an object, expected [x, y]");
  EXPECT_EQ(refusal(with_loop("[[0,0],7,[0,1]]")), vertex + "7, expected [x, y]");
  // What only other programs take for JSON.
  EXPECT_EQ(refusal(with_loop("[[0,0],[1,NaN],[0,1]]")), on_line + "NaN is not a finite number");
  EXPECT_EQ(refusal(with_loop("[[0,0],[-Infinity,0],[0,1]]")), on_line + "-Infinity is not a finite number");
  EXPECT_EQ(refusal(with_loop("[[0,0],[Infinity,0],[0,1]]")), on_line + "Infinity is not a finite number");
  EXPECT_THAT(refusal(with_loop("[[0,0],[1e999,0],[0,1]]")), HasSubstr("object 1, loop 2, vertex 1"));
  EXPECT_THAT(refusal(with_loop("[[0,0],[1e999,0],[0,1]]")), HasSubstr("'1e999', expected a finite number"));
}

TEST_F(LoopFileTest, NamesObjectAndLoop) {
  const std::string loop = ": error: object 1, loop 2 (objects[1].loops[2]): ";
  EXPECT_EQ(refusal(with_loop("[]")), loop + "0 vertices, expected three or more");
  EXPECT_EQ(refusal(with_loop("[[0,0]]")), loop + "1 vertex, expected three or more");
  EXPECT_EQ(refusal(with_loop("[[0,0],[1,0]]")), loop + "2 vertices, expected three or more");
  EXPECT_EQ(refusal(with_loop("[[0,0],[1,0],[0,0]]")),
            loop + "2 vertices (the last repeats the first), expected three or more");
  EXPECT_EQ(refusal(with_loop("3")), loop + "3, expected an array of vertices [x, y]");
}

TEST_F(LoopFileTest, RefusesOtherShapes) {
  EXPECT_EQ(refusal("[]"), ": error: an array of 0, expected {\"objects\": [...]}");
  EXPECT_EQ(refusal("{}"), ": error: there is no key 'objects', expected an array of objects");
  EXPECT_EQ(refusal(R"({"objects":{}})"), ": error: objects: an object, expected an array of objects");
  EXPECT_EQ(refusal(R"({"objects":[4]})"),
            ": error: object 0 (objects[0]): 4, expected {\"depth\": ..., \"loops\": [...]}");
  EXPECT_EQ(refusal(R"({"objects":[{"loops":[]}]})"),
            ": error: object 0 (objects[0]): there is no key 'depth', expected a number 0..1");
  EXPECT_EQ(refusal(R"({"objects":[{"depth":"0","loops":[]}]})"),
            ": error: object 0 (objects[0]): depth is \"0\", expected a number 0..1");
  EXPECT_EQ(refusal(R"({"objects":[{"depth":1.5,"loops":[]}]})"),
            ": error: object 0 (objects[0]): depth is 1.5, expected 0..1");
  EXPECT_EQ(refusal(R"({"objects":[{"depth":0}]})"),
            ": error: object 0 (objects[0]): there is no key 'loops', expected an array of loops");
  EXPECT_EQ(refusal(R"({"objects":[{"depth":0,"depth":1,"loops":[]}]})"),
            ": error: object 0 (objects[0].depth): key appears twice");
}

TEST_F(LoopFileTest, RefusesWhatIsNotJson) {
  EXPECT_THAT(refusal(""), StartsWith(":1: error: is not JSON: "));
  EXPECT_THAT(refusal("{\"objects\":\n[{\"depth\":0,]}"), StartsWith(":2: error: object 0"));
  EXPECT_THAT(refusal("\x89PNG\r\n\x1a\n"), HasSubstr("is not JSON"));
  EXPECT_LT(refusal(std::string(100000, '[')).size(), 400U);
  const Result<LoopFile> missing = read_loops(directory_.path() / "none.json");
  ASSERT_FALSE(missing);
  EXPECT_THAT(missing.error().message, HasSubstr("none.json: error: cannot be read: No such file"));
  const Result<LoopFile> folder = read_loops(directory_.path());
  ASSERT_FALSE(folder);
  EXPECT_THAT(folder.error().message, HasSubstr("is a directory"));
}

}  // namespace
}  // namespace gnomon::slb
