// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/repository/system/site_tables.h"

#include <algorithm>
#include <array>
#include <utility>

#include "db/connection/row_reader.h"
#include "db/repository/base/seal_rules.h"
#include "sim/core/contracts.h"

namespace torsio {

namespace {

constexpr std::string_view kVersionRows = "version_id = {version}";
constexpr std::string_view kModuleRows = "module_id IN (SELECT id FROM module WHERE version_id = {version})";
constexpr std::string_view kOfEnrolments = "enrolment_id IN ({enrolments})";
constexpr std::string_view kOfTrials =
    "trial_id IN (SELECT id FROM trial WHERE enrolment_id IN ({enrolments}))";
constexpr std::string_view kOfMarks =
    "mark_id IN (SELECT id FROM training_mark WHERE enrolment_id IN ({enrolments}))";
constexpr std::string_view kOfAssignments =
    "assignment_id IN (SELECT id FROM assignment WHERE enrolment_id IN ({enrolments}))";
constexpr std::string_view kOfCampaign = "campaign_id = {campaign}";
/// Sheets and self-scores refer to them.
constexpr std::string_view kRevisions =
    "(SELECT rubric_revision_id FROM assignment WHERE enrolment_id IN (SELECT id FROM enrolment WHERE"
    " cohort_id = {cohort}) UNION SELECT rubric_revision_id FROM self_score WHERE trial_id IN (SELECT id FROM"
    " trial WHERE enrolment_id IN (SELECT id FROM enrolment WHERE cohort_id = {cohort})))";

/// A simulated person cannot be asked.
constexpr std::string_view kAgrees =
    "(p.demonstration = TRUE OR COALESCE((SELECT c.granted FROM consent c WHERE c.person_id = p.id AND"
    " c.purpose = 'research' ORDER BY c.sequence DESC LIMIT 1), FALSE) = TRUE)";

/// Asked about people who do not agree now: their rows may have left the centre before.
constexpr std::string_view kAgreedOnce =
    "EXISTS (SELECT 1 FROM consent c WHERE c.person_id = p.id AND c.purpose = 'research' AND"
    " c.granted = TRUE)";

std::string replaced(std::string text, const std::string& word, const std::string& by) {
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + by.size())) {
    text.replace(at, word.size(), by);
  }
  return text;
}

/// Ids come from the record, where anybody with the file may have written them.
std::string quoted(const std::string& id) {
  return "'" + replaced(id, "'", "''") + "'";
}

/// Puts the ids in their places, all in one pass: what stands in an id is never taken for a place.
std::string withIds(const std::string& text, const SiteScope& scope) {
  const std::array<std::pair<std::string_view, std::string>, 3> ids{{{"{cohort}", quoted(scope.cohortId)},
                                                                     {"{campaign}", quoted(scope.campaignId)},
                                                                     {"{version}", quoted(scope.versionId)}}};
  std::string filled;
  for (std::size_t at = 0; at < text.size();) {
    const auto* id = std::find_if(ids.begin(), ids.end(), [&](const auto& one) {
      return text.compare(at, one.first.size(), one.first) == 0;
    });
    if (id == ids.end()) {
      filled += text[at++];
    } else {
      filled += id->second;
      at += id->first.size();
    }
  }
  return filled;
}

std::string filledIn(std::string text, const SiteScope& scope) {
  const std::string members =
      "SELECT e.trainee_id FROM enrolment e JOIN person p ON p.id = e.trainee_id WHERE e.cohort_id = {cohort}"
      " AND p.state <> 'erased' AND ";
  const std::string trainees = members + std::string(kAgrees);
  const std::string withdrawn = members + "NOT " + std::string(kAgrees) + " AND " + std::string(kAgreedOnce);
  const std::string enrolments =
      "SELECT id FROM enrolment WHERE cohort_id = {cohort} AND trainee_id IN ({trainees})";
  const std::string raters =
      "SELECT rater_id FROM assignment WHERE enrolment_id IN ({enrolments}) UNION SELECT rater_id FROM"
      " training_mark WHERE enrolment_id IN ({enrolments}) UNION SELECT rater_id FROM evaluation_rater WHERE"
      " campaign_id = {campaign}";
  text = replaced(std::move(text), "{people}", "{trainees} UNION {raters}");
  text = replaced(std::move(text), "{raters}", raters);
  text = replaced(std::move(text), "{enrolments}", enrolments);
  text = replaced(std::move(text), "{trainees}", trainees);
  text = replaced(std::move(text), "{withdrawn}", withdrawn);
  text = replaced(std::move(text), "{revisions}", std::string(kRevisions));
  return withIds(text, scope);
}

}  // namespace

