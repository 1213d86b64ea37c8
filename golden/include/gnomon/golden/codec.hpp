// SPDX-License-Identifier: Apache-2.0
// Words of the command and result streams, packed and unpacked: the only place in C++ that knows their bits
// (docs/command-stream.md).
#pragma once

#include <array>
#include <cstdint>
#include <gnomon/golden/config.hpp>
#include <gnomon/golden/engine.hpp>
#include <gnomon/golden/slb/codec.hpp>
#include <string>

namespace gnomon::golden {

/// Of the command processor and the projection unit; the silhouette-line buffer's are slb::SlbOp.
enum class Op : std::uint8_t {
  Nop = 0x00,
  SetRegisters = 0x01,
  ClearPlane = 0x02,
  Fence = 0x03,
  ReadPlane = 0x04,
  ProjectVoxels = 0x10,
  ResolveVoxels = 0x11,
};

inline constexpr std::uint8_t kFenceClearSticky = 0x01;
inline constexpr std::uint8_t kResolveTwoSided = 0x01;
inline constexpr int kMaxItems = 65535;

struct Header {
  std::uint8_t op = 0;
  std::uint8_t flags = 0;
  std::uint16_t count = 0;
  std::uint32_t arg = 0;
};
Word encode(const Header& header);
Header decode_header(Word word);

// One row of the matrix a line.
// clang-format off
enum class Register : std::uint8_t {
  MatrixUx, MatrixUy, MatrixUz, MatrixU1,
  MatrixVx, MatrixVy, MatrixVz, MatrixV1,
  MatrixDx, MatrixDy, MatrixDz, MatrixD1,
  OffsetFactor, FacingShift, TiltShift, DeltaShift, MarginSquared, DeltaMax,
  // Only with EN_PERSPECTIVE.
  Projection,
  MatrixWx, MatrixWy, MatrixWz, MatrixW1,
  WNear, CentreU, CentreV, KeyLimit, KeyScale,
  LightX, LightY, LightZ, ConeSquared,
};
// clang-format on
inline constexpr int kRegisterCount = 18;  ///< of hardware without EN_PERSPECTIVE
inline constexpr int kPerspectiveRegisterCount = 14;
inline constexpr int kAllRegisterCount = kRegisterCount + kPerspectiveRegisterCount;
/// Registers of this configuration.
inline int register_count(const HardwareConfig& config) {
  return config.en_perspective ? kAllRegisterCount : kRegisterCount;
}
// Bits of PROJECTION.
inline constexpr std::int64_t kProjectionPerspective = 1;
inline constexpr std::int64_t kProjectionCone = 2;

/// Width and signedness of a register in this configuration.
struct RegisterFormat {
  const char* name;
  int width;  ///< bits, sign included
  bool is_signed;
  int frac_bits;
};
RegisterFormat register_format(Register reg, const HardwareConfig& config);

/// A voxel item: position in ulps of 2^-VOXEL_FRAC_BITS voxels, integer normal.
struct VoxelItem {
  std::array<std::uint32_t, 3> position{};
  std::array<std::int32_t, 3> normal{};
  bool operator==(const VoxelItem&) const = default;
};
/// Fields are cut to their widths; what does not fit is the caller's mistake.
Word encode(const VoxelItem& item, const HardwareConfig& config);
VoxelItem decode_voxel(Word word, const HardwareConfig& config);

/// As Op; slb::kAnswerCode and slb::kEntryCode are the silhouette-line buffer's.
enum class ResultCode : std::uint8_t { Fence = 0x03, PlaneEntry = 0x04, VoxelState = 0x11, Error = 0xFF };
ResultCode result_code(Word word);

enum class ErrorCode : std::uint8_t {
  UnknownOp = 1,
  FeatureAbsent = 2,
  BadRegister = 3,
  BadArgument = 4,
  ReservedFlag = 5,
  BadSequence = 6
};

// Bits 8 and up are slb::kSticky...
inline constexpr std::uint32_t kStickyErrorSeen = 1;
inline constexpr std::uint32_t kStickyOffPlane = 2;
inline constexpr std::uint32_t kStickyDepthSaturated = 4;
// Bits 3 and 4 are topology::kSticky...
inline constexpr std::uint32_t kStickyBehindLight = 32;

enum class VoxelState : std::uint8_t { Empty = 0, Lit = 1, Shadow = 2 };

struct VoxelResult {
  VoxelState state = VoxelState::Lit;
  bool facing_away = false, off_plane = false, uncertain = false, offset_empty = false, beyond_max = false;
  bool outside_cone = false, behind = false;  ///< the two ways to be unreached; at most one is set
  std::uint32_t nearest = 0xFFFFFF;
  std::uint32_t delta = 0;
  bool operator==(const VoxelResult&) const = default;
};
Word encode(const VoxelResult& result);
VoxelResult decode_voxel_result(Word word);

struct FenceResult {
  std::uint32_t sticky = 0, tag = 0;
};
Word encode(const FenceResult& result);
FenceResult decode_fence_result(Word word);

struct PlaneEntryResult {
  std::uint32_t index = 0;
  bool present = false;
  std::uint32_t depth = 0;
};
Word encode(const PlaneEntryResult& result);
PlaneEntryResult decode_plane_entry_result(Word word);

struct ErrorResult {
  std::uint8_t error = 0;
  std::uint32_t command_index = 0;
};
Word encode(const ErrorResult& result);
ErrorResult decode_error_result(Word word);

/// One line naming every field of a result or command word, for mismatch reports and logs.
/// Raw words of an entry are not results on their own: slb::describe_entry_word.
std::string describe_result(Word word);
std::string describe_header(Word word);

}  // namespace gnomon::golden
