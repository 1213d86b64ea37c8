// SPDX-License-Identifier: Apache-2.0
// What a header of the unit must look like, and which command may follow which (docs/command-stream.md).
#pragma once

#include <cstdint>
#include <gnomon/golden/slb/codec.hpp>

namespace gnomon::golden::slb {

constexpr bool is_slb_op(std::uint8_t op) {
  return op >= kFirstSlbOp && op <= kLastSlbOp;
}

/// Flag bits with a meaning.
std::uint8_t known_flags(SlbOp op);
/// A count where none belongs, or entries beyond the plane's last.
bool bad_argument(SlbOp op, std::uint32_t arg, std::size_t count, const SlbConfig& config);
/// Result words of a sound command.
std::uint32_t result_words(SlbOp op, std::uint32_t arg, std::size_t count, const SlbConfig& config);

/// The unit's state as far as it decides what may come next. Starts as after reset.
class SlbSequence {
 public:
  bool allows(SlbOp op) const;
  /// A sound command that is allowed.
  void advance(SlbOp op, std::uint8_t flags);
  bool operator==(const SlbSequence&) const = default;

 private:
  enum class State : std::uint8_t { Idle, Object, Loop, Filled };
  State state_ = State::Idle;
  bool has_loops_ = false;  ///< the object has had a LOOP
};

}  // namespace gnomon::golden::slb
