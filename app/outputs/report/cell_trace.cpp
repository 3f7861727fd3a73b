// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/outputs/report/cell_trace.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <utility>

#include "app/outputs/report/report_names.h"
#include "app/services/base/assets.h"
#include "app/services/base/csv_table.h"
#include "app/services/recording/trial_digests.h"
#include "app/services/scoring/cohort_inputs.h"
#include "app/services/scoring/scoring_service.h"
#include "assessment/attempt/trial_listing.h"
#include "assessment/domain/rating/assignment.h"
#include "assessment/domain/rating/mark.h"
#include "assessment/domain/rating/rubric.h"
#include "assessment/domain/study/cohort.h"
#include "assessment/results/analysed_cohort.h"
#include "assessment/results/cohort_csv.h"
#include "assessment/results/number_format.h"
#include "db/connection/connection.h"
#include "db/migrations/migrations.h"
#include "db/repository/people/server_roles.h"
#include "db/repository/rating/call_repository.h"
#include "db/repository/rating/evaluation_repository.h"
#include "db/repository/rating/rating_repository.h"
#include "db/repository/rating/rubric_repository.h"
#include "db/repository/rating/sheet_repository.h"
#include "db/repository/study/study_repository.h"
#include "db/repository/trial/trial_repository.h"
#include "sim/core/clock.h"
#include "sim/core/csv_cell.h"
#include "sim/core/error.h"
#include "sim/core/text.h"
#include "sim/scene/hollow_validity.h"
#include "sim/scene/scene.h"

namespace torsio {

namespace {

/// Names a number: "score of T-07, after 40 min".
Text nameOf(const ResultKey& key) {
  std::vector<Text> parts;
  const auto cells = keyCells(key);
  for (std::size_t i = 1; i + 1 < cells.size(); ++i) {
    if (!cells[i].empty() && (i > 1 || !key.of.empty())) {
      parts.emplace_back(cells[i]);
    }
  }
  return parts.empty() ? Text(key.statistic) : Text::tr("%1 of %2", key.statistic, listed(parts));
}

}  // namespace

CohortInputs wholeInputs(Connection& connection, const CohortId& cohortId, const CampaignId& campaignId) {
  const CampaignResult campaign =
      campaignId.empty() ? CampaignResult{} : readCampaign(connection, campaignId);
  CohortInputs inputs = cohortInputs(connection, cohortId, campaign, readTraining(connection, cohortId));
  TrialDigests digests(assetsFolder());
  inputs.trials = digests.read(connection, cohortId, 0);
  const CurriculumVersionId version = StudyRepository(connection).cohort(cohortId).curriculumVersionId;
  inputs.competence = digests.readCompetence(connection, version, inputs.trainees, utcNow_us());
  return inputs;
}

/// Traces a result back to the results and rows of the record that it was calculated from.
class CellTracer::Walk {
 public:
  Walk(Connection& connection, const CohortId& cohortId, const CohortInputs& inputs)
      : connection_(connection),
        cohortId_(cohortId),
        rubrics_(connection),
        sheets_(connection),
        trials_(connection),
        cohort_(analysedCohort(inputs)) {
    for (SubmittedMark& mark : RatingRepository(connection).marks(cohortId)) {
      const MarkId id = mark.id;
      marks_.emplace(id, std::move(mark));
    }
    for (LiveCall& call : CallRepository(connection).calls(cohortId)) {
      if (!call.cancelled) {
        const std::pair key(call.enrolmentId, call.occasionCode);
        calls_[key] = std::move(call);
      }
    }
    for (const Rubric& rubric : rubrics_.rubrics()) {
      rubricNames_[rubric.id] = rubric.name;
    }
    const auto addLine = [this](const Result& result) { lines_.try_emplace(keyAddress(result.key), result); };
    cohort_.ledger.eachLine(addLine);
    std::for_each(cohort_.ledger.every().begin(), cohort_.ledger.every().end(), addLine);  // whole intervals
  }

  /// Traces the result with these cells.
  TraceStep trace(const std::string& cell) {
    const std::vector<CsvRecord> typed = csvRecords(cell, "the cell");
    std::array<std::string, 7> wanted;
    if (typed.size() == 1 && typed.front().values.size() >= wanted.size()) {
      std::copy_n(typed.front().values.begin(), wanted.size(), wanted.begin());
      std::string address;
      for (const std::string& part : wanted) {
        address += (address.empty() ? "" : ",") + csvCell(part);
      }
      if (const auto line = lines_.find(address); line != lines_.end()) {
        TraceStep found = step(line->second);
        if (const std::string& program = cohort_.shown.programHash; !program.empty()) {
          found.madeOf.push_back({Text::tr("program file that computes it (BLAKE2b)"), program});
        }
        return found;
      }
    }
    refuseParameter(Text::verbatim("the table of numbers of this cohort has no such line"), Text(cell),
                    Text::verbatim("Give the first seven cells of a line, from section to statistic"));
  }

