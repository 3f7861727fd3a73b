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

/// A recording as it lies in the record, and by what it is judged.
struct RecordingToMeasure {
  Trial trial{};
  AttemptRules rules{};
};

/// Decodes and measures recordings on every core while the thread that owns this reads the next ones. What
/// comes out is what one core would have made of them, in the order in which they were given. It waits at its
/// end for what is under way.
class MeasuringAhead {
 public:
  /// `now_us`: when the digests say that they were computed.
  explicit MeasuringAhead(std::int64_t now_us) : now_us_(now_us) {}

  /// Whether so many samples more may be given now; otherwise take some first, so that memory stays bounded.
  /// Always true while nothing is under way.
  [[nodiscard]] bool hasRoomFor(std::int64_t samples) const;
  /// Begins with these; they are measured one after the other.
  void give(std::vector<RecordingToMeasure> recordings);
  [[nodiscard]] bool empty() const { return underWay_.empty(); }
  /// Waits for those that were given first. Throws Error where a recording cannot be read.
  [[nodiscard]] std::vector<TrialDigest> take();

 private:
  struct Batch {
    std::future<std::vector<TrialDigest>> digests{};
    std::int64_t samples = 0;
  };

  std::int64_t now_us_;
  std::deque<Batch> underWay_;
  std::int64_t samples_ = 0;  ///< of all that is under way
};

}  // namespace torsio
