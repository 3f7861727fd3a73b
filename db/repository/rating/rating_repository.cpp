// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/repository/rating/rating_repository.h"

#include <algorithm>
#include <string_view>
#include <tuple>
#include <unordered_map>
#include <utility>

#include "assessment/domain/ids.h"
#include "assessment/domain/people/audit_entry.h"
#include "db/repository/base/audit_repository.h"
#include "db/repository/base/row_columns.h"
#include "sim/core/error.h"

namespace torsio {

namespace {

constexpr auto kMark = rowColumns<SubmittedMark>(
    "training_mark",
    "id, enrolment_id, rater_id, occasion, version, trial_id, score_steps, scale_lo_steps, scale_hi_steps,"
    " steps_per_point, not_assessable_reason, comment, assignment_id, amend_reason, submitted_utc_us,"
    " demonstration, import_id",
    &SubmittedMark::id, &SubmittedMark::enrolmentId, &SubmittedMark::raterId, &SubmittedMark::occasionCode,
    &SubmittedMark::version, OrNull{&SubmittedMark::trialId}, &SubmittedMark::score_steps,
    &SubmittedMark::scale, OrNull{&SubmittedMark::notAssessableReason}, OrNull{&SubmittedMark::comment},
    OrNull{&SubmittedMark::assignmentId}, OrNull{&SubmittedMark::amendReason},
    &SubmittedMark::submittedUtc_us, &SubmittedMark::demonstration, OrNull{&SubmittedMark::importId});

SubmittedMark markWithCodes(RowReader& row) {
  SubmittedMark mark = kMark(row);
  mark.traineeCode = row.text();
  mark.raterCode = row.text();
  mark.groupCode = row.text();
  mark.numberInGroup = row.int64();
  return mark;
}

/// Adds people's codes to marks and orders these by occasion, group, number, trainee, rater. The lists are
/// short and read once: a join would look up each code for every mark.
class MarkedPeople {
 public:
  MarkedPeople(Connection& connection, const CohortId& cohortId)
      : raters_(byKey<std::string>(connection,
                                   "SELECT p.id, p.code FROM rater JOIN person p ON p.id = rater.person_id",
                                   {}, readText)),
        occasions_(byKey<std::int64_t>(connection, "SELECT code, position FROM occasion", {}, readInt64)),
        enrolled_(byKey<Enrolled>(
            connection,
            "SELECT e.id, p.code, g.code, COALESCE(g.number, 0), COALESCE(e.number_in_group, 0)"
            " FROM enrolment e JOIN person p ON p.id = e.trainee_id"
            " LEFT JOIN training_group g ON g.id = e.group_id WHERE e.cohort_id = ?",
            {cohortId}, [](RowReader& row) {
              return Enrolled{row.text(), row.text(), row.int64(), row.int64()};
            })) {}

  [[nodiscard]] std::vector<SubmittedMark> named(std::vector<SubmittedMark> marks) const {
    using Key = std::tuple<std::int64_t, std::int64_t, std::int64_t, std::string_view, std::string_view,
                           std::string_view>;
    std::vector<std::pair<Key, std::size_t>> order;
    order.reserve(marks.size());
    for (std::size_t i = 0; i < marks.size(); ++i) {
      SubmittedMark& mark = marks[i];
      const Enrolled& of = enrolled_.at(mark.enrolmentId);
      const std::string& rater = raters_.at(mark.raterId);
      mark.traineeCode = of.trainee;
      mark.raterCode = rater;
      mark.groupCode = of.group;
      mark.numberInGroup = of.number;
      order.emplace_back(
          Key(occasions_.at(mark.occasionCode), of.groupNumber, of.number, of.trainee, rater, mark.id.text()),
          i);
    }
    std::sort(order.begin(), order.end());
    std::vector<SubmittedMark> sorted;
    sorted.reserve(marks.size());
    for (const auto& [key, i] : order) {
      sorted.push_back(std::move(marks[i]));
    }
    return sorted;
  }

 private:
  struct Enrolled {
    std::string trainee{};
    std::string group{};
    std::int64_t groupNumber = 0;
    std::int64_t number = 0;
  };
  template <typename What>
  using ByKey = std::unordered_map<std::string, What>;

  template <typename What, typename Read>
  static ByKey<What> byKey(Connection& connection, const char* sql, std::initializer_list<Value> values,
                           Read read) {
    ByKey<What> all;
    for (auto& [key, what] : selectAll(connection, sql, values, [&read](RowReader& row) {
           std::string key = row.text();
           return std::pair<std::string, What>(std::move(key), read(row));
         })) {
      all.emplace(std::move(key), std::move(what));
    }
    return all;
  }