 private:
  TraceStep step(const Result& result) {
    TraceStep step{nameOf(result.key), resultText(result.value)};
    if (result.origin == Origin::kPlanned) {
      addRow({RecordKind::kCohortPlan}, step.madeOf);
    }
    for (const ResultPart& part : *result.madeOf) {
      if (const auto* row = std::get_if<RecordRef>(&part)) {
        addRow(*row, step.madeOf);
      } else {
        for (const Result* other : cohort_.ledger.select(std::get<ResultPattern>(part))) {
          step.madeOf.push_back(this->step(*other));
        }
      }
    }
    if (step.madeOf.empty()) {
      step.madeOf.push_back({Text::tr("not shown to you one by one; so many"), std::to_string(result.n)});
    }
    return step;
  }

  void addRow(const RecordRef& row, std::vector<TraceStep>& steps) {
    switch (row.kind) {
      case RecordKind::kMark: {
        const std::vector<TraceStep>& own = markSteps(MarkId(row.id));
        steps.insert(steps.end(), own.begin(), own.end());
        return;
      }
      case RecordKind::kEvaluationMark:
        if (!row.id.empty()) {
          steps.push_back({Text::tr("mark"), row.id});
        }
        return;
      case RecordKind::kRecording:
        steps.push_back(recordingStep(TrialId(row.id)));
        return;
      case RecordKind::kRubricRevision:
        if (const auto rubric = rubrics_.revision(RubricRevisionId(row.id))) {
          steps.push_back({Text::tr("scoring sheet"), titleOf(*rubric)});
        }
        return;
      case RecordKind::kCompetenceDesign:
        steps.push_back({Text::tr("design of the competence verdict"),
                         row.id == "0" ? "shipped with the exercise" : "registered, version " + row.id});
        return;
      case RecordKind::kDeviation:
        steps.push_back({Text::tr("deviation as it was noted"), row.id});
        return;
      case RecordKind::kEnrolments:
        steps.push_back({Text::tr("trainees of the cohort"), std::to_string(cohort_.shown.trainees.size())});
        return;
      case RecordKind::kTrainingTimes:
        steps.push_back({Text::tr("trainees with noted times"), std::to_string(cohort_.shown.doses.size())});
        return;
      case RecordKind::kSheetRequests:
        steps.push_back({Text::tr("scoring sheets that raters were asked for"),
                         std::to_string(sheets_.assignments(cohortId_).size())});
        return;
      case RecordKind::kCampaign:
        steps.push_back({Text::tr("raters who were asked to evaluate the models"),
                         std::to_string(cohort_.shown.evaluationRatersAsked)});
        return;
      case RecordKind::kCohortPlan:
        steps.push_back(
            {Text::tr("planned with the cohort"), StudyRepository(connection_).cohort(cohortId_).name});
        return;
      case RecordKind::kAuditTrail:
        steps.push_back({Text::tr("newest entry of the audit trail"), cohort_.shown.auditHead});
        return;
      case RecordKind::kProgram:
        steps.push_back({Text::tr("program version"), cohort_.shown.softwareVersion});
        return;
    }
  }

  TraceStep recordingStep(const TrialId& trialId) {
    const auto [known, first] = recordings_.try_emplace(trialId);
    TraceStep& step = known->second;
    if (first) {
      const Trial trial = trials_.load(trialId);
      step = {Text::tr("recording"),
              trialId,
              {{Text::tr("content hash"), trial.summary.contentHash},
               {Text::tr("recorded by program version"), trial.header.softwareVersion},
               {Text::tr("device"), trial.header.deviceModel},
               {Text::tr("started"), formatUtc(trial.header.startedUtc_us)},
               {Text::tr("organ"), trial.header.sceneId + ", " + trial.header.organHash},
               {Text::tr("parameters of the model"), trial.header.parameterHash}}};
      for (const OrganWarning& warning : recordedOrganWarnings(trial.header.parametersJson)) {
        step.madeOf.push_back({Text::tr("warning about the organ"), coded(warning).str()});
      }
      for (const Text& confirmed : recordedConfirmations(trial.header.parametersJson)) {
        step.madeOf.push_back({Text::tr("confirmed at the import"), confirmed.str()});
      }
      const std::optional<RecordedValidity> validity = recordedValidity(trial.header.parametersJson);
      if (validity && !validity->beyond.empty()) {
        step.madeOf.push_back({Text::tr("beyond the checked law of the wall"), validity->beyond});
      }
    }
    return step;
  }

