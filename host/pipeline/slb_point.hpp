// SPDX-License-Identifier: Apache-2.0
// One configuration of the silhouette-line buffer over shared work: the figures that a run gives, for less.
// Theory: docs/sweep.md, "Shared work".
#pragma once

#include <vector>

#include "host/base/result.hpp"
#include "host/pipeline/engines.hpp"
#include "host/pipeline/slb_shared.hpp"

namespace gnomon::pipeline {

struct SlbPoint {
  /// As a run's, but nothing is compared, drawn as a picture or read back, and its events and words are those
  /// of `work`.
  report::RunRecord record;
  /// Draws the casters and asks about every voxel that faces the light. What is asked besides, for the
  /// error's sake, is no work.
  std::vector<golden::Word> work;
  EngineAnswers answers;  ///< golden's to `work`, with predicted cycles
};

/// `request` as for run(); of its settings, those of technique slb. Fails where they make no legal hardware.
Result<SlbPoint> measure_slb(const RunRequest& request, SlbShared& shared,
                             const std::vector<report::StageTime>& stages);

/// The point's work on the rtl engine, compared with golden's answers. Fails where there is no model.
Result<RtlAnswers> run_work(const RunRequest& request, const SlbPoint& point);

}  // namespace gnomon::pipeline
