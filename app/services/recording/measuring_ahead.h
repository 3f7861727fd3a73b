// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <future>
#include <vector>

#include "assessment/attempt/attempt_measures.h"
#include "assessment/attempt/trial_digest.h"
#include "sim/record/trial.h"

namespace torsio {

/// A stored recording and the rules for judging it.
struct RecordingToMeasure {
  Trial trial{};
  AttemptRules rules{};
};

/// Decodes and measures recordings on all cores while the owning thread reads the next ones. The results and
/// their order are the same as on one core. The destructor waits for work in progress.
class MeasuringAhead {
 public:
  /// `now_us`: computation time written into the digests.
  explicit MeasuringAhead(std::int64_t now_us) : now_us_(now_us) {}

  /// Returns whether this many more samples may be given now; otherwise take some results first, so that
  /// memory stays bounded. Always true if nothing is in progress.
  [[nodiscard]] bool hasRoomFor(std::int64_t samples) const;
  /// Starts measuring a batch, one recording after the other.
  void give(std::vector<RecordingToMeasure> recordings);
  [[nodiscard]] bool empty() const { return underWay_.empty(); }
  /// Waits for the oldest batch. Throws Error if a recording cannot be read.
  [[nodiscard]] std::vector<TrialDigest> take();

 private:
  struct Batch {
    std::future<std::vector<TrialDigest>> digests{};
    std::int64_t samples = 0;
  };

  std::int64_t now_us_;
  std::deque<Batch> underWay_;
  std::int64_t samples_ = 0;  ///< of all batches in progress
};

}  // namespace torsio
