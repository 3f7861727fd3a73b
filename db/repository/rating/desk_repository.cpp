// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/repository/rating/desk_repository.h"

#include <utility>

#include "assessment/domain/ids.h"
#include "db/repository/base/row_columns.h"
#include "db/repository/rating/sheet_repository.h"

namespace torsio {

namespace {

constexpr auto kReferenceRun = rowColumns<ReferenceRun>(
    "reference_run",
    "trial_id, position, rubric_revision_id, panel_steps, panel_raters, set_by, set_utc_us, demonstration",
    &ReferenceRun::trialId, &ReferenceRun::position, &ReferenceRun::rubricRevisionId,
    &ReferenceRun::panel_steps, &ReferenceRun::panelRaters, &ReferenceRun::setBy, &ReferenceRun::setUtc_us,
    &ReferenceRun::demonstration);

}  // namespace

std::optional<Assignment> DeskRepository::assignment(const AssignmentId& assignmentId) const {
  return selectFirst(connection_, selectAssignments() + " WHERE a.id = ?", {assignmentId}, readAssignment);
}

bool DeskRepository::isWithdrawn(const AssignmentId& assignmentId) const {
  return selectFirst(connection_,
                     "SELECT count(*) FROM assignment a WHERE a.id = ? AND NOT " + isAskedFor("a"),
                     {assignmentId}, readInt64)
             .value_or(0) > 0;
}

std::vector<CaseMark> DeskRepository::marksOfCase(const EnrolmentId& enrolmentId,
                                                  const std::string& occasionCode) const {
  std::vector<CaseMark> marks = selectAll(
      connection_,
      "SELECT m.id, m.assignment_id, m.rater_id, m.version, m.score_steps, m.scale_lo_steps, "
      "m.scale_hi_steps,"
      " m.steps_per_point FROM training_mark m WHERE m.enrolment_id = ? AND m.occasion = ?"
      " AND m.version = (SELECT MAX(n.version) FROM training_mark n WHERE n.enrolment_id = m.enrolment_id"
      " AND n.rater_id = m.rater_id AND n.occasion = m.occasion) ORDER BY m.rater_id",
      {enrolmentId, occasionCode}, [](RowReader& row) {
        return CaseMark{row.text(),  row.text(),       row.text(),
                        row.int64(), row.maybeInt64(), {row.int64(), row.int64(), row.int64()},
                        {}};
      });
  for (CaseMark& mark : marks) {
    mark.rows = markRows(connection_, mark.markId);
  }
  return marks;
}

std::vector<Assignment> DeskRepository::committed(const RaterId& raterId) const {
  return selectAll(connection_,
                   selectAssignments() +
                       " WHERE a.rater_id = ?"
                       " AND EXISTS (SELECT 1 FROM training_mark m WHERE m.assignment_id = a.id)"
                       " AND " +
                       isAskedFor("a") +
                       " AND EXISTS (SELECT 1 FROM assignment b WHERE b.enrolment_id = a.enrolment_id"
                       "  AND b.occasion = a.occasion AND b.id <> a.id"
                       "  AND EXISTS (SELECT 1 FROM training_mark m WHERE m.assignment_id = b.id))"
                       " AND NOT EXISTS (SELECT 1 FROM assignment b WHERE b.enrolment_id = a.enrolment_id"
                       "  AND b.occasion = a.occasion"
                       "  AND NOT EXISTS (SELECT 1 FROM training_mark m WHERE m.assignment_id = b.id)"
                       "  AND " +
                       isAskedFor("b") + ") ORDER BY a.position, a.case_label",
                   {raterId}, readAssignment);
}

std::optional<std::int64_t> DeskRepository::trialLength_us(const TrialId& trialId) const {
  return selectFirst(
      connection_,
      "SELECT e.sample_count * t.tick_period_us FROM trial t JOIN trial_end e ON e.trial_id = t.id"
      " WHERE t.id = ?",
      {trialId}, readInt64);
}

std::optional<std::string> DeskRepository::contentHash(const TrialId& trialId) const {
  return selectFirst(connection_, "SELECT content_hash FROM trial_end WHERE trial_id = ?", {trialId},
                     readText);
}

void DeskRepository::saveDraftViewing(const AssignmentId& assignmentId, const SheetViewing& viewing) {
  connection_.execute(
      insertInto("draft_viewing", "assignment_id, watched, slowest_permille, fastest_permille, worked_us") +
          " ON CONFLICT (assignment_id) DO UPDATE SET watched = excluded.watched,"
          " slowest_permille = excluded.slowest_permille, fastest_permille ="
          " excluded.fastest_permille, worked_us = excluded.worked_us",
      {assignmentId, viewing.watched, viewing.slowest_permille, viewing.fastest_permille, viewing.worked_us});
}

std::optional<SheetViewing> DeskRepository::draftViewing(const AssignmentId& assignmentId) const {
  return selectFirst(connection_,
                     "SELECT watched, slowest_permille, fastest_permille, worked_us FROM draft_viewing"
                     " WHERE assignment_id = ?",
                     {assignmentId}, [](RowReader& row) {
                       return SheetViewing{row.text(), {}, row.int64(), row.int64(), row.int64()};
                     });
}

void DeskRepository::sealViewing(const AssignmentId& assignmentId, const MarkId& markId,
                                 const SheetViewing& viewing) {
  Transaction transaction(connection_);
  connection_.execute(
      insertInto("mark_viewing", "mark_id, watched_permille, slowest_permille, fastest_permille, worked_us"),
      {markId, viewing.watched_permille, viewing.slowest_permille, viewing.fastest_permille,
       viewing.worked_us});
  connection_.execute("DELETE FROM draft_viewing WHERE assignment_id = ?", {assignmentId});
  transaction.commit();
}

WatchAccount DeskRepository::watchAccount(const RaterId& raterId) const {
  return selectFirst(
             connection_,
             "SELECT recording, player, charged_utc_us, slack_us FROM watch_account WHERE rater_id = ?",
             {raterId},
             [](RowReader& row) {
               return WatchAccount{row.text(), row.text(), row.int64(), row.int64()};
             })
      .value_or(WatchAccount{});
}

void DeskRepository::saveWatchAccount(const RaterId& raterId, const WatchAccount& account) {
  connection_.execute(insertInto("watch_account", "rater_id, recording, player, charged_utc_us, slack_us") +
                          " ON CONFLICT (rater_id) DO UPDATE SET recording = excluded.recording, player ="
                          " excluded.player, charged_utc_us = excluded.charged_utc_us, slack_us ="
                          " excluded.slack_us",
                      {raterId, account.recording, account.player, account.charged_utc_us, account.slack_us});
}

std::vector<std::int64_t> DeskRepository::workingTimes_us(const RaterId& raterId, std::int64_t limit) const {
  return selectAll(
      connection_,
      "SELECT v.worked_us FROM training_mark m JOIN mark_viewing v ON v.mark_id = m.id"
      " WHERE m.rater_id = ? AND m.version = 1 AND v.worked_us > 0 ORDER BY m.submitted_utc_us DESC, m.id"
      " LIMIT ?",
      {raterId, limit}, readInt64);
}

std::vector<TrialId> DeskRepository::assignedTrials() const {
  return selectAll(connection_, "SELECT DISTINCT trial_id FROM assignment WHERE trial_id IS NOT NULL", {},
                   readId<TrialId>);
}

void DeskRepository::addReferenceRuns(std::span<const ReferenceRun> runs) {
  Transaction transaction(connection_);
  Statement insert = connection_.prepare(kReferenceRun.insert());
  for (const ReferenceRun& run : runs) {
    insert.execute(kReferenceRun.values(run));
  }
  transaction.commit();
}

std::vector<ReferenceRun> DeskRepository::referenceRuns() const {
  return referenceRunsWhere(
      " WHERE NOT EXISTS (SELECT 1 FROM reference_run_withdrawal w WHERE w.trial_id = r.trial_id)");
}

std::vector<ReferenceRun> DeskRepository::allReferenceRuns() const {
  return referenceRunsWhere("");
}

std::vector<ReferenceRun> DeskRepository::referenceRunsWhere(const char* condition) const {
  return selectAll(
      connection_,
      kReferenceRun.select("r") + " FROM reference_run r" + condition + " ORDER BY r.position, r.trial_id",
      {}, kReferenceRun);
}

void DeskRepository::withdrawReferenceRun(const ReferenceWithdrawal& withdrawal) {
  connection_.execute(
      insertInto("reference_run_withdrawal", "trial_id, reason, withdrawn_by, withdrawn_utc_us"),
      {withdrawal.trialId, withdrawal.reason, withdrawal.withdrawnBy, withdrawal.withdrawnUtc_us});
}

std::vector<ReferenceWithdrawal> DeskRepository::referenceWithdrawals() const {
  return selectAll(connection_,
                   "SELECT trial_id, reason, withdrawn_by, withdrawn_utc_us FROM reference_run_withdrawal"
                   " ORDER BY withdrawn_utc_us, trial_id",
                   {}, [](RowReader& row) {
                     return ReferenceWithdrawal{row.text(), row.text(), row.text(), row.int64()};
                   });
}

void DeskRepository::saveEvaluationDraft(const CampaignId& campaignId, const RaterId& raterId,
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
      insertInto("evaluation_draft",
                 "campaign_id, rater_id, model_code, index_number, score_steps, changed_utc_us") +
          " ON CONFLICT (campaign_id, rater_id, model_code, index_number) DO UPDATE SET"
          " score_steps = excluded.score_steps, changed_utc_us = excluded.changed_utc_us",
      {campaignId, raterId, modelCode, indexNumber, *score_steps, utc_us});
}

std::vector<EvaluationDraftMark> DeskRepository::evaluationDraft(const CampaignId& campaignId,
                                                                 const RaterId& raterId) const {
  return selectAll(connection_,
                   "SELECT model_code, index_number, score_steps FROM evaluation_draft WHERE campaign_id = ?"
                   " AND rater_id = ? ORDER BY model_code, index_number",
                   {campaignId, raterId}, [](RowReader& row) {
                     return EvaluationDraftMark{row.text(), row.int64(), row.int64()};
                   });
}

void DeskRepository::removeEvaluationDraft(const CampaignId& campaignId, const RaterId& raterId,
                                           const std::string& modelCode) {
  connection_.execute(
      "DELETE FROM evaluation_draft WHERE campaign_id = ? AND rater_id = ? AND model_code = ?",
      {campaignId, raterId, modelCode});
}

}  // namespace torsio