  [[nodiscard]] std::string titleOf(const RubricRevision& revision) const {
    return rubricNames_.at(revision.rubricId) + ", revision " + std::to_string(revision.number);
  }

  /// Traces one mark of one rater.
  const std::vector<TraceStep>& markSteps(const MarkId& id) {
    const auto [known, first] = markSteps_.try_emplace(id);
    std::vector<TraceStep>& steps = known->second;
    const auto found = marks_.find(id);
    if (!first || found == marks_.end()) {
      return steps;
    }
    const SubmittedMark* mark = &found->second;
    steps.push_back({Text::tr("mark"), mark->id});
    steps.push_back({Text::tr("version"), std::to_string(mark->version)});
    steps.push_back({Text::tr("submitted at"), formatUtc(mark->submittedUtc_us)});
    if (!mark->assignmentId.empty()) {
      addSheet(*mark, steps);
    }
    if (!mark->trialId.empty()) {
      steps.push_back(recordingStep(mark->trialId));
    } else if (const auto call = calls_.find({mark->enrolmentId, mark->occasionCode}); call != calls_.end()) {
      steps.push_back({Text::tr("seen live"),
                       call->second.room,
                       {{Text::tr("called"), formatUtc(call->second.calledUtc_us)}}});
    }
    return steps;
  }

  void addSheet(const SubmittedMark& mark, std::vector<TraceStep>& steps) {
    const std::optional<AssignmentStatus> asked = sheets_.findAssignment(mark.assignmentId);
    const std::optional<Sheet> sheet = sheets_.submitted(mark.assignmentId);
    if (!asked || !sheet) {
      return;
    }
    const std::optional<RubricRevision> rubric = rubrics_.revision(asked->assignment.rubricRevisionId);
    if (!rubric) {
      return;
    }
    steps.push_back({Text::tr("case"), asked->assignment.caseLabel});
    TraceStep criteria{Text::tr("scoring sheet"), titleOf(*rubric)};
    for (const RubricLine& line : rubric->rows) {
      for (const SheetRow& answer : sheet->rows) {
        if (answer.code != line.code) {
          continue;
        }
        TraceStep criterion{Text::tr("criterion %1", line.label),
                            answer.score_steps ? formatExact(pointsFromSteps(*answer.score_steps, line.scale))
                                               : "not assessable: " + answer.notAssessableReason};
        for (const RubricAnchor& anchor : line.anchors) {
          criterion.madeOf.push_back(
              {Text::tr("anchor %1", formatExact(pointsFromSteps(anchor.score_steps, line.scale))),
               anchor.meaning});
        }
        criteria.madeOf.push_back(std::move(criterion));
      }
    }
    steps.push_back(std::move(criteria));
  }

  Connection& connection_;
  CohortId cohortId_;
  RubricRepository rubrics_;
  SheetRepository sheets_;
  TrialRepository trials_;
  AnalysedCohort cohort_;
  std::map<std::string, Result> lines_;  // by keyAddress()
  std::map<TrialId, TraceStep> recordings_;
  std::map<MarkId, SubmittedMark> marks_;
  std::map<MarkId, std::vector<TraceStep>> markSteps_;
  std::map<std::pair<EnrolmentId, std::string>, LiveCall> calls_;
  std::map<RubricId, std::string> rubricNames_;
};

CellTracer::CellTracer(Connection& connection, const CohortId& cohortId, const CohortInputs& inputs)
    : walk_(std::make_unique<Walk>(connection, cohortId, inputs)) {}
CellTracer::~CellTracer() = default;

TraceStep CellTracer::trace(const std::string& cell) {
  return walk_->trace(cell);
}

TraceStep traceCell(const TraceRequest& request) {
  Connection connection = openRecord(request.record, OpenMode::kReadOnly);
  requireEveryRow(connection);
  const CohortId cohort = cohortNamed(connection, request.cohort);
  const CohortInputs inputs = wholeInputs(connection, cohort, campaignNamed(connection, request.campaign));
  return CellTracer(connection, cohort, inputs).trace(request.cell);
}

TraceStep traceNumber(SessionContext& session, const CohortId& cohortId, const CohortInputs& inputs,
                      const std::string& cell) {
  session.require(Operation::kResultsCompute);
  return CellTracer(session.connection(), cohortId, inputs).trace(cell);
}

}  // namespace torsio
