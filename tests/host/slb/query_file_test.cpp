// SPDX-License-Identifier: Apache-2.0
// Query files: rows in order, faults by line.
#include "host/slb/query_file.hpp"

#include <gmock/gmock.h>

#include "tests/host/scene/files.hpp"

namespace gnomon::slb {
namespace {

using testing::HasSubstr;

class QueryFileTest : public testing::Test {
 protected:
  Result<QueryFile> read(std::string_view text) const {
    return read_queries(directory_.write("q.csv", text));
  }
  std::string refusal(std::string_view text) const {
    const Result<QueryFile> file = read(text);
    if (file) return "not refused";
    return file.error().message.substr((directory_.path() / "q.csv").string().size());
  }
  gnomon::test::TempDir directory_;
};

TEST_F(QueryFileTest, ReadsRowsInOrder) {
  for (const char* text :
       {"1,2.5,0.5\n-3e-1,0,1\n", "1,2.5,.5\r\n-0.3,0,1", " +1 , 2.5,\t0.5\n-.3,0,1\n\n \n"}) {
    const Result<QueryFile> file = read(text);
    ASSERT_TRUE(file) << file.error().message;
    EXPECT_FALSE(file->has_header);
    ASSERT_EQ(file->receivers.size(), 2U);
    EXPECT_EQ(file->receivers[0].x, 1);
    EXPECT_EQ(file->receivers[0].y, 2.5);
    EXPECT_EQ(file->receivers[0].z, 0.5);
    EXPECT_EQ(file->receivers[1].x, -0.3);
    EXPECT_EQ(file->receivers[1].z, 1);
  }
}

TEST_F(QueryFileTest, SkipsAHeader) {
  const Result<QueryFile> file = read("x, y, z\n1,2,3\n");
  ASSERT_TRUE(file);
  EXPECT_TRUE(file->has_header);
  EXPECT_EQ(file->receivers.size(), 1U);
  EXPECT_EQ(refusal("1,2,3\nx,y,z\n"), ":2: error: x is 'x', expected a finite number");
}

TEST_F(QueryFileTest, NamesTheLine) {
  EXPECT_EQ(refusal("1,2,3\n1,2\n"), ":2: error: 2 columns, expected three: x,y,z");
  EXPECT_EQ(refusal("1,2,3,\n"), ":1: error: 4 columns, expected three: x,y,z");
  EXPECT_EQ(refusal("1 2 3\n"), ":1: error: 1 column, expected three: x,y,z");
  EXPECT_EQ(refusal("1,nan,3\n"), ":1: error: y is 'nan', expected a finite number");
  EXPECT_EQ(refusal("1,2,inf\n"), ":1: error: z is 'inf', expected a finite number");
  EXPECT_EQ(refusal("1,2,1e999\n"), ":1: error: z is '1e999', expected a finite number");
  EXPECT_EQ(refusal("1,2,3\n1,2,3x\n"), ":2: error: z is '3x', expected a finite number");
  EXPECT_EQ(refusal("1,,3\n"), ":1: error: y is '', expected a finite number");
  EXPECT_EQ(refusal("1,2,3\n\n4,5,6\n"), ":2: error: a blank line between rows, expected x,y,z");
}

TEST_F(QueryFileTest, RefusesFilesWithoutQueries) {
  EXPECT_EQ(refusal(""), ": error: holds no queries, expected rows x,y,z");
  EXPECT_EQ(refusal("\n\n"), ": error: holds no queries, expected rows x,y,z");
  EXPECT_EQ(refusal("x,y,z\n"), ": error: holds no queries, expected rows x,y,z");
  const Result<QueryFile> missing = read_queries(directory_.path() / "none.csv");
  ASSERT_FALSE(missing);
  EXPECT_THAT(missing.error().message, HasSubstr("none.csv: error: cannot be read: No such file"));
}

TEST(AnswersText, IsOneDigitALine) {
  EXPECT_EQ(answers_text({true, false, false}), "1\n0\n0\n");
  EXPECT_EQ(answers_text({}), "");
}

}  // namespace
}  // namespace gnomon::slb
