// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "app/services/access/session_context.h"
#include "app/services/review/blinded_case.h"
#include "assessment/domain/ids.h"
#include "assessment/domain/rating/instrument.h"
#include "assessment/domain/rating/rubric.h"

namespace torsio {

/// A reference run as seen by a rater. Shows the panel's mark only after the rater's own.
struct CalibrationRun {
  std::size_t number = 0;  ///< 1, 2 ...: "Reference 1"
  std::optional<std::int64_t> length_us{};
  std::optional<std::int64_t> own_steps{};  ///< latest attempt
  std::optional<double> panel_points{};
  std::optional<double> offset_points{};  ///< own minus panel mark
  std::int64_t panelRaters = 0;
  std::size_t tries = 0;
};

struct RaterCalibration {
  RubricRevision rubric{};  ///< of the first run; its anchors help with the overall mark
  std::vector<CalibrationRun> runs{};
  [[nodiscard]] bool complete() const noexcept;
  /// Returns the mean over the scored runs, points; empty if there are none.
  [[nodiscard]] std::optional<double> meanOffset_points() const;
};

/// kMarkSubmit.
[[nodiscard]] RaterCalibration raterCalibration(SessionContext& session);
/// Returns the blinded recording of run `number`. kTrialViewAssigned: reference runs are for every rater.
/// Throws Error{kBadData} for an unknown run.
[[nodiscard]] BlindedRecording loadReferenceRun(SessionContext& session, std::size_t number);
/// Stores the rater's overall mark with its offset from the panel; earlier attempts are kept. kMarkSubmit;
/// audited. Throws Error{kBadData} for an unknown run or a mark outside the scale.
void scoreReferenceRun(SessionContext& session, std::size_t number, std::int64_t score_steps);

/// A recording that can become a reference run: complete, never one before, and not assigned for scoring (the
/// panel's mark would reveal the expected score).
struct ReferenceCandidate {
  TrialId trialId{};
  std::string traineeCode{};  ///< empty: no trainee
  SceneId sceneId{};
  std::string phaseLabel{};
  std::int64_t length_us = 0;
  std::int64_t startedUtc_us = 0;
  bool demonstration = false;
};
/// Latest first. kStudySetup.
[[nodiscard]] std::vector<ReferenceCandidate> referenceCandidates(SessionContext& session);

/// A reference run as seen by the administrator.
struct ReferenceRow {
  std::size_t number = 0;  ///< number shown to raters: 1, 2 ...; 0: withdrawn
  TrialId trialId{};
  std::string traineeCode{};  ///< empty: no trainee
  SceneId sceneId{};
  std::optional<std::int64_t> length_us{};
  ScoreScale scale{};
  double panel_points = 0.0;
  std::int64_t panelRaters = 1;
  std::int64_t setUtc_us = 0;
  std::string withdrawnBecause{};  ///< empty: in use
};
/// In the order of rater calibration, withdrawn ones last. kStudySetup.
[[nodiscard]] std::vector<ReferenceRow> referenceRows(SessionContext& session);

/// A recording chosen by the administrator for rater calibration.
struct ReferenceChoice {
  TrialId trialId{};
  RubricRevisionId rubricRevisionId{};
  double panel_points = 0.0;
  std::int64_t panelRaters = 1;
  bool demonstration = false;
};
/// Appends reference runs. kStudySetup; audited. Throws Error{kBadData} for an unknown rubric, a recording
/// that is missing, unfinished or was a reference run before; {kBadParameter} for a mark outside the rubric's
/// scale, or an empty panel.
void addReferenceRuns(SessionContext& session, const std::vector<ReferenceChoice>& runs);
/// Withdraws a run permanently: raters have seen it, so it cannot return as new. It stays stored with the
/// raters' scores; later runs move up. kStudySetup; audited with the reason. Throws Error{kBadData} for an
/// unknown run; {kBadParameter} without a reason.
void withdrawReferenceRun(SessionContext& session, const TrialId& trialId, const std::string& reason);

}  // namespace torsio
