// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/outputs/report/coded_tables.h"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "app/services/access/audit_service.h"
#include "app/services/base/build_info.h"
#include "app/services/base/csv_table.h"
#include "app/services/review/panel_opening.h"
#include "assessment/attempt/trial_listing.h"
#include "assessment/domain/ids.h"
#include "assessment/domain/rating/assignment.h"
#include "assessment/domain/rating/mark.h"
#include "assessment/domain/rating/rubric.h"
#include "assessment/domain/rating/sheet_check.h"
#include "assessment/domain/study/cohort.h"
#include "assessment/domain/study/protocol_terms.h"
#include "assessment/results/number_format.h"
#include "db/repository/people/signature_repository.h"
#include "db/repository/rating/rating_repository.h"
#include "db/repository/rating/rubric_repository.h"
#include "db/repository/rating/sheet_repository.h"
#include "db/repository/study/study_repository.h"
#include "db/repository/trial/trial_repository.h"
#include "sim/core/byte_order_mark.h"
#include "sim/core/digest.h"
#include "sim/core/file_io.h"
#include "sim/core/time_units.h"

namespace torsio {

namespace {

using Cells = std::vector<std::string>;

constexpr std::int64_t kAllTrials = 1'000'000;
constexpr std::int64_t kAllEntries = INT64_MAX;

/// Audits an export, then writes it: an entry for a file that could not be written is better than an export
/// without an entry. The last column is the previous head of the audit trail.
std::size_t write(SessionContext& session, const AuditNote& what, std::vector<Cells> lines,
                  const std::filesystem::path& file, const CsvStyle& look) {
  const std::string told = plainHead(session.connection(), session.now_us());
  for (Cells& cells : lines) {
    cells.push_back(&cells == &lines.front() ? "trail_head" : told);
  }
  std::string text(kByteOrderMark);
  for (const Cells& cells : lines) {
    text += csvLine(cells);
  }
  text = csvInStyle(text, look);
  Digest digest;
  digest.update(text);
  const std::size_t rows = lines.size() - 1;
  AuditNote note = what;
  note.newJson = nlohmann::json{{"rows", rows}, {"blake2b", digest.hex()}}.dump();
  session.note(note);
  writeFileAtomically(file, text);
  return rows;
}

/// The scoring sheets of a cohort, cached.
class SheetsOfCohort {
 public:
  SheetsOfCohort(Connection& connection, const CohortId& cohortId) : repository_(connection) {
    const RubricRepository rubrics(connection);
    for (const AssignmentStatus& status : repository_.assignments(cohortId)) {
      const RubricRevisionId& id = status.assignment.rubricRevisionId;
      revisionOf_[status.assignment.id] = id;
      if (!revisions_.contains(id)) {
        revisions_.emplace(id, rubrics.revision(id).value());
      }
    }
    for (const Rubric& rubric : rubrics.rubrics()) {
      names_[rubric.id] = rubric.name;
    }
  }
  /// Returns null if the mark was not requested.
  [[nodiscard]] const RubricRevision* rubricOf(const AssignmentId& assignmentId) const {
    const auto found = revisionOf_.find(assignmentId);
    return found == revisionOf_.end() ? nullptr : &revisions_.at(found->second);
  }
  [[nodiscard]] std::vector<SheetRow> rowsOf(const AssignmentId& assignmentId) const {
    const std::optional<Sheet> sheet = repository_.submitted(assignmentId);
    return sheet ? sheet->rows : std::vector<SheetRow>{};
  }
  /// Returns the mean of the criteria, in points; empty if there are none.
  [[nodiscard]] std::string meanOf(const SubmittedMark& mark) const {
    const RubricRevision* rubric = rubricOf(mark.assignmentId);
    const std::optional<double> mean =
        rubric == nullptr ? std::nullopt : criteriaMean(*rubric, rowsOf(mark.assignmentId));
    return mean ? formatExact(*mean) : std::string();
  }
  [[nodiscard]] std::vector<const RubricRevision*> used() const {
    std::vector<const RubricRevision*> all;
    for (const auto& [id, revision] : revisions_) {
      all.push_back(&revision);
    }
    return all;
  }
  [[nodiscard]] std::string nameOf(const RubricRevision& revision) const {
    return names_.at(revision.rubricId);
  }

