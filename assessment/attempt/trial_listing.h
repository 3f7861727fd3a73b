// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "assessment/domain/ids.h"
#include "assessment/domain/study/protocol_terms.h"
#include "sim/record/trial.h"

namespace torsio {

/// Description of the recording machine, for explaining late ticks. Empty: unknown.
struct RecordingHost {
  std::string name{};
  std::string os{};
  std::string cpu{};
  std::string gpu{};
  friend bool operator==(const RecordingHost&, const RecordingHost&) = default;
};

/// What the database adds to a trial's header.
struct TrialContext {
  std::string station{};      ///< the recording machine, which alone may close its interrupted trials
  EnrolmentId enrolmentId{};  ///< the cohort that the trial counts for; empty for free practice
  ModuleId moduleId{};        ///< of the curriculum version then running; empty for free practice
  PhaseId phaseId{};          ///< empty: no phase
  std::optional<AttemptMode> attemptMode{};  ///< at the time; empty for free practice
  RecordingHost host{};
  ImportId importId{};  ///< the import it came with; empty: recorded in this record
  friend bool operator==(const TrialContext&, const TrialContext&) = default;
};

/// A trial in a list.
struct TrialListing {
  TrialId trialId{};
  std::string traineeCode{};  ///< empty: nobody (free practice)
  EnrolmentId enrolmentId{};
  std::string station{};
  SceneId sceneId{};
  PatternId patternId{};
  std::string phaseLabel{};
  std::int64_t startedUtc_us = 0;
  bool demonstration = false;
  std::optional<TrialSummary> summary{};  ///< empty: running, or interrupted and not yet closed
  ModuleId moduleId{};
  PhaseId phaseId{};
  std::optional<AttemptMode> attemptMode{};  ///< empty: free practice
  TissueModel model = TissueModel::kTwist;   ///< of the run
  std::string deviceModel{};                 ///< as the recording names it
};

/// Trials to list, latest first. Empty texts do not restrict.
struct TrialFilter {
  std::string traineeCode{};
  EnrolmentId enrolmentId{};
  SceneId sceneId{};
  std::int64_t limit = 200;
  std::int64_t offset = 0;
  ModuleId moduleId{};
};

}  // namespace torsio
