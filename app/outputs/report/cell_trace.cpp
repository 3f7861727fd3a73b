// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/outputs/report/cell_trace.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <utility>

#include "app/outputs/report/report_names.h"
#include "app/services/base/assets.h"
#include "app/services/base/csv_table.h"
#include "app/services/recording/trial_digests.h"
#include "app/services/scoring/cohort_inputs.h"
#include "app/services/scoring/cohort_occasions.h"
#include "app/services/scoring/scoring_service.h"
#include "assessment/attempt/trial_listing.h"
#include "assessment/domain/rating/assignment.h"
#include "assessment/domain/rating/live_call.h"
#include "assessment/domain/rating/mark.h"
#include "assessment/domain/rating/rubric.h"
#include "assessment/domain/study/cohort.h"
#include "assessment/domain/study/occasion.h"
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
#include "sim/core/error.h"
#include "sim/core/text.h"
#include "sim/scene/scene.h"

namespace torsio {

namespace {

using Row = CohortCsvRow;

std::array<std::string, 7> addressOf(const Row& row) {
  return {row.section, row.item, row.group, row.model, row.index, row.occasion, row.statistic};
}

/// "score of T-07, after 40 min".
Text nameOf(const Row& row) {
  std::vector<Text> parts;
  for (const std::string* part : {&row.item, &row.group, &row.model, &row.index, &row.occasion}) {
    if (!part->empty() && *part != "all") {
      parts.emplace_back(*part);
    }
  }
  return parts.empty() ? Text(row.statistic) : Text::tr("%1 of %2", row.statistic, listed(parts));
}

/// A report with names says "T-07 Li Na" where the record says "T-07".
std::string codeOf(const std::string& item) {
  return item.substr(0, item.find(' '));
}

/// What the command line follows: everything, under codes.
CohortInputs wholeInputs(Connection& connection, const CohortId& cohortId, const CampaignId& campaignId) {
  const CampaignResult campaign =
      campaignId.empty() ? CampaignResult{} : readCampaign(connection, campaignId);
  CohortInputs inputs = cohortInputs(connection, cohortId, campaign, readTraining(connection, cohortId));
  inputs.trials = TrialDigests(assetsFolder()).read(connection, cohortId, 0);
  return inputs;
}

/// Walks from a row of the table to the rows and the rows of the record that it was made of.
class Tracer {
 public:
  Tracer(Connection& connection, const CohortId& cohortId, const CohortInputs& inputs)
      : rubrics_(connection),
        sheets_(connection),
        trials_(connection),
        rows_(cohortCsvRows(inputs)),
        program_(inputs.programHash) {
    const Occasions occasions = occasionsOfCohort(connection, cohortId);
    const std::vector<Text> names = occasionTexts(occasions);
    for (std::size_t i = 0; i < names.size(); ++i) {
      occasionCode_[names[i].str()] = occasions.at(i).code;
    }
    marks_ = RatingRepository(connection).marks(cohortId);
    for (LiveCall& call : CallRepository(connection).calls(cohortId)) {
      if (!call.cancelled) {
        const std::pair key(call.enrolmentId, call.occasionCode);
        calls_[key] = std::move(call);
      }
    }
    for (const Rubric& rubric : rubrics_.rubrics()) {
      rubricNames_[rubric.id] = rubric.name;
    }
  }

  TraceStep trace(const std::string& cell) {
    const std::vector<CsvRecord> typed = csvRecords(cell, "the cell");
    std::array<std::string, 7> wanted;
    if (typed.size() == 1 && typed.front().values.size() >= wanted.size()) {
      std::copy_n(typed.front().values.begin(), wanted.size(), wanted.begin());
      for (const Row& row : rows_) {
        if (numberAddress(row) == cell || addressOf(row) == wanted) {
          TraceStep found = step(row);
          if (!program_.empty()) {
            found.madeOf.push_back({Text::tr("program file that computes it (BLAKE2b)"), program_});
          }
          return found;
        }
      }
    }
    refuseParameter(Text::verbatim("the table of numbers of this cohort has no such line"), Text(cell),
                    Text::verbatim("Give the first seven cells of a line, from section to statistic"));
  }

 private:
  using Wanted = std::function<bool(const Row&)>;

  void addAll(TraceStep& step, const Wanted& wanted) {
    for (const Row& row : rows_) {
      if (wanted(row)) {
        step.madeOf.push_back(this->step(row));
      }
    }
  }