 private:
  SheetRepository repository_;
  std::map<AssignmentId, RubricRevisionId> revisionOf_;
  std::map<RubricRevisionId, RubricRevision> revisions_;
  std::map<RubricId, std::string> names_;
};

std::string endOf(const TrialListing& trial) {
  if (!trial.summary) {
    return "open";
  }
  return trial.summary->outcome == TrialOutcome::kCompleted ? "completed" : "interrupted";
}

/// Returns whether a version was made when its rater could know the other raters' marks.
bool afterPanel(Connection& connection, const SubmittedMark& mark) {
  if (mark.version < 2) {
    return false;
  }
  const std::optional<std::int64_t> opened_us =
      panelOpenedToUtc_us(connection, mark.enrolmentId, mark.occasionCode, mark.raterId);
  return opened_us && mark.submittedUtc_us > *opened_us;
}

/// Adds meaning, reason and time of the signature; empty cells for an unsigned mark.
void addSignature(Cells& line, const std::map<std::string, Signature>& signatures,
                  const SubmittedMark& mark) {
  const auto found = signatures.find(mark.id);
  if (found == signatures.end()) {
    line.insert(line.end(), 5, std::string());
    return;
  }
  const Signature& one = found->second;
  const Phrase meaning = labelOf(one.meaning);
  line.insert(line.end(), {std::string(meaning.english()), mark.raterCode, formatUtc(one.signedUtc_us),
                           one.reason, formatUtc(one.passwordShownUtc_us)});
}

}  // namespace

std::size_t exportRecordings(SessionContext& session, const CohortId& cohortId,
                             const std::filesystem::path& file, const CsvStyle& look) {
  session.require(Operation::kTrialViewCoded);
  std::vector<Cells> lines{{"trial", "trainee", "scene", "pattern", "phase", "mode", "station", "started_utc",
                            "duration_s", "end", "model"}};
  TrialRepository repository(session.connection());
  for (const Enrolment& enrolment : StudyRepository(session.connection()).enrolments(cohortId)) {
    const std::vector<TrialListing> newestFirst =
        repository.list({.enrolmentId = enrolment.id, .limit = kAllTrials});
    for (auto trial = newestFirst.rbegin(); trial != newestFirst.rend(); ++trial) {
      lines.push_back({trial->trialId, trial->traineeCode, trial->sceneId, trial->patternId,
                       trial->phaseLabel,
                       trial->attemptMode ? std::string(storedText(*trial->attemptMode)) : std::string(),
                       trial->station, formatUtc(trial->startedUtc_us),
                       trial->summary ? formatExact(spanOf_s(trial->summary->samples)) : std::string(),
                       endOf(*trial), std::string(tissueModelId(trial->model))});
    }
  }
  return write(session, {AuditAction::kTrialExportCoded, AuditObject::kCohort, cohortId}, std::move(lines),
               file, look);
}

std::size_t exportMarks(SessionContext& session, const CohortId& cohortId, const std::filesystem::path& file,
                        const CsvStyle& look) {
  session.require(Operation::kMarkViewCoded);
  std::vector<Cells> lines{{"trainee", "rater", "occasion", "version", "score", "not_assessable", "trial",
                            "submitted_utc", "moved_after_panel", "signature", "signed_by", "signed_utc",
                            "signature_reason", "password_shown_utc", "criteria_mean"}};
  const SheetsOfCohort rubrics(session.connection(), cohortId);
  const std::map<std::string, Signature> signatures =
      SignatureRepository(session.connection()).all(SignedKind::kTrainingMark);
  for (const SubmittedMark& mark : RatingRepository(session.connection()).marks(cohortId)) {
    lines.push_back(
        {mark.traineeCode, mark.raterCode, mark.occasionCode, std::to_string(mark.version),
         mark.score_steps ? formatExact(pointsFromSteps(*mark.score_steps, mark.scale)) : std::string(),
         mark.score_steps ? "no" : "yes", mark.trialId, formatUtc(mark.submittedUtc_us),
         afterPanel(session.connection(), mark) ? "yes" : "no"});
    addSignature(lines.back(), signatures, mark);
    lines.back().push_back(rubrics.meanOf(mark));
  }
  return write(session, {AuditAction::kMarkExportCoded, AuditObject::kCohort, cohortId}, std::move(lines),
               file, look);
}

std::size_t exportCriteria(SessionContext& session, const CohortId& cohortId,
                           const std::filesystem::path& file, const CsvStyle& look) {
  session.require(Operation::kMarkViewCoded);
  SheetsOfCohort sheets(session.connection(), cohortId);
  std::vector<Cells> lines{{"trainee", "rater", "occasion", "version", "rubric", "revision", "criterion",
                            "label", "score", "not_assessable", "submitted_utc", "program"}};
  for (const SubmittedMark& mark : RatingRepository(session.connection()).marks(cohortId)) {
    const RubricRevision* rubric = sheets.rubricOf(mark.assignmentId);
    if (rubric == nullptr) {
      continue;  // entered without a sheet
    }
    const std::vector<SheetRow> answers = sheets.rowsOf(mark.assignmentId);
    for (const RubricLine& line : rubric->rows) {
      const auto answer = std::find_if(answers.begin(), answers.end(),
                                       [&](const SheetRow& one) { return one.code == line.code; });
      if (answer == answers.end()) {
        continue;
      }
      lines.push_back({mark.traineeCode, mark.raterCode, mark.occasionCode, std::to_string(mark.version),
                       sheets.nameOf(*rubric), std::to_string(rubric->number), line.code, line.label,
                       answer->score_steps ? formatExact(pointsFromSteps(*answer->score_steps, line.scale))
                                           : std::string(),
                       answer->score_steps ? "no" : "yes", formatUtc(mark.submittedUtc_us), programHash()});
    }
  }
  return write(session, {AuditAction::kMarkExportCoded, AuditObject::kCohort, cohortId}, std::move(lines),
               file, look);
}

std::size_t exportRubrics(SessionContext& session, const CohortId& cohortId,
                          const std::filesystem::path& file, const CsvStyle& look) {
  session.require(Operation::kMarkViewCoded);
  SheetsOfCohort sheets(session.connection(), cohortId);
  std::vector<Cells> lines{{"rubric", "revision", "criterion", "label", "weight", "lowest", "highest",
                            "anchor", "meaning", "program"}};
  for (const RubricRevision* rubric : sheets.used()) {
    for (const RubricLine& row : rubric->rows) {
      const auto add = [&](const std::string& anchor, const std::string& meaning) {
        lines.push_back({sheets.nameOf(*rubric), std::to_string(rubric->number), row.code, row.label,
                         formatExact(static_cast<double>(row.weight_milli) / 1000.0),
                         formatExact(pointsFromSteps(row.scale.lo, row.scale)),
                         formatExact(pointsFromSteps(row.scale.hi, row.scale)), anchor, meaning,
                         programHash()});
      };
      for (const RubricAnchor& anchor : row.anchors) {
        add(formatExact(pointsFromSteps(anchor.score_steps, row.scale)), anchor.meaning);
      }
      if (row.anchors.empty()) {
        add({}, {});
      }
    }
  }
  return write(session, {AuditAction::kMarkExportCoded, AuditObject::kCohort, cohortId}, std::move(lines),
               file, look);
}

std::size_t exportAuditTrail(SessionContext& session, AuditFilter filter, const std::filesystem::path& file,
                             const CsvStyle& look) {
  session.require(Operation::kAuditView);
  filter.limit = kAllEntries;
  const std::vector<AuditEntry> entries = auditEntries(session, filter);
  const std::map<std::string, std::string> actors = auditActors(session);
  const std::map<std::string, std::string> subjects =
      auditSubjectCodes(session, entries.empty() ? 0 : entries.back().sequence);
  const auto named = [](const std::map<std::string, std::string>& names, const std::string& id) {
    const auto found = names.find(id);
    return found == names.end() ? std::string() : found->second;
  };
  std::vector<Cells> lines{{"sequence", "at_utc", "actor", "actor_id", "station", "action", "object_kind",
                            "object", "object_id", "before", "after", "reason", "entry_hash"}};
  for (const AuditEntry& entry : entries) {
    lines.push_back({std::to_string(entry.sequence), formatUtc(entry.atUtc_us), named(actors, entry.actor),
                     entry.actor, entry.station, entry.action, entry.objectKind,
                     named(subjects, entry.objectId), entry.objectId, entry.oldJson, entry.newJson,
                     entry.reason, entry.entryHash});
  }
  return write(session, {AuditAction::kAuditExport, AuditObject::kAuditEntry}, std::move(lines), file, look);
}

}  // namespace torsio
