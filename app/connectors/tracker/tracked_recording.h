// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "app/connectors/tracker/tracker_link.h"
#include "app/services/recording/recording_spec.h"
#include "sim/record/recorder.h"
#include "sim/record/trial.h"

namespace torsio {

/// Pattern of the exercise in a tracker's recordings.
inline constexpr const char* kRealArmPattern = "real arm";

/// Records training on the real arm from a tracker: a recording of kForeignScene by the station's clock,
/// stored like those of the simulator. Late poses count as late ticks. Used by one thread; the link outlives
/// it.
class TrackedRecording {
 public:
  /// Starts. `view`: state of the tracker, whose period must be known (contract); `sink` gets the recording.
  TrackedRecording(TrackerLink& link, const TrackerView& view, const RecordingSpec& spec,
                   std::unique_ptr<TrialSink> sink);
  /// Without finish(), the recording stays in the sink as interrupted.
  ~TrackedRecording();
  TrackedRecording(const TrackedRecording&) = delete;
  TrackedRecording& operator=(const TrackedRecording&) = delete;

  /// Passes the rest to the sink. Call once. Throws what Recorder::finish throws.
  [[nodiscard]] RecordingResult finish(TrialOutcome outcome);

 private:
  TrackerLink& link_;
  std::shared_ptr<SpscRing<Sample>> samples_;
  std::unique_ptr<TrialSink> sink_;
  Recorder recorder_;
};

}  // namespace torsio