  TraceStep step(const Row& row) {
    TraceStep step{nameOf(row), row.value};
    const auto same = [&](const char* section, const char* statistic) {
      return [section, statistic](const Row& other) {
        return other.section == section && other.statistic == statistic;
      };
    };
    if (row.statistic == "rater_mark" || row.statistic == "criterion_mark") {
      step.madeOf = markSteps(row);
    } else if (row.section == "criterion") {
      addAll(step, [&, is = same("criterion", row.item == "all" ? "criterion_mean" : "criterion_mark")](
                       const Row& other) {
        return is(other) && other.item != "all" && (row.item == "all" || other.item == row.item) &&
               other.group == row.group && other.model == row.model && other.occasion == row.occasion;
      });
    } else if (row.section == "training" && row.statistic == "score") {
      addAll(step, [&, is = same("training", "rater_mark")](const Row& other) {
        return is(other) && other.item == row.item && other.occasion == row.occasion;
      });
    } else if (row.section == "training") {
      addAll(step, [&, is = same("training", "score")](const Row& other) {
        return is(other) && other.group == row.group && other.occasion == row.occasion;
      });
    } else if (row.section == "agreement" || row.section == "comparison") {
      addAll(step, [&, is = same("training", "score")](const Row& other) {
        return is(other) &&
               (row.occasion.empty() || row.section == "comparison" || other.occasion == row.occasion);
      });
    } else if (row.section == "evaluation" && row.statistic == "N_eq27") {
      addAll(step, [&, is = same("evaluation", "composite")](const Row& other) {
        return is(other) && other.model == row.model;
      });
    } else if (row.section == "evaluation" && row.statistic != "mark") {
      addAll(step, [&, is = same("evaluation", "mark")](const Row& other) {
        return is(other) && other.model == row.model && (row.item == "all" || other.item == row.item) &&
               (row.group.empty() || other.group == row.group) &&
               (row.index.empty() || other.index == row.index);
      });
    } else if (row.section == "trial" && row.statistic != "trial") {
      addAll(step, [&, is = same("trial", "trial")](const Row& other) {
        return is(other) && other.item == row.item && other.occasion == row.occasion;
      });
    } else if (row.section == "trial") {
      step.madeOf.push_back(recordingStep(row.value));
    }
    if (step.madeOf.empty() && (row.section == "training" || row.section == "criterion")) {
      step.madeOf.push_back({Text::tr("not shown to you one by one; so many"), row.n});
    }
    return step;
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
    }
    return step;
  }

  /// What stands behind one mark of one rater.
  std::vector<TraceStep> markSteps(const Row& row) {
    const auto mark = std::find_if(marks_.begin(), marks_.end(), [&](const SubmittedMark& one) {
      return one.traineeCode == codeOf(row.item) && one.raterCode == row.index &&
             one.occasionCode == occasionCode_[row.occasion];
    });
    if (mark == marks_.end()) {
      return {};
    }
    std::vector<TraceStep> steps{{Text::tr("mark"), mark->id},
                                 {Text::tr("version"), std::to_string(mark->version)},
                                 {Text::tr("submitted"), formatUtc(mark->submittedUtc_us)}};
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
    TraceStep criteria{Text::tr("scoring sheet"),
                       rubricNames_[rubric->rubricId] + ", revision " + std::to_string(rubric->number)};
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

  RubricRepository rubrics_;
  SheetRepository sheets_;
  TrialRepository trials_;
  std::vector<Row> rows_;
  std::string program_;
  std::map<TrialId, TraceStep> recordings_;
  std::vector<SubmittedMark> marks_;
  std::map<std::string, std::string> occasionCode_;  // by its name in the table
  std::map<std::pair<EnrolmentId, std::string>, LiveCall> calls_;
  std::map<RubricId, std::string> rubricNames_;
};

}  // namespace

TraceStep traceCell(const TraceRequest& request) {
  Connection connection = openRecord(request.record, OpenMode::kReadOnly);
  requireEveryRow(connection);
  const CohortId cohort = cohortNamed(connection, request.cohort);
  const CohortInputs inputs = wholeInputs(connection, cohort, campaignNamed(connection, request.campaign));
  return Tracer(connection, cohort, inputs).trace(request.cell);
}

TraceStep traceNumber(SessionContext& session, const CohortId& cohortId, const CohortInputs& inputs,
                      const std::string& cell) {
  session.require(Operation::kResultsCompute);
  return Tracer(session.connection(), cohortId, inputs).trace(cell);
}

}  // namespace torsio
