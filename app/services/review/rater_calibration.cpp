// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/review/rater_calibration.h"

#include <algorithm>
#include <map>
#include <set>

#include <nlohmann/json.hpp>

#include "assessment/attempt/trial_listing.h"
#include "assessment/domain/ids.h"
#include "assessment/domain/rating/mark.h"
#include "assessment/statistics/descriptive.h"
#include "db/connection/connection.h"
#include "db/repository/base/id_source.h"
#include "db/repository/rating/desk_repository.h"
#include "db/repository/rating/rubric_repository.h"
#include "db/repository/trial/remark_repository.h"
#include "db/repository/trial/trial_repository.h"
#include "sim/core/error.h"
#include "sim/core/foreign_recording.h"

namespace torsio {

namespace {

constexpr std::int64_t kMaxListed = 2000;  // a longer list is useless for choosing

std::string labelOf(std::size_t number) {
  std::string label = "R";
  label += std::to_string(number);
  return label;
}

ReferenceRun runNumber(Connection& connection, std::size_t number) {
  const std::vector<ReferenceRun> runs = DeskRepository(connection).referenceRuns();
  if (number < 1 || number > runs.size()) {
    refuse(Text::tr("there is no such reference run"), Text::tr("reference %1", number),
           Text::tr("Open rater calibration again"));
  }
  return runs[number - 1];
}

/// Returns the scale of the panel's mark. Throws unless the recording can be a reference run.
ScoreScale checkedScale(Connection& connection, const ReferenceChoice& choice) {
  const auto rubric = RubricRepository(connection).revision(choice.rubricRevisionId);
  if (!rubric) {
    refuse(Text::tr("there is no such rubric"), choice.rubricRevisionId,
           Text::tr("Choose one from the list"));
  }
  DeskRepository desk(connection);
  if (!desk.trialLength_us(choice.trialId)) {
    refuse(Text::tr("there is no such complete recording"), choice.trialId,
           Text::tr("Choose one from the list"));
  }
  for (const ReferenceRun& run : desk.allReferenceRuns()) {
    if (run.trialId != choice.trialId) {
      continue;
    }
    refuse(Text::tr("this recording is or was a reference run"), choice.trialId,
           Text::tr("Choose another recording"));
  }
  const ScoreScale scale = rubric->overall;
  const double lowest = pointsFromSteps(scale.lo, scale);
  const double highest = pointsFromSteps(scale.hi, scale);
  if (!(choice.panel_points >= lowest && choice.panel_points <= highest)) {
    refuseParameter(Text::tr("the panel's mark is outside the scale of the rubric"),
                    std::to_string(choice.panel_points), Text::tr("Correct the mark"));
  }
  if (choice.panelRaters < 1) {
    refuseParameter(Text::tr("a panel has at least one member"), std::to_string(choice.panelRaters),
                    Text::tr("Correct the number"));
  }
  return scale;
}

}  // namespace

bool RaterCalibration::complete() const noexcept {
  return std::all_of(runs.begin(), runs.end(),
                     [](const CalibrationRun& run) { return run.own_steps.has_value(); });
}

std::optional<double> RaterCalibration::meanOffset_points() const {
  std::vector<double> offsets;
  for (const CalibrationRun& run : runs) {
    if (run.offset_points) {
      offsets.push_back(*run.offset_points);
    }
  }
  return offsets.empty() ? std::nullopt : std::optional(meanOf(offsets));
}

RaterCalibration raterCalibration(SessionContext& session) {
  session.require(Operation::kMarkSubmit);
  DeskRepository desk(session.connection());
  const RubricRepository rubrics(session.connection());
  const std::vector<CalibrationScore> tries =
      RemarkRepository(session.connection()).calibrationScores(session.actor().personId);
  RaterCalibration out;
  for (const ReferenceRun& run : desk.referenceRuns()) {
    const RubricRevision rubric = rubrics.revision(run.rubricRevisionId).value();
    if (out.runs.empty()) {
      out.rubric = rubric;
    }
    CalibrationRun shown;
    shown.number = out.runs.size() + 1;
    shown.length_us = desk.trialLength_us(run.trialId);
    for (const CalibrationScore& one : tries) {
      if (one.referenceTrialId != run.trialId) {
        continue;
      }
      ++shown.tries;
      shown.own_steps = one.score_steps;
      shown.panelRaters = run.panelRaters;
      shown.panel_points = run.panel_steps / static_cast<double>(rubric.overall.stepsPerPoint);
      shown.offset_points = one.panelOffset_steps / static_cast<double>(one.scale.stepsPerPoint);
    }
    out.runs.push_back(shown);
  }
  return out;
}

BlindedRecording loadReferenceRun(SessionContext& session, std::size_t number) {
  session.require(Operation::kTrialViewAssigned);
  const ReferenceRun run = runNumber(session.connection(), number);
  return blindedRecordingOf(session.connection(), run.trialId, labelOf(number), session.actor().personId);
}

void scoreReferenceRun(SessionContext& session, std::size_t number, std::int64_t score_steps) {
  session.require(Operation::kMarkSubmit);
  const ReferenceRun run = runNumber(session.connection(), number);
  const RubricRevision rubric = RubricRepository(session.connection()).revision(run.rubricRevisionId).value();
  if (!isOnScale(score_steps, rubric.overall)) {
    refuse(Text::tr("the mark is outside the scale"), Text::tr("reference %1", number),
           Text::tr("Correct the mark"));
  }
  CalibrationScore score;
  score.id = session.ids().newUuid();
  score.raterId = session.actor().personId;
  score.referenceTrialId = run.trialId;
  score.rubricRevisionId = run.rubricRevisionId;
  score.score_steps = score_steps;
  score.scale = rubric.overall;
  score.panelOffset_steps = static_cast<double>(score_steps) - run.panel_steps;
  score.createdUtc_us = session.now_us();
  score.demonstration = run.demonstration;
  Transaction transaction(session.connection());
  RemarkRepository(session.connection()).addCalibrationScore(score);
  session.note(AuditAction::kCalibrationScore, AuditObject::kRaterCalibration, score.id);
  transaction.commit();
}

std::vector<ReferenceCandidate> referenceCandidates(SessionContext& session) {
  session.require(Operation::kStudySetup);
  DeskRepository desk(session.connection());
  std::set<TrialId> decided;
  for (const TrialId& trialId : desk.assignedTrials()) {
    decided.insert(trialId);
  }
  for (const ReferenceRun& run : desk.allReferenceRuns()) {
    decided.insert(run.trialId);
  }
  std::vector<ReferenceCandidate> candidates;
  for (const TrialListing& trial : TrialRepository(session.connection()).list({.limit = kMaxListed})) {
    const bool complete = trial.summary && trial.summary->outcome == TrialOutcome::kCompleted;
    if (!complete || isForeign(trial.sceneId) || decided.contains(trial.trialId)) {
      continue;
    }
    candidates.push_back({trial.trialId, trial.traineeCode, trial.sceneId, trial.phaseLabel,
                          desk.trialLength_us(trial.trialId).value_or(0), trial.startedUtc_us,
                          trial.demonstration});
  }
  return candidates;
}

std::vector<ReferenceRow> referenceRows(SessionContext& session) {
  session.require(Operation::kStudySetup);
  DeskRepository desk(session.connection());
  const RubricRepository rubrics(session.connection());
  TrialRepository trials(session.connection());
  std::map<std::string, std::string> reasons;
  for (const ReferenceWithdrawal& withdrawal : desk.referenceWithdrawals()) {
    reasons.emplace(withdrawal.trialId, withdrawal.reason);
  }
  std::vector<ReferenceRow> rows;
  std::vector<ReferenceRow> withdrawn;
  for (const ReferenceRun& run : desk.allReferenceRuns()) {
    const TrialHeader header = trials.find(run.trialId).value();
    const ScoreScale scale = rubrics.revision(run.rubricRevisionId).value().overall;
    const auto reason = reasons.find(run.trialId);
    const bool given = reason == reasons.end();
    (given ? rows : withdrawn)
        .push_back({given ? rows.size() + 1 : 0, run.trialId, header.traineeCode, header.sceneId,
                    desk.trialLength_us(run.trialId), scale,
                    run.panel_steps / static_cast<double>(scale.stepsPerPoint), run.panelRaters,
                    run.setUtc_us, given ? std::string() : reason->second});
  }
  rows.insert(rows.end(), withdrawn.begin(), withdrawn.end());
  return rows;
}

void addReferenceRuns(SessionContext& session, const std::vector<ReferenceChoice>& runs) {
  session.require(Operation::kStudySetup);
  DeskRepository desk(session.connection());
  auto position = static_cast<std::int64_t>(desk.allReferenceRuns().size());
  Transaction transaction(session.connection());
  for (const ReferenceChoice& choice : runs) {
    const ScoreScale scale = checkedScale(session.connection(), choice);
    ReferenceRun run;
    run.trialId = choice.trialId;
    run.position = ++position;
    run.rubricRevisionId = choice.rubricRevisionId;
    run.panel_steps = choice.panel_points * static_cast<double>(scale.stepsPerPoint);
    run.panelRaters = choice.panelRaters;
    run.setBy = session.actor().userId;
    run.setUtc_us = session.now_us();
    // A simulated recording must be removed with the demonstration.
    run.demonstration =
        choice.demonstration || TrialRepository(session.connection()).find(choice.trialId)->demonstration;
    desk.addReferenceRuns(std::span(&run, 1));
    session.note(AuditAction::kReferenceRunAdd, AuditObject::kReferenceRun, run.trialId);
  }
  transaction.commit();
}

void withdrawReferenceRun(SessionContext& session, const TrialId& trialId, const std::string& reason) {
  session.require(Operation::kStudySetup);
  if (reason.empty()) {
    refuseParameter(Text::tr("a withdrawal needs a reason"), trialId, Text::tr("Say why, in a few words"));
  }
  Transaction transaction(session.connection());
  DeskRepository desk(session.connection());
  const std::vector<ReferenceRun> runs = desk.referenceRuns();
  if (std::none_of(runs.begin(), runs.end(),
                   [&](const ReferenceRun& run) { return run.trialId == trialId; })) {
    refuse(Text::tr("this recording is not a reference run, or was already withdrawn"), trialId,
           Text::tr("Open the list again"));
  }
  desk.withdrawReferenceRun({trialId, reason, session.actor().userId, session.now_us()});
  session.note(AuditAction::kReferenceRunWithdraw, AuditObject::kReferenceRun, trialId, {}, reason);
  transaction.commit();
}

}  // namespace torsio
