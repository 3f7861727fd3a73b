// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "app/services/recording/recording_spec.h"
#include "assessment/domain/ids.h"
#include "sim/record/trial.h"

namespace torsio::gui {

/// A recording in the list to choose from.
struct RecordedTrial {
  TrialId id;
  SceneId sceneId;
  PatternId patternId;
  std::int64_t startedUtc_us = 0;
  double duration_s = 0.0;
};

/// Storage of the window's trials. All functions throw Error with a displayable reason. Called in the GUI
/// thread; the sink is then called only in the recorder's thread (sim/record/recorder.h).
struct TrialRecording {
  /// Returns a sink for a new trial: the recorder passes it header, chunks and summary. Null if nothing can
  /// be stored.
  std::function<std::unique_ptr<TrialSink>(const RecordingSpec&)> open;
  /// Newest first.
  std::function<std::vector<RecordedTrial>()> list;
  std::function<Trial(const std::string& id)> load;
  /// Name of the database or folder, for display.
  std::string place;
};

/// Stores trials as files in a folder, created on demand: the window's default.
[[nodiscard]] TrialRecording trialFiles(const std::string& folder);

}  // namespace torsio::gui
