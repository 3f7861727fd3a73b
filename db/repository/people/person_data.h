// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "assessment/domain/ids.h"
#include "db/connection/connection.h"

namespace torsio {

/// A person's rows in one table.
struct PersonTable {
  std::string table;
  std::vector<std::string> columns;
  std::vector<std::vector<Value>> rows;
};

/// Returns everything stored about a person, without empty tables. Recordings are listed by trial and chunk;
/// load them with TrialRepository.
[[nodiscard]] std::vector<PersonTable> exportPerson(Connection& connection, const PersonId& personId);

/// Erases a person: removes identity, demographics, recordings, comments, sign-in and drafts; keeps code,
/// marks, results and audit trail, so that statistics do not change. One transaction. Throws Error (kBadData)
/// if the person is unknown or already erased.
void erasePerson(Connection& connection, const PersonId& personId, const std::string& requestedBy,
                 const std::string& reason, std::int64_t utc_us);

/// What an erase does with a person's rows.
enum class OnErase {
  kKeep,    ///< pseudonymous rows needed for statistics and audit trail
  kClear,   ///< the named columns are set to null
  kDelete,  ///< the rows are deleted
};

/// How a table relates to a person. Every table of the schema has exactly one rule (tested).
struct PersonRule {
  std::string_view table;
  std::string_view
      condition;  ///< selects a person's rows, with one `?` or more for the id; empty: no personal data
  OnErase onErase = OnErase::kKeep;
  std::string_view cleared{};      ///< kClear: "a = NULL, b = NULL"
  std::string_view columns = "*";  ///< exported columns: no secrets, no bytes of recordings
};

namespace person_conditions {

inline constexpr std::string_view kAsTrainee =
    "enrolment_id IN (SELECT id FROM enrolment WHERE trainee_id = ?)";
inline constexpr std::string_view kOwnTrials = "trial_id IN (SELECT id FROM trial WHERE trainee_id = ?)";
inline constexpr std::string_view kMarks =
    "(enrolment_id IN (SELECT id FROM enrolment WHERE trainee_id = ?) OR rater_id = ?)";
inline constexpr std::string_view kMarkRows =
    "mark_id IN (SELECT id FROM training_mark WHERE rater_id = ? OR enrolment_id IN"
    " (SELECT id FROM enrolment WHERE trainee_id = ?))";
inline constexpr std::string_view kDrafts =
    "assignment_id IN (SELECT id FROM assignment WHERE rater_id = ? OR enrolment_id IN"
    " (SELECT id FROM enrolment WHERE trainee_id = ?))";
inline constexpr std::string_view kRemarks =
    "(author_person_id = ? OR author IN (SELECT id FROM app_user WHERE person_id = ?)"
    " OR trial_id IN (SELECT id FROM trial WHERE trainee_id = ?))";
inline constexpr std::string_view kRevisions =
    "(author_person_id = ? OR author IN (SELECT id FROM app_user WHERE person_id = ?) OR remark_id IN"
    " (SELECT m.id FROM trial_remark m JOIN trial t ON t.id = m.trial_id WHERE t.trainee_id = ?))";
inline constexpr std::string_view kReceipts =
    "(reader_person_id = ? OR reader IN (SELECT id FROM app_user WHERE person_id = ?))";
inline constexpr std::string_view kQuestions =
    "(rater_id = ? OR remark_id IN (SELECT id FROM trial_remark WHERE author_person_id = ?))";
inline constexpr std::string_view kOwnScores =
    "self_score_id IN (SELECT id FROM self_score WHERE trainee_id = ?)";
inline constexpr std::string_view kOwnUser = "user_id IN (SELECT id FROM app_user WHERE person_id = ?)";

}  // namespace person_conditions

/// The rules of all tables, in an order in which an erase may proceed.
inline constexpr std::array kPersonRules{
    PersonRule{"person_identity", "person_id = ?", OnErase::kDelete},
    PersonRule{"person", "id = ?", OnErase::kClear,
               "sex = NULL, level = NULL, experience = NULL, age_years = NULL, state = 'erased'"},
    PersonRule{"trainee", "person_id = ?", OnErase::kClear, "handedness = NULL"},
    PersonRule{"rater", "person_id = ?"},
    PersonRule{"roster_import_person", "person_id = ?", OnErase::kDelete},
    PersonRule{"station_state", person_conditions::kOwnUser, OnErase::kClear, "user_id = NULL"},
    PersonRule{"remark_receipt", person_conditions::kReceipts},
    PersonRule{"trial_question", person_conditions::kQuestions},
    PersonRule{"remark_revision", person_conditions::kRevisions, OnErase::kClear, "text = NULL"},
    PersonRule{"trial_remark", person_conditions::kRemarks, OnErase::kClear, "text = NULL"},
    PersonRule{"second_factor", person_conditions::kOwnUser, OnErase::kDelete, "", "user_id, made_utc_us"},
    PersonRule{"kiosk_code", person_conditions::kOwnUser, OnErase::kDelete, "",
               "id, user_id, made_utc_us, revoked_utc_us"},
    PersonRule{"invitation", person_conditions::kOwnUser, OnErase::kDelete, "",
               "id, user_id, made_utc_us, expires_utc_us, state"},
    PersonRule{"person_request", "person_id = ?"},
    PersonRule{"day_slot", person_conditions::kAsTrainee},
    PersonRule{"user_role", person_conditions::kOwnUser, OnErase::kDelete},
    PersonRule{"audit_entry",
               "(actor = ? OR object_id = ? OR actor IN (SELECT id FROM app_user WHERE person_id = ?))"},
    PersonRule{"app_user", "person_id = ?", OnErase::kDelete, "",
               "id, login, person_id, must_change_password, state, created_utc_us, demonstration"},
    PersonRule{"duty_request",
               "(subject = ? OR requested_by IN (SELECT id FROM app_user WHERE person_id = ?))",
               OnErase::kKeep, "", "id, act, subject, reason, requested_by, requested_utc_us"},
    PersonRule{"duty_decision", "decided_by IN (SELECT id FROM app_user WHERE person_id = ?)"},
    PersonRule{"signature", "person_id = ?"},
    PersonRule{"consent", "person_id = ?"},
    PersonRule{"enrolment", "trainee_id = ?"},
    PersonRule{"allocation", person_conditions::kAsTrainee},
    PersonRule{"trial", "trainee_id = ?"},
    PersonRule{"trial_chunk", person_conditions::kOwnTrials, OnErase::kDelete, "",
               "trial_id, chunk_index, first_tick, sample_count, digest, output_digest, stored_utc_us"},
    PersonRule{"trial_end", person_conditions::kOwnTrials},
    PersonRule{"trial_digest", person_conditions::kOwnTrials},
    PersonRule{"run_excuse", person_conditions::kOwnTrials, OnErase::kClear, "reason = NULL"},
    PersonRule{"draft_viewing", person_conditions::kDrafts, OnErase::kDelete},
    PersonRule{"mark_draft_row", person_conditions::kDrafts, OnErase::kDelete},
    PersonRule{"mark_draft", person_conditions::kDrafts, OnErase::kDelete},
    PersonRule{"paper_entry_row", person_conditions::kDrafts, OnErase::kDelete},
    PersonRule{"paper_entry", person_conditions::kDrafts, OnErase::kDelete},
    PersonRule{"assignment", person_conditions::kMarks},
    PersonRule{"assignment_withdrawal", person_conditions::kDrafts},
    PersonRule{"live_call", person_conditions::kAsTrainee},
    PersonRule{"training_mark", person_conditions::kMarks, OnErase::kClear, "comment = NULL"},
    PersonRule{"training_mark_row", person_conditions::kMarkRows},
    PersonRule{"mark_viewing", person_conditions::kMarkRows},
    PersonRule{"evaluation_rater", "rater_id = ?"},
    PersonRule{"evaluation_mark", "rater_id = ?"},
    PersonRule{"evaluation_draft", "rater_id = ?", OnErase::kDelete},
    PersonRule{"training_result", person_conditions::kAsTrainee},
    PersonRule{"alignment_decision", person_conditions::kDrafts},
    PersonRule{"self_score", "trainee_id = ?"},
    PersonRule{"self_score_row", person_conditions::kOwnScores},
    PersonRule{"rater_warmup", "rater_id = ?"},
    PersonRule{"watch_account", "rater_id = ?", OnErase::kDelete},
    PersonRule{"retention_hold", "person_id = ?"},
    PersonRule{"exposure", person_conditions::kAsTrainee},
    PersonRule{"deviation", person_conditions::kAsTrainee, OnErase::kClear, "description = NULL"},
    PersonRule{"learning_event", "person_id = ?", OnErase::kDelete},
    PersonRule{"erasure", "person_id = ?"},
    PersonRule{"record_copy", "person_id = ?"},
    // No personal data: plans, names and aggregates.
    PersonRule{"allocation_design", ""},
    PersonRule{"allocation_seed", ""},
    PersonRule{"assessment_run", ""},
    PersonRule{"centre", ""},
    PersonRule{"cohort", ""},
    PersonRule{"cohort_state", ""},
    PersonRule{"study_import", ""},
    PersonRule{"study_statement", ""},
    PersonRule{"consent_purpose", ""},
    PersonRule{"consent_text", ""},
    PersonRule{"consent_version", ""},
    PersonRule{"competence_design", ""},
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
    PersonRule{"password_pepper", ""},
    PersonRule{"rater_class", ""},
    PersonRule{"reference_run", ""},
    PersonRule{"reference_run_withdrawal", ""},
    PersonRule{"retention_rule", ""},
    PersonRule{"role", ""},
    PersonRule{"role_operation", ""},
    PersonRule{"row_seal", ""},
    PersonRule{"seal_salt", ""},
    PersonRule{"roster_import", ""},
    PersonRule{"rubric", ""},
    PersonRule{"rubric_anchor", ""},
    PersonRule{"rubric_revision", ""},
    PersonRule{"rubric_row", ""},
    PersonRule{"schema_migration", ""},
    PersonRule{"occasion", ""},
    PersonRule{"second_factor_secret", ""},  // goes with second_factor
    PersonRule{"server_session", ""},        // goes with the account
    PersonRule{"setting", ""},
    PersonRule{"site", ""},
    PersonRule{"site_delivery", ""},
    PersonRule{"site_row", ""},
    PersonRule{"sign_in_failure", ""},
    PersonRule{"training_group", ""},
    PersonRule{"training_group_result", ""},
};

}  // namespace torsio
