// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdint>
#include <memory>

#include "app/cli/cli.h"
#include "app/gui/window_main.h"
#include "app/session/trial_store.h"

namespace {

/// The window's recordings go to the database of this station.
torsio::gui::TrialRecording recordingInDatabase() {
  const auto store = std::make_shared<torsio::TrialStore>(torsio::defaultDatabase());
  torsio::gui::TrialRecording recording;
  recording.open = [store](const torsio::TrialHeader&) { return store->newSink(); };
  recording.list = [store] {
    const std::int64_t tickPeriod_us = torsio::TrialHeader{}.tickPeriod_us;  // the window records at no other
    std::vector<torsio::gui::RecordedTrial> trials;
    for (const torsio::TrialListing& trial : store->list()) {
      if (!trial.summary) continue;
      const double duration_s = static_cast<double>(trial.summary->samples * tickPeriod_us) * 1e-6;
      trials.push_back({trial.trialId, trial.sceneId, trial.patternId, trial.startedUtc_us, duration_s});
    }
    return trials;
  };
  recording.load = [store](const std::string& id) { return store->load(id); };
  recording.place = store->location();
  return recording;
}

}  // namespace

int main(int argc, char** argv) {
  if (torsio::cli::wantsCommandLine(argc, argv)) return torsio::cli::runCommandLine(argc, argv);
  try {
    return torsio::gui::runWindow(argc, argv, recordingInDatabase);
  } catch (...) {
    return torsio::cli::reportFailure();
  }
}
