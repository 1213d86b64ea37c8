// SPDX-License-Identifier: Apache-2.0
// Flat casters and receivers as a command stream, and what its results say.
#include "host/slb/loop_stream.hpp"

#include <fmt/format.h>

#include <gnomon/golden/stream.hpp>
#include <stdexcept>

namespace gnomon::slb {

using golden::Word;

std::vector<Word> loop_stream(std::span<const FixedCaster> casters,
                              std::span<const golden::slb::QueryPoint> queries,
                              const golden::HardwareConfig& config, bool read_entries) {
  golden::StreamWriter writer(config);
  writer.slb_clear();
  for (std::size_t i = 0; i < casters.size(); ++i) {
    if (casters[i].loops.empty()) continue;
    writer.begin_object(static_cast<std::uint8_t>(i % 256), casters[i].depth);
    for (const auto& loop : casters[i].loops) writer.loop(loop);
    writer.fill();
    writer.end_object();
  }
  writer.query(queries, 0);
  if (read_entries) {
    const auto side = static_cast<std::uint32_t>(config.slb_config().side());
    writer.read_entries(0, side * side);
  }
  writer.fence(0, false);
  return writer.take();
}

LoopResults decode_results(std::span<const Word> results, std::size_t queries,
                           const golden::HardwareConfig& config) {
  LoopResults decoded;
  golden::ResultReader reader(results);
  while (const auto result = reader.next()) {
    const auto code = static_cast<std::uint8_t>(golden::result_code(result->word));
    if (code == golden::slb::kAnswerCode) {
      decoded.answers.push_back(golden::slb::decode_answer(result->word));
    } else if (code == golden::slb::kEntryCode) {
      decoded.entries.push_back(
          golden::slb::unpack_entry({result->raw.begin(), result->raw.end()}, config.slb_config()));
    } else if (code != static_cast<std::uint8_t>(golden::ResultCode::Fence)) {
      throw std::logic_error("a sound command was refused: " + golden::describe_result(result->word));
    }
  }
  if (decoded.answers.size() != queries) {
    throw std::logic_error(
        fmt::format("{} answers to {} queries came back", decoded.answers.size(), queries));
  }
  return decoded;
}

}  // namespace gnomon::slb
