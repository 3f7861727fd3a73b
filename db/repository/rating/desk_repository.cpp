// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/repository/rating/desk_repository.h"

#include <utility>

namespace torsio {

namespace {

constexpr const char* kAssignmentColumns =
    "SELECT a.id, a.rater_id, a.enrolment_id, a.scoring_point, a.trial_id, a.rubric_revision_id, "
    "a.case_label,"
    " a.position, a.due_utc_us, a.assigned_by, a.assigned_utc_us, a.demonstration FROM assignment a";

StoredAssignment assignmentIn(const Statement& row) {
  return {.id = row.text(0),
          .raterId = row.text(1),
          .enrolmentId = row.text(2),
          .scoringPoint = row.text(3),
          .trialId = row.text(4),
          .rubricRevisionId = row.text(5),
          .caseLabel = row.text(6),
          .position = row.int64(7),
          .dueUtc_us = row.maybeInt64(8),
          .assignedBy = row.text(9),
          .assignedUtc_us = row.int64(10),
          .demonstration = row.boolean(11)};
}

}  // namespace

std::optional<StoredAssignment> DeskRepository::assignment(const std::string& assignmentId) {
  Statement row = connection_.prepare(std::string(kAssignmentColumns) + " WHERE a.id = ?");
  row.execute({assignmentId});
  if (!row.step()) return std::nullopt;
  return assignmentIn(row);
}

bool DeskRepository::isWithdrawn(const std::string& assignmentId) {
  Statement row = connection_.prepare("SELECT count(*) FROM assignment_withdrawal WHERE assignment_id = ?");
  row.execute({assignmentId});
  return row.step() && row.int64(0) > 0;
}

std::vector<CaseMark> DeskRepository::marksOfCase(const std::string& enrolmentId,
                                                  const std::string& scoringPoint) {
  Statement row = connection_.prepare(
      "SELECT m.id, m.assignment_id, m.rater_id, m.version, m.score_steps, m.scale_lo_steps, "
      "m.scale_hi_steps,"
      " m.steps_per_point FROM training_mark m WHERE m.enrolment_id = ? AND m.scoring_point = ?"
      " AND m.version = (SELECT MAX(n.version) FROM training_mark n WHERE n.enrolment_id = m.enrolment_id"
      " AND n.rater_id = m.rater_id AND n.scoring_point = m.scoring_point) ORDER BY m.rater_id");
  std::vector<CaseMark> marks;
  row.execute({enrolmentId, scoringPoint});
  while (row.step()) {
    marks.push_back({row.text(0),
                     row.text(1),
                     row.text(2),
                     row.int64(3),
                     row.maybeInt64(4),
                     {row.int64(5), row.int64(6), row.int64(7)},
                     {}});
  }
  Statement line = connection_.prepare(
      "SELECT row_code, score_steps, not_assessable_reason FROM training_mark_row WHERE mark_id = ?"
      " ORDER BY row_code");
  for (CaseMark& mark : marks) {
    line.execute({mark.markId});
    while (line.step()) mark.rows.push_back({line.text(0), line.maybeInt64(1), line.text(2)});
  }
  return marks;
}

std::vector<StoredAssignment> DeskRepository::committed(const std::string& raterId) {
  Statement row = connection_.prepare(
      std::string(kAssignmentColumns) +
      " WHERE a.rater_id = ?"
      " AND EXISTS (SELECT 1 FROM training_mark m WHERE m.assignment_id = a.id)"
      " AND NOT EXISTS (SELECT 1 FROM assignment_withdrawal w WHERE w.assignment_id = a.id)"
      " AND EXISTS (SELECT 1 FROM assignment b WHERE b.enrolment_id = a.enrolment_id"
      "  AND b.scoring_point = a.scoring_point AND b.id <> a.id"
      "  AND EXISTS (SELECT 1 FROM training_mark m WHERE m.assignment_id = b.id))"
      " AND NOT EXISTS (SELECT 1 FROM assignment b WHERE b.enrolment_id = a.enrolment_id"
      "  AND b.scoring_point = a.scoring_point"
      "  AND NOT EXISTS (SELECT 1 FROM training_mark m WHERE m.assignment_id = b.id)"
      "  AND NOT EXISTS (SELECT 1 FROM assignment_withdrawal w WHERE w.assignment_id = b.id))"
      " ORDER BY a.position, a.case_label");
  std::vector<StoredAssignment> found;
  row.execute({raterId});
  while (row.step()) found.push_back(assignmentIn(row));
  return found;
}

std::optional<std::int64_t> DeskRepository::trialLength_us(const std::string& trialId) {
  Statement row = connection_.prepare(
      "SELECT e.sample_count * t.tick_period_us FROM trial t JOIN trial_end e ON e.trial_id = t.id"
      " WHERE t.id = ?");
  row.execute({trialId});
  if (!row.step()) return std::nullopt;
  return row.int64(0);
}

std::string DeskRepository::newestMark(const std::string& assignmentId) {
  Statement row = connection_.prepare(
      "SELECT id FROM training_mark WHERE assignment_id = ? ORDER BY version DESC LIMIT 1");
  row.execute({assignmentId});
  return row.step() ? row.text(0) : std::string();
}

void DeskRepository::saveDraftViewing(const std::string& assignmentId, const StoredViewing& viewing) {
  connection_.execute(
      "INSERT INTO draft_viewing (assignment_id, watched, slowest_permille, fastest_permille, worked_us)"
      " VALUES (?, ?, ?, ?, ?) ON CONFLICT (assignment_id) DO UPDATE SET watched = excluded.watched,"
      " slowest_permille = excluded.slowest_permille, fastest_permille = excluded.fastest_permille,"
      " worked_us = excluded.worked_us",
      {assignmentId, viewing.watched, viewing.slowest_permille, viewing.fastest_permille, viewing.worked_us});
}

std::optional<StoredViewing> DeskRepository::draftViewing(const std::string& assignmentId) {
  Statement row = connection_.prepare(
      "SELECT watched, slowest_permille, fastest_permille, worked_us FROM draft_viewing"
      " WHERE assignment_id = ?");
  row.execute({assignmentId});
  if (!row.step()) return std::nullopt;
  return StoredViewing{row.text(0), {}, row.int64(1), row.int64(2), row.int64(3)};
}

void DeskRepository::sealViewing(const std::string& assignmentId, const std::string& markId,
                                 const StoredViewing& viewing) {
  Transaction transaction(connection_);
  connection_.execute(
      "INSERT INTO mark_viewing (mark_id, watched_permille, slowest_permille, fastest_permille, worked_us)"
      " VALUES (?, ?, ?, ?, ?)",
      {markId, viewing.watched_permille, viewing.slowest_permille, viewing.fastest_permille,
       viewing.worked_us});
  connection_.execute("DELETE FROM draft_viewing WHERE assignment_id = ?", {assignmentId});
  transaction.commit();
}

std::optional<StoredViewing> DeskRepository::viewing(const std::string& markId) {
  Statement row = connection_.prepare(
      "SELECT watched_permille, slowest_permille, fastest_permille, worked_us FROM mark_viewing"
      " WHERE mark_id = ?");
  row.execute({markId});
  if (!row.step()) return std::nullopt;
  return StoredViewing{{}, row.maybeInt64(0), row.int64(1), row.int64(2), row.int64(3)};
}

std::vector<std::int64_t> DeskRepository::workingTimes_us(const std::string& raterId, std::int64_t limit) {
  Statement row = connection_.prepare(
      "SELECT v.worked_us FROM training_mark m JOIN mark_viewing v ON v.mark_id = m.id"
      " WHERE m.rater_id = ? AND m.version = 1 AND v.worked_us > 0 ORDER BY m.submitted_utc_us DESC, m.id"
      " LIMIT ?");
  std::vector<std::int64_t> times_us;
  row.execute({raterId, limit});
  while (row.step()) times_us.push_back(row.int64(0));
  return times_us;
}

std::vector<std::string> DeskRepository::assignedTrials() {
  Statement row = connection_.prepare("SELECT DISTINCT trial_id FROM assignment WHERE trial_id IS NOT NULL");
  std::vector<std::string> ids;
  row.execute();
  while (row.step()) ids.push_back(row.text(0));
  return ids;
}

void DeskRepository::addReferenceRuns(std::span<const StoredReferenceRun> runs) {
  Transaction transaction(connection_);
  Statement insert = connection_.prepare(
      "INSERT INTO reference_run (trial_id, position, rubric_revision_id, panel_steps, panel_raters, set_by,"
      " set_utc_us, demonstration) VALUES (?, ?, ?, ?, ?, ?, ?, ?)");
  for (const StoredReferenceRun& run : runs) {
    insert.execute({run.trialId, run.position, run.rubricRevisionId, run.panel_steps, run.panelRaters,
                    run.setBy, run.setUtc_us, run.demonstration});
  }
  transaction.commit();
}

std::vector<StoredReferenceRun> DeskRepository::referenceRuns() {
  return referenceRunsWhere(
      " WHERE NOT EXISTS (SELECT 1 FROM reference_run_withdrawal w WHERE w.trial_id = r.trial_id)");
}

std::vector<StoredReferenceRun> DeskRepository::allReferenceRuns() {
  return referenceRunsWhere("");
}

std::vector<StoredReferenceRun> DeskRepository::referenceRunsWhere(const char* condition) {
  Statement row = connection_.prepare(
      std::string(
          "SELECT r.trial_id, r.position, r.rubric_revision_id, r.panel_steps, r.panel_raters, r.set_by,"
          " r.set_utc_us, r.demonstration FROM reference_run r") +
      condition + " ORDER BY r.position, r.trial_id");
  std::vector<StoredReferenceRun> runs;
  row.execute();
  while (row.step()) {
    runs.push_back({row.text(0), row.int64(1), row.text(2), row.real(3), row.int64(4), row.text(5),
                    row.int64(6), row.boolean(7)});
  }
  return runs;
}

void DeskRepository::withdrawReferenceRun(const StoredReferenceWithdrawal& withdrawal) {
  connection_.execute(
      "INSERT INTO reference_run_withdrawal (trial_id, reason, withdrawn_by, withdrawn_utc_us)"
      " VALUES (?, ?, ?, ?)",
      {withdrawal.trialId, withdrawal.reason, withdrawal.withdrawnBy, withdrawal.withdrawnUtc_us});
}

std::vector<StoredReferenceWithdrawal> DeskRepository::referenceWithdrawals() {
  Statement row = connection_.prepare(
      "SELECT trial_id, reason, withdrawn_by, withdrawn_utc_us FROM reference_run_withdrawal"
      " ORDER BY withdrawn_utc_us, trial_id");
  std::vector<StoredReferenceWithdrawal> withdrawals;
  row.execute();
  while (row.step()) withdrawals.push_back({row.text(0), row.text(1), row.text(2), row.int64(3)});
  return withdrawals;
}

void DeskRepository::saveEvaluationDraft(const std::string& campaignId, const std::string& raterId,
                                         const std::string& modelCode, std::int64_t indexNumber,
                                         std::optional<std::int64_t> score_steps, std::int64_t utc_us) {
  if (!score_steps) {
    connection_.execute(
        "DELETE FROM evaluation_draft WHERE campaign_id = ? AND rater_id = ? AND model_code = ?"
        " AND index_number = ?",
        {campaignId, raterId, modelCode, indexNumber});
    return;
  }
  connection_.execute(
      "INSERT INTO evaluation_draft (campaign_id, rater_id, model_code, index_number, score_steps,"
      " changed_utc_us) VALUES (?, ?, ?, ?, ?, ?)"
      " ON CONFLICT (campaign_id, rater_id, model_code, index_number) DO UPDATE SET"
      " score_steps = excluded.score_steps, changed_utc_us = excluded.changed_utc_us",
      {campaignId, raterId, modelCode, indexNumber, *score_steps, utc_us});
}

std::vector<EvaluationDraftMark> DeskRepository::evaluationDraft(const std::string& campaignId,
                                                                 const std::string& raterId) {
  Statement row = connection_.prepare(
      "SELECT model_code, index_number, score_steps FROM evaluation_draft WHERE campaign_id = ?"
      " AND rater_id = ? ORDER BY model_code, index_number");
  std::vector<EvaluationDraftMark> marks;
  row.execute({campaignId, raterId});
  while (row.step()) marks.push_back({row.text(0), row.int64(1), row.int64(2)});
  return marks;
}

void DeskRepository::removeEvaluationDraft(const std::string& campaignId, const std::string& raterId,
                                           const std::string& modelCode) {
  connection_.execute(
      "DELETE FROM evaluation_draft WHERE campaign_id = ? AND rater_id = ? AND model_code = ?",
      {campaignId, raterId, modelCode});
}

}  // namespace torsio
