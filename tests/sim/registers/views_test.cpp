// SPDX-License-Identifier: Apache-2.0
// SystemVerilog, C and C++ have the same numbers for every register.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <regex>
#include <span>
#include <sstream>
#include <string>

#include "firmware/driver/gnomon_registers.h"
#include "sim/registers/registers.hpp"

namespace gnomon::sim::registers::test {
namespace {

using Constants = std::map<std::string, std::uint32_t>;

std::string text_of(const std::string& path) {
  std::ifstream file(std::string(GNOMON_SOURCE_DIR) + "/" + path);
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

/// Group 1 of the pattern is the name, group 2 the value in hexadecimal.
Constants constants(const std::string& path, const std::string& pattern) {
  const std::string text = text_of(path);
  const std::regex form(pattern);
  Constants result;
  for (std::sregex_iterator match(text.begin(), text.end(), form), end; match != end; ++match)
    result[(*match)[1]] = static_cast<std::uint32_t>(std::stoul((*match)[2], nullptr, 16));
  return result;
}

Constants of_systemverilog() {
  return constants("rtl/system/gnomon_registers_pkg.sv",
                   R"(localparam bit \[31:0\] (GNOMON_\w+) = 32'h(\w+);)");
}
Constants of_c() {
  return constants("firmware/driver/gnomon_registers.h", R"(#define (GNOMON_\w+) 0x(\w+)U)");
}

TEST(RegisterViews, SystemVerilogAndCHaveTheSameConstants) {
  const Constants c = of_c();
  EXPECT_GT(c.size(), 200u);
  EXPECT_EQ(c, of_systemverilog());
}

std::size_t compare_offsets(std::span<const RegisterInfo> table, const std::string& prefix,
                            const Constants& c) {
  for (const RegisterInfo& info : table)
    EXPECT_EQ(c.at(prefix + std::string(info.name).append("_OFFSET")), info.offset) << info.name;
  return table.size();
}

TEST(RegisterViews, CppTablesHaveEveryRegisterOfC) {
  const Constants c = of_c();
  std::size_t in_c = 0;
  for (const auto& [name, value] : c) in_c += name.ends_with("_OFFSET") ? 1U : 0U;
  EXPECT_EQ(compare_offsets(hardware::kRegisters, "GNOMON_", c) +
                compare_offsets(mailbox::kRegisters, "GNOMON_MAILBOX_", c) +
                compare_offsets(timer::kRegisters, "GNOMON_TIMER_", c),
            in_c);
}

std::string quoted(std::string_view name) {
  std::string text(1, '`');
  text += name;
  text += '`';
  return text;
}

TEST(RegisterViews, ThePageNamesEveryRegister) {
  const std::string page = text_of("docs/registers.md");
  using Table = std::span<const RegisterInfo>;
  for (const Table table :
       {Table(hardware::kRegisters), Table(mailbox::kRegisters), Table(timer::kRegisters)})
    for (const RegisterInfo& info : table) EXPECT_THAT(page, testing::HasSubstr(quoted(info.name)));
}

TEST(RegisterViews, TheCompilerReadsThem) {
  EXPECT_EQ(GNOMON_CONTROL_ENABLE_MASK, hardware::kControlEnableMask);
  EXPECT_EQ(GNOMON_ERROR_CODE_IS_TIMEOUT, hardware::kErrorCodeIsTimeout);
  EXPECT_EQ(GNOMON_MAILBOX_LOG_OFFSET, mailbox::kLogOffset);
  EXPECT_EQ(GNOMON_TIMER_BASE, timer::kBase);
}

}  // namespace
}  // namespace gnomon::sim::registers::test
