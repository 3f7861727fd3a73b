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

/// A reference run as a rater sees it. What the panel said is there only after the own score.
struct CalibrationRun {
  std::size_t number = 0;  ///< 1, 2 ...: "Reference 1"
  std::optional<std::int64_t> length_us{};
  std::optional<std::int64_t> own_steps{};  ///< newest try
  std::optional<double> panel_points{};
  std::optional<double> offset_points{};  ///< own minus panel
  std::int64_t panelRaters = 0;
  std::size_t tries = 0;
};

struct RaterCalibration {
  RubricRevision rubric{};  ///< of the first run; anchors help to find the overall mark
  std::vector<CalibrationRun> runs{};
  [[nodiscard]] bool complete() const noexcept;
  /// Mean over the runs that were scored, points; empty: none.
  [[nodiscard]] std::optional<double> meanOffset_points() const;
};

/// kMarkSubmit.
[[nodiscard]] RaterCalibration raterCalibration(SessionContext& session);
/// The recording of run `number`, blinded like a case. kTrialViewAssigned: reference runs are for every
/// rater. Throws Error{kBadData}: no such run.
[[nodiscard]] BlindedRecording loadReferenceRun(SessionContext& session, std::size_t number);
/// Stores the rater's overall mark with its offset from the panel; a second try is kept beside the first.
/// kMarkSubmit; audited. Throws Error{kBadData}: no such run, or outside the scale.
void scoreReferenceRun(SessionContext& session, std::size_t number, std::int64_t score_steps);

/// A recording that may become a reference run: complete, never one before, and nobody is asked to score it
/// (the panel's mark would give the case away).
struct ReferenceCandidate {
  TrialId trialId{};
  std::string traineeCode{};  ///< empty: nobody's
  SceneId sceneId{};
  std::string phaseLabel{};
  std::int64_t length_us = 0;
  std::int64_t startedUtc_us = 0;
  bool demonstration = false;
};
/// Newest first. kStudySetup.
[[nodiscard]] std::vector<ReferenceCandidate> referenceCandidates(SessionContext& session);

/// A reference run as the administrator sees it.
struct ReferenceRow {
  std::size_t number = 0;  ///< what raters call it: 1, 2 ...; 0: withdrawn
  TrialId trialId{};
  std::string traineeCode{};  ///< empty: nobody's
  SceneId sceneId{};
  std::optional<std::int64_t> length_us{};
  ScoreScale scale{};
  double panel_points = 0.0;
  std::int64_t panelRaters = 1;
  std::int64_t setUtc_us = 0;
  std::string withdrawnBecause{};  ///< empty: raters are given it
};
/// In the order of rater calibration, those that were withdrawn last. kStudySetup.
[[nodiscard]] std::vector<ReferenceRow> referenceRows(SessionContext& session);

/// A run for rater calibration, chosen by the administrator.
struct ReferenceChoice {
  TrialId trialId{};
  RubricRevisionId rubricRevisionId{};
  double panel_points = 0.0;
  std::int64_t panelRaters = 1;
  bool demonstration = false;
};
/// Adds reference runs behind those there are. kStudySetup; audited. Throws Error{kBadData}: no
/// such rubric, a recording that does not exist or has not ended, one that is or was a reference run;
/// {kBadParameter}: a mark outside the rubric's scale, or a panel of nobody.
void addReferenceRuns(SessionContext& session, const std::vector<ReferenceChoice>& runs);
/// From now on no rater is given the run; it stays stored with what raters scored, and later ones move up.
/// For good: what raters have seen cannot come back as new. kStudySetup; audited with the reason. Throws
/// Error{kBadData}: no such reference run; {kBadParameter}: no reason.
void withdrawReferenceRun(SessionContext& session, const TrialId& trialId, const std::string& reason);

}  // namespace torsio
