// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/repository/people/person_data.h"

#include <algorithm>
#include <array>

#include "db/connection/row_reader.h"
#include "db/repository/base/audit_repository.h"
#include "sim/base/error.h"

namespace torsio {

namespace {

constexpr std::string_view kAsTrainee = "enrolment_id IN (SELECT id FROM enrolment WHERE trainee_id = ?)";
constexpr std::string_view kOwnTrials = "trial_id IN (SELECT id FROM trial WHERE trainee_id = ?)";
constexpr std::string_view kMarks =
    "(enrolment_id IN (SELECT id FROM enrolment WHERE trainee_id = ?) OR rater_id = ?)";
constexpr std::string_view kMarkRows =
    "mark_id IN (SELECT id FROM training_mark WHERE rater_id = ? OR enrolment_id IN"
    " (SELECT id FROM enrolment WHERE trainee_id = ?))";
constexpr std::string_view kDrafts =
    "assignment_id IN (SELECT id FROM assignment WHERE rater_id = ? OR enrolment_id IN"
    " (SELECT id FROM enrolment WHERE trainee_id = ?))";
constexpr std::string_view kRemarks =
    "(author_person_id = ? OR author IN (SELECT id FROM app_user WHERE person_id = ?)"
    " OR trial_id IN (SELECT id FROM trial WHERE trainee_id = ?))";
constexpr std::string_view kReceipts =
    "(reader_person_id = ? OR reader IN (SELECT id FROM app_user WHERE person_id = ?))";
constexpr std::string_view kQuestions =
    "(rater_id = ? OR remark_id IN (SELECT id FROM trial_remark WHERE author_person_id = ?))";
constexpr std::string_view kOwnScores = "self_score_id IN (SELECT id FROM self_score WHERE trainee_id = ?)";
constexpr std::string_view kOwnUser = "user_id IN (SELECT id FROM app_user WHERE person_id = ?)";

constexpr std::array kRules{
    PersonRule{"person_identity", "person_id = ?", OnErase::kDelete},
    PersonRule{"person", "id = ?", OnErase::kClear,
               "sex = NULL, level = NULL, experience = NULL, age_years = NULL, state = 'erased'"},
    PersonRule{"trainee", "person_id = ?", OnErase::kClear, "handedness = NULL"},
    PersonRule{"rater", "person_id = ?"},
    PersonRule{"station_state", kOwnUser, OnErase::kClear, "user_id = NULL"},
    PersonRule{"remark_receipt", kReceipts},
    PersonRule{"trial_question", kQuestions},
    PersonRule{"trial_remark", kRemarks, OnErase::kClear, "text = NULL"},
    PersonRule{"user_role", kOwnUser, OnErase::kDelete},
    PersonRule{"audit_entry",
               "(actor = ? OR object_id = ? OR actor IN (SELECT id FROM app_user WHERE person_id = ?))"},
    PersonRule{"app_user", "person_id = ?", OnErase::kDelete, "",
               "id, login, person_id, must_change_password, state, created_utc_us, demonstration"},
    PersonRule{"consent", "person_id = ?"},
    PersonRule{"enrolment", "trainee_id = ?"},
    PersonRule{"allocation", kAsTrainee},
    PersonRule{"trial", "trainee_id = ?"},
    PersonRule{"trial_chunk", kOwnTrials, OnErase::kDelete, "",
               "trial_id, chunk_index, first_tick, sample_count, digest, output_digest, stored_utc_us"},
    PersonRule{"trial_end", kOwnTrials},
    PersonRule{"trial_digest", kOwnTrials},
    PersonRule{"draft_viewing", kDrafts, OnErase::kDelete},
    PersonRule{"mark_draft_row", kDrafts, OnErase::kDelete},
    PersonRule{"mark_draft", kDrafts, OnErase::kDelete},
    PersonRule{"assignment", kMarks},
    PersonRule{"assignment_withdrawal", kDrafts},
    PersonRule{"training_mark", kMarks, OnErase::kClear, "comment = NULL"},
    PersonRule{"training_mark_row", kMarkRows},
    PersonRule{"mark_viewing", kMarkRows},
    PersonRule{"evaluation_rater", "rater_id = ?"},
    PersonRule{"evaluation_mark", "rater_id = ?"},
    PersonRule{"evaluation_draft", "rater_id = ?", OnErase::kDelete},
    PersonRule{"training_result", kAsTrainee},
    PersonRule{"alignment_decision", kDrafts},
    PersonRule{"self_score", "trainee_id = ?"},
    PersonRule{"self_score_row", kOwnScores},
    PersonRule{"rater_warmup", "rater_id = ?"},
    PersonRule{"retention_hold", "person_id = ?"},
    PersonRule{"exposure", kAsTrainee},
    PersonRule{"deviation", kAsTrainee, OnErase::kClear, "description = NULL"},
    PersonRule{"erasure", "person_id = ?"},
    // Nobody's data: what the centre plans, names and computes over many.
    PersonRule{"allocation_design", ""},
    PersonRule{"allocation_seed", ""},
    PersonRule{"assessment_run", ""},
    PersonRule{"centre", ""},
    PersonRule{"cohort", ""},
    PersonRule{"composite_result", ""},
    PersonRule{"curriculum", ""},
    PersonRule{"curriculum_arm", ""},
    PersonRule{"curriculum_draft", ""},
    PersonRule{"curriculum_phase", ""},
    PersonRule{"curriculum_occasion", ""},
    PersonRule{"curriculum_state", ""},
    PersonRule{"curriculum_version", ""},
    PersonRule{"erasure_gate", ""},
    PersonRule{"evaluation_campaign", ""},
    PersonRule{"evaluation_class", ""},
    PersonRule{"evaluation_index", ""},
    PersonRule{"evaluation_model", ""},
    PersonRule{"evaluation_result", ""},
    PersonRule{"frozen_dataset", ""},
    PersonRule{"mark_release", ""},
    PersonRule{"mastery_rule", ""},
    PersonRule{"module", ""},
    PersonRule{"module_prerequisite", ""},
    PersonRule{"operation", ""},
    PersonRule{"rater_class", ""},
    PersonRule{"reference_run", ""},
    PersonRule{"reference_run_withdrawal", ""},
    PersonRule{"retention_rule", ""},
    PersonRule{"role", ""},
    PersonRule{"role_operation", ""},
    PersonRule{"rubric", ""},
    PersonRule{"rubric_anchor", ""},
    PersonRule{"rubric_revision", ""},
    PersonRule{"rubric_row", ""},
    PersonRule{"schema_migration", ""},
    PersonRule{"occasion", ""},
    PersonRule{"setting", ""},
    PersonRule{"training_group", ""},
    PersonRule{"training_group_result", ""},
};

/// The person's id for every `?` of the condition.
std::vector<Value> valuesFor(const PersonRule& rule, const std::string& personId) {
  const auto marks = std::count(rule.condition.begin(), rule.condition.end(), '?');
  return std::vector<Value>(static_cast<std::size_t>(marks), Value(personId));
}

void applyRule(Connection& connection, const PersonRule& rule, const std::string& personId) {
  if (rule.condition.empty() || rule.onErase == OnErase::kKeep) {
    return;
  }
  const std::string table(rule.table);
  const std::string act = rule.onErase == OnErase::kDelete
                              ? "DELETE FROM " + table
                              : "UPDATE " + table + " SET " + std::string(rule.cleared);
  connection.prepare(act + " WHERE " + std::string(rule.condition)).execute(valuesFor(rule, personId));
}

}  // namespace

std::span<const PersonRule> personRules() {
  return kRules;
}

std::vector<PersonTable> exportPerson(Connection& connection, const std::string& personId) {
  std::vector<PersonTable> tables;
  for (const PersonRule& rule : kRules) {
    if (rule.condition.empty()) {
      continue;
    }
    PersonTable table{std::string(rule.table), {}, {}};
    Statement row = connection.prepare("SELECT " + std::string(rule.columns) + " FROM " + table.table +
                                       " WHERE " + std::string(rule.condition));
    row.execute(valuesFor(rule, personId));
    while (row.step()) {
      std::vector<Value> values;
      for (int column = 0; column < row.columnCount(); ++column) {
        if (table.rows.empty()) {
          table.columns.push_back(row.columnName(column));
        }
        values.push_back(row.value(column));
      }
      table.rows.push_back(std::move(values));
    }
    if (!table.rows.empty()) {
      tables.push_back(std::move(table));
    }
  }
  return tables;
}

void erasePerson(Connection& connection, const std::string& personId, const std::string& requestedBy,
                 const std::string& reason, std::int64_t utc_us) {
  Transaction transaction(connection);
  if (connection.execute("UPDATE person SET state = 'erased' WHERE id = ? AND state <> 'erased'",
                         {personId}) != 1) {
    throw Error(ErrorCode::kBadData, "there is no such person, or they were erased already", "erase",
                "Check the code");
  }
  connection.execute(insertInto("erasure_gate", "id, reason, opened_utc_us"), {personId, reason, utc_us});
  for (const PersonRule& rule : kRules) {
    applyRule(connection, rule, personId);
  }
  connection.execute("DELETE FROM erasure_gate WHERE id = ?", {personId});
  connection.execute(insertInto("erasure", "person_id, requested_by, reason, erased_utc_us"),
                     {personId, requestedBy, reason, utc_us});
  NewAuditEntry entry{.atUtc_us = utc_us,
                      .actor = requestedBy,
                      .station = {},
                      .action = AuditAction::kPersonErase,
                      .objectKind = AuditObject::kPerson,
                      .objectId = personId,
                      .reason = reason};
  AuditRepository(connection).append(entry);
  transaction.commit();
}

}  // namespace torsio
