// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/simulator/trial_recording.h"

#include <algorithm>
#include <filesystem>
#include <utility>

#include "sim/core/error.h"
#include "sim/core/file_io.h"
#include "sim/record/trial_file.h"

namespace torsio::gui {

namespace {

namespace fs = std::filesystem;

const char* const kEnding = ".trial";

fs::path fileOf(const std::string& folder, const std::string& id) {
  return fs::path(folder) / (id + kEnding);
}

std::vector<RecordedTrial> listFolder(const std::string& folder) {
  std::vector<RecordedTrial> trials;
  std::error_code missing;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, missing)) {
    if (entry.path().extension() != kEnding) {
      continue;
    }
    try {
      const Trial trial = readTrialFile(entry.path());
      const double tick_s = static_cast<double>(trial.header.tickPeriod_us) * 1e-6;
      trials.push_back({.id = trial.header.trialId,
                        .sceneId = trial.header.sceneId,
                        .patternId = trial.header.patternId,
                        .startedUtc_us = trial.header.startedUtc_us,
                        .duration_s = static_cast<double>(trial.summary.samples) * tick_s});
    } catch (const Error&) {
      // Skips a damaged file; the others are still listed.
    }
  }
  std::sort(trials.begin(), trials.end(),
            [](const RecordedTrial& a, const RecordedTrial& b) { return a.startedUtc_us > b.startedUtc_us; });
  return trials;
}

}  // namespace

TrialRecording trialFiles(const std::string& folder) {
  TrialRecording recording;
  recording.place = folder;
  recording.open = [folder](const RecordingSpec& spec) -> std::unique_ptr<TrialSink> {
    ensureFolder(folder);
    return std::make_unique<TrialFileSink>(fileOf(folder, spec.trialId));
  };
  recording.list = [folder] { return listFolder(folder); };
  recording.load = [folder](const std::string& id) { return readTrialFile(fileOf(folder, id)); };
  return recording;
}

}  // namespace torsio::gui