  ByKey<std::string> raters_;
  ByKey<std::int64_t> occasions_;
  ByKey<Enrolled> enrolled_;
};

MarkRow markRowOf(RowReader& row) {
  return {row.text(), row.text(), row.maybeInt64(), row.text()};
}

/// Throws if the rows of a stored mark differ.
void requireSameRows(Connection& connection, const SubmittedMark& mark) {
  const std::vector<MarkRow> stored =
      selectAll(connection,
                "SELECT revision_id, row_code, score_steps, not_assessable_reason FROM training_mark_row"
                " WHERE mark_id = ?",
                {mark.id}, markRowOf);
  if (!std::is_permutation(stored.begin(), stored.end(), mark.rows.begin(), mark.rows.end())) {
    refuseOtherContent(connection, "training_mark_row", Text::tr("this mark"));
  }
}

}  // namespace

void RatingRepository::submit(std::span<const SubmittedMark> marks) {
  Transaction transaction(connection_);
  Statement insertRow = connection_.prepare(
      insertInto("training_mark_row", "mark_id, revision_id, row_code, score_steps, not_assessable_reason"));
  std::vector<NewAuditEntry> entries;
  for (const SubmittedMark& mark : marks) {
    if (kMark.insertOnce(connection_, mark, "id", "submitted_utc_us", Text::tr("this mark")) ==
        Inserted::kThereAlready) {
      requireSameRows(connection_, mark);
      continue;
    }
    for (const MarkRow& row : mark.rows) {
      insertRow.execute(
          {mark.id, row.rubricRevisionId, row.rowCode, row.score_steps, textOrNull(row.notAssessableReason)});
    }
    entries.push_back({.atUtc_us = mark.submittedUtc_us,
                       .actor = mark.raterId,
                       .station = station_,
                       .action = mark.version == 1 ? AuditAction::kMarkSubmit : AuditAction::kMarkAmend,
                       .objectKind = AuditObject::kTrainingMark,
                       .objectId = mark.id,
                       .reason = mark.amendReason});
  }
  AuditRepository(connection_).append(entries);
  transaction.commit();
}

std::vector<SubmittedMark> RatingRepository::marks(const CohortId& cohortId) const {
  Transaction oneMoment(connection_, Transaction::Purpose::kReadOnly);
  std::vector<SubmittedMark> marks =
      selectAll(connection_,
                kMark.select("m") +
                    " FROM training_mark m JOIN enrolment e ON e.id = m.enrolment_id"
                    " WHERE e.cohort_id = ? AND NOT EXISTS (SELECT 1 FROM training_mark n"
                    "  WHERE n.enrolment_id = m.enrolment_id AND n.rater_id = m.rater_id"
                    "  AND n.occasion = m.occasion AND n.version > m.version)",
                {cohortId}, kMark);
  marks = MarkedPeople(connection_, cohortId).named(std::move(marks));
  oneMoment.commit();
  return marks;
}

std::map<MarkId, std::vector<MarkRow>> RatingRepository::criteria(const CohortId& cohortId) const {
  using Answer = std::pair<MarkId, MarkRow>;
  std::map<MarkId, std::vector<MarkRow>> rows;
  for (Answer& answer :
       selectAll(connection_,
                 "SELECT r.mark_id, r.revision_id, r.row_code, r.score_steps, r.not_assessable_reason"
                 " FROM training_mark_row r JOIN training_mark m ON m.id = r.mark_id"
                 " JOIN enrolment e ON e.id = m.enrolment_id WHERE e.cohort_id = ?",
                 {cohortId}, [](RowReader& row) {
                   return Answer{row.text(), markRowOf(row)};
                 })) {
    rows[answer.first].push_back(std::move(answer.second));
  }
  return rows;
}

std::vector<SubmittedMark> RatingRepository::history(const EnrolmentId& enrolmentId, const RaterId& raterId,
                                                     const std::string& occasionCode) const {
  return selectAll(connection_,
                   kMark.select("m") +
                       ", t.code, r.code, g.code, e.number_in_group"
                       " FROM training_mark m JOIN enrolment e ON e.id = m.enrolment_id"
                       " JOIN person t ON t.id = e.trainee_id JOIN person r ON r.id = m.rater_id"
                       " LEFT JOIN training_group g ON g.id = e.group_id"
                       " WHERE m.enrolment_id = ? AND m.rater_id = ? AND m.occasion = ? ORDER BY m.version",
                   {enrolmentId, raterId, occasionCode}, markWithCodes);
}

void RatingRepository::storeRun(const CohortId& cohortId, const TrainingRunRows& run) {
  Transaction transaction(connection_);
  insertRun(connection_, RunOwner::kCohort, cohortId, run.run);
  Statement trainee = connection_.prepare(
      insertInto("training_result",
                 "run_id, enrolment_id, occasion, mean, variance, rater_count, missing_count, flags"));
  for (const TrainingResultRow& result : run.trainees) {
    trainee.execute({run.run.id, result.enrolmentId, result.occasionCode, result.mean, result.variance,
                     result.raterCount, result.missingCount, joinFlags(result.flags)});
  }
  Statement group = connection_.prepare(
      insertInto("training_group_result",
                 "run_id, group_id, occasion, trainee_count, mean, variance_n, variance_n_minus_1,"
                 " flags"));
  for (const GroupResultRow& result : run.groups) {
    group.execute({run.run.id, result.groupId, result.occasionCode, result.traineeCount, result.mean,
                   result.varianceN, result.varianceNMinus1, joinFlags(result.flags)});
  }
  transaction.commit();
}

namespace {

const std::string kDecisions =
    "SELECT d.assignment_id, d.sequence, d.decision, d.reason, d.decided_by, d.decided_utc_us"
    " FROM alignment_decision d";

DiscrepancyDecision decisionOf(RowReader& row) {
  return {.assignmentId = row.text(),
          .sequence = row.int64(),
          .choice = readTerm<DiscrepancyChoice>(row),
          .reason = row.text(),
          .decidedBy = row.text(),
          .decidedUtc_us = row.int64()};
}

AuditAction actionOf(DiscrepancyChoice choice) {
  switch (choice) {
    case DiscrepancyChoice::kKeep:
      return AuditAction::kDiscrepancyKeep;
    case DiscrepancyChoice::kMove:
      return AuditAction::kDiscrepancyMove;
    case DiscrepancyChoice::kThird:
      return AuditAction::kDiscrepancyAdjudicator;
  }
  throw ContractError("no such decision");
}

}  // namespace

std::int64_t DiscrepancyRepository::add(const DiscrepancyDecision& decision) {
  Transaction transaction(connection_);
  const std::optional<DiscrepancyDecision> before = latest(decision.assignmentId);
  const std::int64_t sequence = before ? before->sequence + 1 : 1;
  connection_.execute(insertInto("alignment_decision",
                                 "assignment_id, sequence, decision, reason, decided_by, decided_utc_us"),
                      {decision.assignmentId, sequence, storedText(decision.choice), decision.reason,
                       decision.decidedBy, decision.decidedUtc_us});
  NewAuditEntry entry{.atUtc_us = decision.decidedUtc_us,
                      .actor = decision.decidedBy,
                      .station = station_,
                      .action = actionOf(decision.choice),
                      .objectKind = AuditObject::kAssignment,
                      .objectId = decision.assignmentId,
                      .reason = decision.reason};
  AuditRepository(connection_).append(entry);
  transaction.commit();
  return sequence;
}

std::vector<DiscrepancyDecision> DiscrepancyRepository::history(const AssignmentId& assignmentId) const {
  return selectAll(connection_, kDecisions + " WHERE d.assignment_id = ? ORDER BY d.sequence", {assignmentId},
                   decisionOf);
}

std::optional<DiscrepancyDecision> DiscrepancyRepository::latest(const AssignmentId& assignmentId) const {
  const std::vector<DiscrepancyDecision> all = history(assignmentId);
  return all.empty() ? std::nullopt : std::optional(all.back());
}

bool DiscrepancyRepository::decidedBy(const EnrolmentId& enrolmentId, const std::string& occasionCode,
                                      const RaterId& raterId) const {
  return selectFirst(connection_,
                     "SELECT count(*) FROM alignment_decision d JOIN assignment a ON a.id = d.assignment_id"
                     " WHERE a.enrolment_id = ? AND a.occasion = ? AND a.rater_id = ?",
                     {enrolmentId, occasionCode, raterId}, readInt64)
             .value_or(0) > 0;
}

std::vector<DiscrepancyDecision> DiscrepancyRepository::ofCohort(const CohortId& cohortId) const {
  return selectAll(
      connection_,
      kDecisions +
          " JOIN assignment a ON a.id = d.assignment_id JOIN enrolment e ON e.id = a.enrolment_id"
          " WHERE e.cohort_id = ?"
          " AND NOT EXISTS (SELECT 1 FROM alignment_decision n WHERE n.assignment_id = d.assignment_id"
          " AND n.sequence > d.sequence) ORDER BY d.decided_utc_us, d.assignment_id",
      {cohortId}, decisionOf);
}

}  // namespace torsio
