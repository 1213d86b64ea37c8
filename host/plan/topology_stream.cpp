// SPDX-License-Identifier: Apache-2.0
// A topology plan as command words, and result words as answers (docs/vpu-topology.md, "Commands").
#include <fmt/format.h>

#include <algorithm>
#include <gnomon/golden/stream.hpp>

#include "host/plan/topology_plan.hpp"

namespace gnomon::plan {
namespace {

namespace topology = golden::topology;

/// Appends commands of the mode; lists too long for one command become several.
class TopologyWriter {
 public:
  explicit TopologyWriter(std::vector<golden::Word> words) : words_(std::move(words)) {}

  void command(topology::TopologyOp op, std::uint8_t flags, std::uint32_t arg,
               std::span<const golden::Word> items) {
    constexpr std::size_t kMost = golden::kMaxItems / topology::kWordsPerQuad * topology::kWordsPerQuad;
    do {
      const auto part = items.first(std::min(items.size(), kMost));
      words_.push_back(golden::encode(golden::Header{.op = static_cast<std::uint8_t>(op),
                                                     .flags = flags,
                                                     .count = static_cast<std::uint16_t>(part.size()),
                                                     .arg = arg}));
      words_.insert(words_.end(), part.begin(), part.end());
      items = items.subspan(part.size());
    } while (!items.empty());
  }
  void append(std::span<const golden::Word> words) {
    words_.insert(words_.end(), words.begin(), words.end());
  }
  std::vector<golden::Word> take() { return std::move(words_); }

 private:
  std::vector<golden::Word> words_;
};

}  // namespace

std::vector<golden::Word> topology_stream(const TopologyPlan& plan, const voxel::VoxelSet& voxels,
                                          const std::vector<bool>& two_sided) {
  golden::StreamWriter common(plan.vpu.config);
  common.set_registers(golden::Register::MatrixUx, plan.vpu.registers);
  TopologyWriter writer(common.take());
  writer.command(topology::TopologyOp::ClearLists, 0, 0, {});

  std::vector<golden::Word> words(plan.items.size());
  std::transform(plan.items.begin(), plan.items.end(), words.begin(),
                 [&](const golden::VoxelItem& item) { return golden::encode(item, plan.vpu.config); });
  std::vector<golden::Word> corners;
  corners.reserve(plan.quads.size() * topology::kWordsPerQuad);
  for (const voxel::VoxelQuad& quad : plan.quads)
    for (const std::uint32_t corner : quad) corners.push_back(words[corner]);
  writer.command(topology::TopologyOp::PutQuads, 0, 0, corners);

  // Voxels are sorted by object, so each object is one run.
  const std::span<const golden::Word> all = words;
  for (std::size_t first = 0; first < all.size();) {
    const auto object = voxels.voxels[first].object;
    std::size_t end = first;
    while (end < all.size() && voxels.voxels[end].object == object) ++end;
    const auto flags = static_cast<std::uint8_t>((two_sided.at(object) ? topology::kTwoSided : 0) |
                                                 (plan.settings.sorted ? topology::kSorted : 0));
    writer.command(topology::TopologyOp::ResolveTopology, flags, plan.clearance,
                   all.subspan(first, end - first));
    first = end;
  }
  common.fence(0, true);
  writer.append(common.words());
  return writer.take();
}

Result<std::vector<topology::TopologyResult>> topology_results(std::span<const golden::Word> results,
                                                               std::size_t expected) {
  constexpr int kCode = 56;
  std::vector<topology::TopologyResult> voxels;
  voxels.reserve(expected);
  for (const auto word : results) {
    if (golden::result_code(word) == golden::ResultCode::Error)
      return fail("the hardware refused a command: " + golden::describe_result(word));
    if (word >> kCode == static_cast<std::uint64_t>(topology::TopologyOp::ResolveTopology))
      voxels.push_back(topology::decode_topology_result(word));
  }
  if (voxels.size() != expected)
    return fail(fmt::format("the hardware returned {} voxel states, expected {}", voxels.size(), expected));
  return voxels;
}

}  // namespace gnomon::plan