const std::vector<SiteTable>& siteTables() {
  static const std::vector<SiteTable> kTables{
      {"occasion", "code"},
      {"rater_class", "code"},
      {"curriculum", "name", "id IN (SELECT curriculum_id FROM curriculum_version WHERE id = {version})",
       "description"},
      {"curriculum_version", "curriculum_id, number", "id = {version}", "note"},
      {"curriculum_state", "version_id, sequence", kVersionRows, "changed_by"},
      {"module", "version_id, code", kVersionRows},
      {"module_prerequisite", "module_id, requires_module_id", kModuleRows},
      {"mastery_rule", "module_id, metric", kModuleRows},
      {"competence_design", "module_id, version", kModuleRows, "reason"},
      {"curriculum_arm", "version_id, code", kVersionRows},
      {"curriculum_phase", "arm_id, position",
       "arm_id IN (SELECT id FROM curriculum_arm WHERE version_id = {version})"},
      {"curriculum_occasion", "version_id, occasion", kVersionRows},
      {"cohort", "name", "id = {cohort}", "description"},
      {"training_group", "cohort_id, code", "cohort_id = {cohort}"},
      {"rubric", "name", "id IN (SELECT rubric_id FROM rubric_revision WHERE id IN {revisions})"},
      {"rubric_revision", "rubric_id, number", "id IN {revisions}", "created_by, note"},
      {"rubric_row", "revision_id, row_code", "revision_id IN {revisions}"},
      {"rubric_anchor", "revision_id, row_code, score_steps", "revision_id IN {revisions}"},
      {"evaluation_campaign", "name", "id = {campaign}"},
      {"evaluation_class", "campaign_id, class_code", kOfCampaign},
      {"evaluation_index", "campaign_id, index_number", kOfCampaign},
      {"evaluation_model", "campaign_id, model_code", kOfCampaign, "trial_id"},
      {"person", "", "id IN ({people})", "experience"},
      {"trainee", "", "person_id IN ({trainees})"},
      {"rater", "", "person_id IN ({raters})"},
      {"consent", "", "(person_id IN ({trainees}) OR person_id IN ({withdrawn})) AND purpose = 'research'",
       "recorded_by"},
      {"enrolment", "", "id IN ({enrolments})"},
      {"exposure", "", kOfEnrolments, "recorded_by"},
      {"deviation", "", kOfEnrolments, "description, reported_by"},
      {"trial", "", kOfEnrolments, "import_id"},
      {"trial_chunk", "", kOfTrials},
      {"trial_end", "", kOfTrials},
      {"trial_digest", "", kOfTrials},
      {"run_excuse", "", kOfTrials, "excused_by, reason"},
      {"self_score", "", kOfTrials},
      {"self_score_row", "",
       "self_score_id IN (SELECT id FROM self_score WHERE trial_id IN (SELECT id FROM trial WHERE "
       "enrolment_id"
       " IN ({enrolments})))"},
      {"assignment", "", kOfEnrolments, "assigned_by"},
      {"assignment_withdrawal", "", kOfAssignments, "reason, decided_by"},
      {"live_call", "", "enrolment_id IN ({enrolments}) AND ended_utc_us IS NOT NULL", "room, called_by"},
      {"training_mark", "", kOfEnrolments, "comment, import_id, amend_reason, not_assessable_reason"},
      {"training_mark_row", "", kOfMarks, "not_assessable_reason"},
      {"mark_viewing", "", kOfMarks},
      {"alignment_decision", "", kOfAssignments, "reason, decided_by"},
      {"evaluation_rater", "", kOfCampaign},
      {"evaluation_mark", "", kOfCampaign, "amend_reason"},
  };
  return kTables;
}

const SiteTable* siteTableOf(std::string_view table) {
  const auto found = std::find_if(siteTables().begin(), siteTables().end(),
                                  [&](const SiteTable& one) { return one.table == table; });
  return found == siteTables().end() ? nullptr : &*found;
}

std::string SiteScope::select(const SiteTable& table, const std::string& columns) const {
  std::string select = "SELECT " + columns + " FROM " + std::string(table.table);
  if (!table.condition.empty()) {
    select += " WHERE " + filledIn(std::string(table.condition), *this);
  }
  return select;
}

SiteConsent siteConsent(Connection& connection, const SiteScope& scope) {
  const auto count = [&](const std::string& people) {
    return selectFirst(connection, filledIn("SELECT count(*) FROM (" + people + ") AS x", scope), {},
                       readInt64)
        .value_or(0);
  };
  SiteConsent consent;
  consent.given = count("{trainees}");
  consent.leftOut = count("SELECT id FROM enrolment WHERE cohort_id = {cohort}") - consent.given;
  return consent;
}

std::vector<std::string> withdrawnPeople(Connection& connection, const CentreId& site) {
  return selectAll(connection,
                   "SELECT p.code FROM person p JOIN trainee t ON t.person_id = p.id WHERE p.site_id = ? AND"
                   " p.state <> 'erased' AND NOT " +
                       std::string(kAgrees) + " ORDER BY p.code",
                   {site}, readText);
}

const SealShape& SiteSealer::shapeOf(const std::string& table, const std::vector<std::string>& columns) {
  if (const auto known = shapes_.find(table); known != shapes_.end()) {
    return known->second;
  }
  const auto* rule = std::find_if(kSealRules.begin(), kSealRules.end(),
                                  [&](const SealRule& one) { return one.table == table; });
  TORSIO_EXPECTS(rule != kSealRules.end());
  return shapes_.emplace(table, SealShape(*rule, columns)).first->second;
}

std::string SiteSealer::keyOf(const std::string& table, const std::vector<std::string>& columns,
                              const std::vector<Value>& row) {
  return shapeOf(table, columns).keyOf(row);
}

void SiteSealer::add(const std::string& table, const std::vector<std::string>& columns,
                     const std::vector<Value>& row) {
  const SealShape& shape = shapeOf(table, columns);
  if (shape.rule().sealing == Sealing::kWithParent) {
    parts_[std::string(shape.rule().parent)][shape.parentKeyOf(row)].push_back(shape.kept(row));
  } else if (sealRuleOf(table) != nullptr) {
    kept_[table][shape.keyOf(row)] = shape.kept(row);
  }
}

std::map<std::string, std::string> SiteSealer::seals(const std::string& table) {
  std::map<std::string, std::string> seals;
  const SealedParts& parts = parts_[table];
  for (const auto& [key, kept] : kept_[table]) {
    const auto own = parts.find(key);
    seals[key] = sealOf(kept, own == parts.end() ? std::vector<Digest::Value>() : own->second);
  }
  return seals;
}

}  // namespace torsio
