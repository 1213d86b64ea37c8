// SPDX-License-Identifier: Apache-2.0
// Comparison reports as text and as JSON.
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "sim/compare.hpp"

namespace gnomon::sim {

namespace {

/// Every field of a result word at the place of the difference.
std::string fields(Word word, const Difference& difference, const golden::HardwareConfig& config) {
  if (!difference.raw_word) return golden::describe_result(word);
  return golden::slb::describe_entry_word(word, static_cast<int>(*difference.raw_word), config.slb_config());
}

std::string describe_word(const std::optional<Word>& word, const Difference& difference,
                          const golden::HardwareConfig& config) {
  return word ? fmt::format("{:016x}  {}", *word, fields(*word, difference, config)) : "no such word";
}

std::string describe_query(Word word, const golden::HardwareConfig& config) {
  const golden::slb::QueryPoint point = golden::slb::decode_query(word, config.slb_config());
  return fmt::format("{:016x}  x {} y {} depth {}", word, point.x, point.y, point.depth);
}

std::string describe_item(Word word, const Difference& difference, const golden::HardwareConfig& config) {
  if (difference.command.op == static_cast<std::uint8_t>(golden::slb::SlbOp::Query)) {
    return describe_query(word, config);
  }
  const golden::VoxelItem item = golden::decode_voxel(word, config);
  return fmt::format("{:016x}  position ({}, {}, {}) normal ({}, {}, {})", word, item.position[0],
                     item.position[1], item.position[2], item.normal[0], item.normal[1], item.normal[2]);
}

std::string describe_difference(const Difference& difference, const golden::HardwareConfig& config) {
  std::string text = fmt::format("first difference: result word {}\n", difference.result);
  if (difference.after_stream) {
    text += "  the stream asks for no such word\n";
  } else {
    text += fmt::format("  command   {}  {}\n  result    {} of the command\n", difference.command_index,
                        golden::describe_header(golden::encode(difference.command)), difference.item_index);
  }
  if (difference.item)
    text += fmt::format("  item      {}\n", describe_item(*difference.item, difference, config));
  if (difference.cycle) text += fmt::format("  cycle     {}\n", *difference.cycle);
  text += fmt::format("  expected  {}\n", describe_word(difference.expected, difference, config));
  text += fmt::format("  rtl       {}\n", describe_word(difference.actual, difference, config));
  return text;
}

nlohmann::json word_json(const std::optional<Word>& word, const Difference& difference,
                         const golden::HardwareConfig& config) {
  if (!word) return nullptr;
  return {{"word", fmt::format("{:016x}", *word)}, {"fields", fields(*word, difference, config)}};
}

nlohmann::json difference_json(const Difference& difference, const golden::HardwareConfig& config) {
  nlohmann::json json{{"result_index", difference.result},
                      {"expected", word_json(difference.expected, difference, config)},
                      {"rtl", word_json(difference.actual, difference, config)}};
  if (difference.cycle) json["cycle"] = *difference.cycle;
  if (!difference.after_stream) {
    json["command_index"] = difference.command_index;
    json["command"] = golden::describe_header(golden::encode(difference.command));
    json["item_index"] = difference.item_index;
  }
  if (difference.raw_word) json["raw_word"] = *difference.raw_word;
  if (difference.item) json["item"] = describe_item(*difference.item, difference, config);
  return json;
}

nlohmann::json config_json(const golden::HardwareConfig& config) {
  nlohmann::json json{{"voxel_bits", config.voxel_bits},       {"voxel_frac_bits", config.voxel_frac_bits},
                      {"normal_bits", config.normal_bits},     {"matrix_frac_bits", config.matrix_frac_bits},
                      {"depth_bits", config.depth_bits},       {"plane_log2", config.plane_log2},
                      {"en_vpu_offset", config.en_vpu_offset}, {"en_slb", config.en_slb}};
  if (!config.en_slb) return json;
  json.update({{"slb_plane_log2", config.slb_plane_log2},
               {"frac_bits", config.frac_bits},
               {"slope_bits", config.slope_bits},
               {"frags_per_pixel", config.frags_per_pixel},
               {"subpixel_bits", config.subpixel_bits},
               {"query_bits", config.query_bits},
               {"slb_rounding", static_cast<int>(config.slb_rounding)}});
  return json;
}

}  // namespace

std::string to_text(const CompareReport& report) {
  std::string text;
  if (!report.fault.empty()) text += "the rtl engine stopped: " + report.fault + "\n";
  if (!report.partial.empty()) text += "partial: " + report.partial + "\n";
  if (report.first) text += describe_difference(*report.first, report.config);
  if (report.expected_words != report.actual_words && report.partial.empty()) {
    text += fmt::format("{} result words expected, {} given\n", report.expected_words, report.actual_words);
  }
  for (const CounterDifference& counter : report.counters) {
    text += fmt::format("counter {}: expected {}, rtl {}\n", counter.name, counter.expected, counter.actual);
  }
  if (report.plane_entries_differing != 0) {
    text += fmt::format("{} of {} plane entries differ\n", report.plane_entries_differing,
                        report.plane_entries_compared);
  }
  if (report.words_compared == 0) text += "no result word was compared: nothing is verified\n";
  if (!report.passed()) text += fmt::format("seed {}, {}\n", report.seed, describe(report.config));
  return text + fmt::format("{} words compared, {} differ\n", report.words_compared, report.words_differing);
}

nlohmann::json to_json(const CompareReport& report) {
  nlohmann::json json{{"passed", report.passed()},
                      {"config", config_json(report.config)},
                      {"seed", report.seed},
                      {"commands", report.commands},
                      {"cycles", report.cycles},
                      {"words_compared", report.words_compared},
                      {"words_differing", report.words_differing},
                      {"expected_words", report.expected_words},
                      {"rtl_words", report.actual_words},
                      {"plane_entries_compared", report.plane_entries_compared},
                      {"plane_entries_differing", report.plane_entries_differing},
                      {"counter_differences", nlohmann::json::array()},
                      {"rtl_events", report.rtl_counters.events},
                      {"rtl_cycles", report.rtl_counters.cycles}};
  for (const CounterDifference& counter : report.counters) {
    json["counter_differences"].push_back(
        {{"name", counter.name}, {"expected", counter.expected}, {"rtl", counter.actual}});
  }
  if (report.first) json["first_difference"] = difference_json(*report.first, report.config);
  if (!report.partial.empty()) json["partial"] = report.partial;
  if (!report.fault.empty()) json["fault"] = report.fault;
  return json;
}

}  // namespace gnomon::sim
