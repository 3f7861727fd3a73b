// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string_view>

namespace torsio {

/// How the rows of a table are protected against tampering.
enum class Sealing {
  kOnce,        ///< each row is sealed when it is added; a second seal requires an erase or the demonstration
  kEachChange,  ///< each change is sealed
  kWithParent,  ///< part of the seal of the row named by its first key column
  kElsewhere,   ///< another check detects changes; see `reason`
  kNot,         ///< nothing relies on it; see `reason`
};

/// Seal rule of one table. Every table of the schema has exactly one rule, and columns not named by it are
/// sealed (tested).
struct SealRule {
  std::string_view table;
  Sealing sealing = Sealing::kOnce;
  std::string_view key;         ///< primary key: "a, b"
  std::string_view personal{};  ///< columns that an erase clears or deletes; hashed with a salt
  std::string_view parent{};    ///< kWithParent
  std::string_view unsealed{};  ///< columns that are left out; see `reason`
  std::string_view reason{};
};

namespace seal_reasons {
inline constexpr std::string_view kDraft =
    "being written; counts for nothing until it is submitted, and that is sealed";
inline constexpr std::string_view kSchema =
    "the check of the schema compares it with the steps of the program";
inline constexpr std::string_view kChain = "the chain of the audit trail and its seals are walked";
}  // namespace seal_reasons

/// The rules of all tables, parents before the tables that are part of their seals.
inline constexpr std::array kSealRules{
    SealRule{"centre", Sealing::kEachChange, "id"},
    SealRule{"setting", Sealing::kEachChange, "name"},
    SealRule{"site", Sealing::kEachChange, "centre_id"},
    SealRule{"site_delivery", Sealing::kOnce, "id"},
    SealRule{.table = "site_row",
             .sealing = Sealing::kWithParent,
             .key = "delivery_id, table_name, row_key",
             .parent = "site_delivery"},
    SealRule{.table = "erasure_gate",
             .sealing = Sealing::kElsewhere,
             .key = "id",
             .reason = "is empty whenever it is looked at; a row in it is a finding"},
    SealRule{"person", Sealing::kEachChange, "id", "sex, level, experience, age_years"},
    SealRule{"person_identity", Sealing::kEachChange, "person_id", "full_name, email, external_id"},
    SealRule{"trainee", Sealing::kEachChange, "person_id", "handedness"},
    SealRule{"rater_class", Sealing::kEachChange, "code"},
    SealRule{"rater", Sealing::kEachChange, "person_id"},
    SealRule{"roster_import", Sealing::kEachChange, "id"},
    SealRule{"roster_import_person", Sealing::kEachChange, "person_id, import_id", "before_json, after_json"},
    SealRule{"consent_purpose", Sealing::kEachChange, "code"},
    SealRule{"consent_version", Sealing::kOnce, "id"},
    SealRule{"consent_text", Sealing::kOnce, "version_id, language, purpose"},
    SealRule{"consent", Sealing::kOnce, "person_id, purpose, sequence"},
    SealRule{"retention_rule", Sealing::kEachChange, "category"},
    SealRule{"retention_hold", Sealing::kOnce, "person_id, sequence"},
    SealRule{"erasure", Sealing::kOnce, "person_id"},
    SealRule{"record_copy", Sealing::kEachChange, "id"},
    SealRule{.table = "role", .sealing = Sealing::kElsewhere, .key = "code", .reason = seal_reasons::kSchema},
    SealRule{
        .table = "operation", .sealing = Sealing::kElsewhere, .key = "code", .reason = seal_reasons::kSchema},
    SealRule{.table = "role_operation",
             .sealing = Sealing::kElsewhere,
             .key = "role_code, operation_code",
             .reason = seal_reasons::kSchema},
    SealRule{.table = "schema_migration",
             .sealing = Sealing::kElsewhere,
             .key = "version",
             .unsealed = "software_version, applied_utc_us",
             .reason = seal_reasons::kSchema},
    SealRule{.table = "app_user",
             .sealing = Sealing::kEachChange,
             .key = "id",
             .personal = "login, person_id, password_hash, pin_hash",
             .unsealed = "failed_count, locked_until_utc_us",
             .reason = "slow down guessing of passwords; every failed sign-in is in the trail"},
    SealRule{"user_role", Sealing::kEachChange, "user_id, role_code"},
    SealRule{.table = "sign_in_failure",
             .sealing = Sealing::kNot,
             .key = "bucket",
             .reason = "slows down guessing of names; every failed sign-in is in the trail"},
    SealRule{.table = "server_session",
             .sealing = Sealing::kNot,
             .key = "token_hash",
             .reason = "ends by itself; every sign-in is in the trail"},
    SealRule{.table = "password_pepper",
             .sealing = Sealing::kNot,
             .key = "id",
             .reason = "with another one no password fits, which is noticed at once"},
    SealRule{.table = "second_factor",
             .sealing = Sealing::kEachChange,
             .key = "user_id",
             .personal = "recovery_codes",
             .unsealed = "last_step",
             .reason = "changes with every sign-in, which is in the trail"},
    SealRule{.table = "second_factor_secret",
             .sealing = Sealing::kNot,
             .key = "user_id",
             .reason = "with another one no code fits, which is noticed at once"},
    SealRule{"kiosk_code", Sealing::kEachChange, "id", "user_id, code_hash"},
    SealRule{"invitation", Sealing::kEachChange, "id", "user_id, token_hash"},
    SealRule{"person_request", Sealing::kEachChange, "id"},
    SealRule{"duty_request", Sealing::kOnce, "id"},
    SealRule{"duty_decision", Sealing::kOnce, "request_id"},
    SealRule{.table = "audit_entry",
             .sealing = Sealing::kElsewhere,
             .key = "sequence",
             .reason = seal_reasons::kChain},
    SealRule{.table = "row_seal",
             .sealing = Sealing::kElsewhere,
             .key = "entry_sequence, position",
             .reason = seal_reasons::kChain},
    SealRule{.table = "seal_salt",
             .sealing = Sealing::kElsewhere,
             .key = "table_name, row_key",
             .reason = "with another salt the row no longer fits its seal"},
    SealRule{"occasion", Sealing::kEachChange, "code"},

    SealRule{"curriculum", Sealing::kEachChange, "id"},
    SealRule{.table = "curriculum_draft",
             .sealing = Sealing::kNot,
             .key = "curriculum_id",
             .reason = seal_reasons::kDraft},
    SealRule{"curriculum_version", Sealing::kOnce, "id"},
    SealRule{"curriculum_state", Sealing::kOnce, "version_id, sequence"},
    SealRule{"module", Sealing::kOnce, "id"},
    SealRule{"module_prerequisite", Sealing::kOnce, "module_id, requires_module_id"},
    SealRule{"mastery_rule", Sealing::kOnce, "module_id, metric"},
    SealRule{"competence_design", Sealing::kOnce, "module_id, version"},
    SealRule{"curriculum_arm", Sealing::kOnce, "id"},
    SealRule{"curriculum_phase", Sealing::kOnce, "id"},
    SealRule{"curriculum_occasion", Sealing::kOnce, "version_id, occasion"},

    SealRule{"cohort", Sealing::kEachChange, "id"},
    SealRule{"cohort_state", Sealing::kOnce, "cohort_id, sequence"},
    SealRule{"study_import", Sealing::kOnce, "id"},
    SealRule{"study_statement", Sealing::kOnce, "cohort_id, item, sequence"},
    SealRule{"training_group", Sealing::kEachChange, "id"},
    SealRule{"enrolment", Sealing::kEachChange, "id"},
    SealRule{"allocation_design", Sealing::kOnce, "id"},
    SealRule{"allocation_seed", Sealing::kEachChange, "design_id"},
    SealRule{"allocation", Sealing::kOnce, "id"},
    SealRule{"exposure", Sealing::kOnce, "id"},
    SealRule{"deviation", Sealing::kOnce, "id", "description"},
    SealRule{"frozen_dataset", Sealing::kOnce, "id"},

    SealRule{"trial", Sealing::kOnce, "id"},
    SealRule{.table = "trial_chunk",
             .sealing = Sealing::kElsewhere,
             .key = "trial_id, chunk_index",
             .unsealed = "stored_utc_us",
             .reason = "every recording is decoded and compared with the hash in its sealed end; when a "
                       "second reached the disk says nothing about the run"},
    SealRule{"trial_end", Sealing::kOnce, "trial_id"},
    SealRule{"trial_digest", Sealing::kOnce,
             "trial_id, formula_version, tolerance_rad, force_limit_n, torque_limit_nm"},
    SealRule{"run_excuse", Sealing::kOnce, "trial_id", "reason"},
    SealRule{"trial_remark", Sealing::kOnce, "id", "text"},
    SealRule{"remark_revision", Sealing::kOnce, "remark_id, version", "text"},
    SealRule{"remark_receipt", Sealing::kOnce, "remark_id, reader, version"},
    SealRule{"trial_question", Sealing::kOnce, "remark_id"},
    SealRule{.table = "station_state",
             .sealing = Sealing::kNot,
             .key = "station",
             .reason = "what a station shows now, overwritten every ten seconds"},

    SealRule{.table = "learning_event",
             .sealing = Sealing::kNot,
             .key = "kind, object_id",
             .reason = "what was sent or waits to be sent; what it tells of is sealed"},

    SealRule{"rubric", Sealing::kEachChange, "id"},
    SealRule{"rubric_revision", Sealing::kOnce, "id"},
    SealRule{"rubric_row", Sealing::kOnce, "revision_id, row_code"},
    SealRule{"rubric_anchor", Sealing::kOnce, "revision_id, row_code, score_steps"},
    SealRule{"self_score", Sealing::kOnce, "id"},
    SealRule{.table = "self_score_row",
             .sealing = Sealing::kWithParent,
             .key = "self_score_id, row_code",
             .parent = "self_score"},
    SealRule{"rater_warmup", Sealing::kOnce, "id"},
    SealRule{"reference_run", Sealing::kOnce, "trial_id"},
    SealRule{"reference_run_withdrawal", Sealing::kOnce, "trial_id"},

    SealRule{"assignment", Sealing::kOnce, "id"},
    SealRule{"assignment_withdrawal", Sealing::kOnce, "assignment_id, sequence"},
    SealRule{"live_call", Sealing::kEachChange, "id"},
    SealRule{.table = "day_slot",
             .sealing = Sealing::kNot,
             .key = "id",
             .reason = "a plan; what was done is sealed, and the trail tells who planned and moved"},
    SealRule{.table = "mark_draft",
             .sealing = Sealing::kNot,
             .key = "assignment_id",
             .reason = seal_reasons::kDraft},
    SealRule{.table = "mark_draft_row",
             .sealing = Sealing::kNot,
             .key = "assignment_id, row_code",
             .reason = seal_reasons::kDraft},
    SealRule{.table = "draft_viewing",
             .sealing = Sealing::kNot,
             .key = "assignment_id",
             .reason = seal_reasons::kDraft},
    SealRule{.table = "watch_account",
             .sealing = Sealing::kNot,
             .key = "rater_id",
             .reason =
                 "what may still be credited, overwritten every two seconds; what counted is sealed with "
                 "the mark"},
    SealRule{.table = "paper_entry",
             .sealing = Sealing::kNot,
             .key = "assignment_id, entered_by",
             .reason = seal_reasons::kDraft},
    SealRule{.table = "paper_entry_row",
             .sealing = Sealing::kNot,
             .key = "assignment_id, entered_by, row_code",
             .reason = seal_reasons::kDraft},
    SealRule{"training_mark", Sealing::kOnce, "id", "comment"},
    SealRule{.table = "training_mark_row",
             .sealing = Sealing::kWithParent,
             .key = "mark_id, row_code",
             .parent = "training_mark"},
    SealRule{"mark_viewing", Sealing::kOnce, "mark_id"},
    SealRule{"mark_release", Sealing::kOnce, "cohort_id, occasion, sequence"},
    SealRule{"alignment_decision", Sealing::kOnce, "assignment_id, sequence"},

    SealRule{"evaluation_campaign", Sealing::kOnce, "id"},
    SealRule{"evaluation_class", Sealing::kOnce, "campaign_id, class_code"},
    SealRule{"evaluation_index", Sealing::kOnce, "campaign_id, index_number"},
    SealRule{"evaluation_model", Sealing::kOnce, "campaign_id, model_code"},
    SealRule{"evaluation_rater", Sealing::kOnce, "campaign_id, rater_id"},
    SealRule{"evaluation_mark", Sealing::kOnce, "id"},
    SealRule{.table = "evaluation_draft",
             .sealing = Sealing::kNot,
             .key = "campaign_id, rater_id, model_code, index_number",
             .reason = seal_reasons::kDraft},

    SealRule{"signature", Sealing::kOnce, "object_kind, object_id"},

    SealRule{"assessment_run", Sealing::kOnce, "id"},
    SealRule{.table = "evaluation_result",
             .sealing = Sealing::kWithParent,
             .key = "run_id, model_code, index_number",
             .parent = "assessment_run"},
    SealRule{.table = "composite_result",
             .sealing = Sealing::kWithParent,
             .key = "run_id, model_code",
             .parent = "assessment_run"},
    SealRule{.table = "training_result",
             .sealing = Sealing::kWithParent,
             .key = "run_id, enrolment_id, occasion",
             .parent = "assessment_run"},
    SealRule{.table = "training_group_result",
             .sealing = Sealing::kWithParent,
             .key = "run_id, group_id, occasion",
             .parent = "assessment_run"},
};

/// Tables whose first rows come with the schema and that centres extend.
inline constexpr std::array<std::string_view, 2> kGrowingSeeds{"occasion", "consent_purpose"};

/// Returns the rule of a table; null: none, or its rows are not sealed.
[[nodiscard]] constexpr const SealRule* sealRuleOf(std::string_view table) {
  for (const SealRule& rule : kSealRules) {
    if (rule.table == table) {
      return rule.sealing == Sealing::kElsewhere || rule.sealing == Sealing::kNot ? nullptr : &rule;
    }
  }
  return nullptr;
}

}  // namespace torsio
