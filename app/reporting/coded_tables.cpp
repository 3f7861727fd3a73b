// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/reporting/coded_tables.h"

#include <vector>

#include <nlohmann/json.hpp>

#include "app/base/csv_table.h"
#include "assessment/attempt/trial_listing.h"
#include "assessment/rating/mark.h"
#include "assessment/report/number_format.h"
#include "assessment/study/cohort.h"
#include "assessment/study/protocol_terms.h"
#include "db/repository/rating/rating_repository.h"
#include "db/repository/study/study_repository.h"
#include "db/repository/trial/trial_repository.h"
#include "sim/base/digest.h"
#include "sim/base/file_io.h"
#include "sim/base/ids.h"
#include "sim/base/tick_period.h"

namespace torsio {

namespace {

using Cells = std::vector<std::string>;

constexpr std::int64_t kAllTrials = 1'000'000;

/// Keeps in the audit trail what leaves, then writes it: a trace of a file that could not be written is
/// better than data that left without a trace.
std::size_t write(SessionContext& session, AuditAction action, const CohortId& cohortId,
                  const std::vector<Cells>& lines, const std::filesystem::path& file) {
  std::string text = "\xEF\xBB\xBF";
  for (const Cells& cells : lines) {
    text += csvLine(cells);
  }
  Digest digest;
  digest.update(text);
  const std::size_t rows = lines.size() - 1;
  session.note({.action = action,
                .objectKind = AuditObject::kCohort,
                .objectId = cohortId,
                .newJson = nlohmann::json{{"rows", rows}, {"blake2b", digest.hex()}}.dump()});
  writeFileAtomically(file, text);
  return rows;
}

std::string endOf(const TrialListing& trial) {
  if (!trial.summary) {
    return "open";
  }
  return trial.summary->outcome == TrialOutcome::kCompleted ? "completed" : "interrupted";
}

}  // namespace

std::size_t exportRecordings(SessionContext& session, const CohortId& cohortId,
                             const std::filesystem::path& file) {
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
  return write(session, AuditAction::kTrialExportCoded, cohortId, lines, file);
}

std::size_t exportMarks(SessionContext& session, const CohortId& cohortId,
                        const std::filesystem::path& file) {
  session.require(Operation::kMarkViewCoded);
  std::vector<Cells> lines{
      {"trainee", "rater", "occasion", "version", "score", "not_assessable", "trial", "submitted_utc"}};
  for (const SubmittedMark& mark : RatingRepository(session.connection()).marks(cohortId)) {
    lines.push_back(
        {mark.traineeCode, mark.raterCode, mark.occasionCode, std::to_string(mark.version),
         mark.score_steps ? formatExact(pointsFromSteps(*mark.score_steps, mark.scale)) : std::string(),
         mark.score_steps ? "no" : "yes", mark.trialId, formatUtc(mark.submittedUtc_us)});
  }
  return write(session, AuditAction::kMarkExportCoded, cohortId, lines, file);
}

}  // namespace torsio
