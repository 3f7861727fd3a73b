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

/// One line of the list from which a recording is chosen.
struct RecordedTrial {
  TrialId id;
  SceneId sceneId;
  PatternId patternId;
  std::int64_t startedUtc_us = 0;
  double duration_s = 0.0;
};

/// Where the window keeps trials and takes them from. Every function throws Error with a reason that can be
/// shown. The window calls them from the GUI thread; the sink itself is then called from the recorder's
/// thread only (sim/record/recorder.h).
struct TrialRecording {
  /// A sink for a new trial: the recorder hands it header, chunks and summary. Null while nothing can be
  /// kept.
  std::function<std::unique_ptr<TrialSink>(const RecordingSpec&)> open;
  /// Newest first.
  std::function<std::vector<RecordedTrial>()> list;
  std::function<Trial(const std::string& id)> load;
  /// Where that is, for people: the name of a database or folder.
  std::string place;
};

/// Trials as files in one folder, made when needed: what the window uses when it was given nothing else.
[[nodiscard]] TrialRecording trialFiles(const std::string& folder);

}  // namespace torsio::gui
