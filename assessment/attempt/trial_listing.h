// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "assessment/domain/ids.h"
#include "assessment/domain/study/protocol_terms.h"
#include "sim/record/trial.h"

namespace torsio {

/// The machine that recorded, in words: what a late tick is explained by. Empty: not known.
struct RecordingHost {
  std::string name{};
  std::string os{};
  std::string cpu{};
  std::string gpu{};
  friend bool operator==(const RecordingHost&, const RecordingHost&) = default;
};

/// What the database adds to a trial's header.
struct TrialContext {
  std::string station{};      ///< which machine records: it alone may close its interrupted trials
  EnrolmentId enrolmentId{};  ///< the cohort for which the trial counts; empty for free practice
  ModuleId moduleId{};        ///< of the curriculum version that was running; empty for free practice
  PhaseId phaseId{};          ///< empty: outside any phase
  std::optional<AttemptMode> attemptMode{};  ///< as it counted then; empty for free practice
  RecordingHost host{};
  friend bool operator==(const TrialContext&, const TrialContext&) = default;
};

/// One line of a list of trials.
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
  std::optional<TrialSummary> summary{};  ///< empty: running, or interrupted and not closed yet
  ModuleId moduleId{};
  PhaseId phaseId{};
  std::optional<AttemptMode> attemptMode{};  ///< empty: free practice
  TissueModel model = TissueModel::kTwist;   ///< that answered the hand
};

/// Which trials to list, newest first. Empty texts do not restrict.
struct TrialFilter {
  std::string traineeCode{};
  EnrolmentId enrolmentId{};
  SceneId sceneId{};
  std::int64_t limit = 200;
  std::int64_t offset = 0;
  ModuleId moduleId{};
};

}  // namespace torsio
