// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "app/connectors/tracker/tracker_link.h"
#include "app/services/recording/recording_spec.h"
#include "sim/record/recorder.h"
#include "sim/record/trial.h"

namespace torsio {

/// What stands in the recordings of a tracker as the pattern of the exercise.
inline constexpr const char* kRealArmPattern = "real arm";

/// A stretch on the real arm as a tracker follows the instrument: a recording of kForeignScene on the clock
/// of the station, kept like those of the simulator. Late poses are the late ticks of its summary. Belongs to
/// the thread that made it; the link outlives it.
class TrackedRecording {
 public:
  /// Begins. `view`: how it stands with the tracker, whose period must be known (contract); `sink` gets the
  /// recording.
  TrackedRecording(TrackerLink& link, const TrackerView& view, const RecordingSpec& spec,
                   std::unique_ptr<TrialSink> sink);
  /// Ends. Without finish() the recording stays with its sink as interrupted.
  ~TrackedRecording();
  TrackedRecording(const TrackedRecording&) = delete;
  TrackedRecording& operator=(const TrackedRecording&) = delete;

  /// Hands the rest to the sink. Once. Throws what Recorder::finish throws.
  [[nodiscard]] RecordingResult finish(TrialOutcome outcome);

 private:
  TrackerLink& link_;
  std::shared_ptr<SpscRing<Sample>> samples_;
  std::unique_ptr<TrialSink> sink_;
  Recorder recorder_;
};

}  // namespace torsio
