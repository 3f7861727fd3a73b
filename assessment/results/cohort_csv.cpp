// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/results/cohort_csv.h"

#include <algorithm>
#include <optional>
#include <string>

#include "assessment/results/aggregated_inputs.h"
#include "assessment/results/analysed_cohort.h"
#include "assessment/results/analysis_tables.h"
#include "assessment/results/csv_rows.h"
#include "assessment/results/number_format.h"
#include "assessment/results/report_sections.h"
#include "assessment/results/shown_inputs.h"
#include "assessment/statistics/descriptive.h"
#include "sim/core/csv_cell.h"

namespace torsio {

namespace {

void addStatistics(CsvRows& rows, const ScoreStatistics& s) {
  rows.add("M", s.m, s.n);
  rows.add("s2_eq26_divisor_n", s.s2, s.n);
  rows.add("min", s.min, s.n);
  rows.add("max", s.max, s.n);
  rows.add("plain_mean", s.plainMean, s.n);
  rows.add("population_variance", s.populationVariance, s.n);
  rows.add("sample_variance", s.sampleVariance, s.n);
  rows.add("class_weighted_moment", s.classWeightedMoment, s.n);
  rows.add("se_of_M", s.standardError, s.n);
  rows.add("se_df", s.standardErrorDf, s.n);
}

void addMarks(const CohortInputs& in, const ModelRatings& ratings, CsvRows& rows) {
  for (const RaterSheet& sheet : ratings.sheets) {
    for (std::size_t j = 0; j < sheet.steps.size(); ++j) {
      rows.place.item = sheet.rater;
      rows.place.group = in.instrument.classes[sheet.raterClass].id;
      rows.place.index = in.instrument.indices[j].id;
      std::optional<double> mark;
      if (sheet.steps[j]) {
        mark = pointsFromSteps(*sheet.steps[j], in.instrument.scale);
      }
      rows.add("mark", mark, mark ? 1 : 0);
    }
  }
}

/// How the raters order the models.
void addModelOrder(const CohortInputs& in, std::vector<CohortCsvRow>& out) {
  const std::optional<ModelOrder> order = modelOrder(in);
  if (!order) {
    return;
  }
  CsvRows rows(out);
  rows.place.section = "evaluation";
  rows.place.item = "all";
  rows.place.flags = csvFlags(commonFlags(in), {});
  const Outcome<Friedman>& test = order->test;
  const std::int64_t n = order->raters;
  rows.add("models_friedman_chi_squared", test ? std::optional(test->chiSquared) : std::nullopt, n);
  rows.add("models_friedman_p", test ? std::optional(test->p) : std::nullopt, n);
  rows.add("models_kendall_w", test ? std::optional(test->kendallW) : std::nullopt, n);
  for (std::size_t k = 0; k < order->meanRanks.size(); ++k) {
    rows.place.model = in.evaluations[k].model;
    rows.add("mean_rank", order->meanRanks[k], n);
  }
}

/// What is there while a class of raters has not scored everything.
void addUnfinishedEvaluation(const CohortInputs& in, std::vector<CohortCsvRow>& out) {
  CsvRows rows(out);
  rows.place.section = "evaluation";
  rows.place.flags = csvFlags(commonFlags(in), {"unfinished"});
  for (const ModelRatings& ratings : in.ratings) {
    rows.place.model = ratings.model;
    addMarks(in, ratings, rows);
  }
  rows.place.item = "all";
  rows.place.index.clear();
  for (const ClassScore& of : classScores(in)) {
    rows.place.model = of.model;
    rows.place.group = in.instrument.classes[of.raterClass].id;
    rows.add(kClassScoreStatistic, of.score, of.raters);
  }
}

void addEvaluation(const CohortInputs& in, std::vector<CohortCsvRow>& out) {
  if (in.unfinishedEvaluation) {
    addUnfinishedEvaluation(in, out);
    return;
  }
  const std::vector<Text> common = commonFlags(in);
  for (std::size_t k = 0; k < in.evaluations.size(); ++k) {
    const ModelEvaluation& model = in.evaluations[k];
    CsvRows rows(out);
    rows.place.section = "evaluation";
    rows.place.item = "all";
    rows.place.model = model.model;
    rows.place.flags = csvFlags(common, model.flags);
    rows.add("N_eq27", model.n27, std::ssize(model.composites));
    for (std::size_t j = 0; j < model.indices.size(); ++j) {
      rows.place.index = in.instrument.indices[j].id;
      rows.place.flags = csvFlags(common, model.indices[j].flags);
      addStatistics(rows, model.indices[j]);
    }
    rows.place.index.clear();
    for (const RaterComposite& composite : model.composites) {
      rows.place.item = composite.rater;
      rows.place.group = in.instrument.classes[composite.raterClass].id;
      rows.place.flags = csvFlags(common, {});
      rows.add("composite", composite.score, composite.score ? 1 : 0);
    }
    addMarks(in, in.ratings[k], rows);
  }
  addModelOrder(in, out);
}

std::int64_t marksAt(const CohortInputs& in, std::size_t group, std::size_t occasion) {
  return std::count_if(in.trainingMarks.begin(), in.trainingMarks.end(), [&](const TrainingMark& mark) {
    return mark.group == group && mark.occasion == occasion;
  });
}

void addTraining(const CohortInputs& in, std::vector<CohortCsvRow>& out) {
  CsvRows rows(out);
  rows.place.section = "training";
  rows.place.flags = csvFlags(commonFlags(in), {});
  for (const GroupSummary& s : in.summaries) {
    rows.place.item = "all";
    rows.place.group = in.groups[s.group].name.str();
    rows.place.occasion = in.occasions[s.occasion].str();
    rows.addInterval("mean", s.mean, meanInterval(scoresOf(in, s.group, s.occasion)), s.trainees);
    rows.add("median", s.median, s.trainees);
    rows.add("min", s.min, s.trainees);
    rows.add("max", s.max, s.trainees);
    rows.add("variance_of_scores_divisor_n", s.varianceOfScores, s.trainees);
    rows.add("variance_of_scores_divisor_n_minus_1", s.sampleVarianceOfScores, s.trainees);
    rows.add("variance_of_all_marks_divisor_n", s.varianceOfMarks, s.marks);
    rows.add("mean_between_rater_variance_divisor_n_minus_1", s.meanBetweenRaterVariance, s.marks);
  }
  const std::vector<std::vector<std::int64_t>> missing = missingByGroup(in);
  for (std::size_t g = 0; g < missing.size() && !in.trainingMarks.empty(); ++g) {
    for (std::size_t t = 0; t < missing[g].size(); ++t) {
      rows.place.item = "all";
      rows.place.group = in.groups[g].name.str();
      rows.place.occasion = in.occasions[t].str();
      rows.add("marks_missing_at_occasion", static_cast<double>(missing[g][t]), marksAt(in, g, t));
    }
  }
  for (const TraineeScore& score : in.scores) {
    rows.place.item = score.trainee;
    rows.place.group = in.groups[score.group].name.str();
    rows.place.occasion = in.occasions[score.occasion].str();
    rows.add("score", score.score, score.n);
  }
  for (const TrainingMark& mark : in.trainingMarks) {
    rows.place.item = mark.trainee;
    rows.place.group = in.groups[mark.group].name.str();
    rows.place.index = mark.rater;
    rows.place.occasion = in.occasions[mark.occasion].str();
    rows.add("rater_mark", pointsFromSteps(mark.steps, in.trainingScale), 1);
  }
}

void addTrials(const CohortInputs& in, std::vector<CohortCsvRow>& out) {
  CsvRows rows(out);
  rows.place.section = "trial";
  for (const TrialSummaryRow& trial : in.trials) {
    rows.place.item = trial.trainee;
    rows.place.group = in.groups[trial.group].name.str();
    rows.place.model = trial.model;
    rows.place.occasion = trial.phase.str();
    rows.place.flags = csvFlags(commonFlags(in), trial.interrupted ? std::vector<std::string>{"interrupted"}
                                                                   : std::vector<std::string>{});
    rows.add("minutes", trial.minutes, trial.samples);
    if (trial.detorsion.empty()) {
      rows.add("twists", static_cast<double>(trial.twists), trial.samples);
      rows.add("twists_not_completed", static_cast<double>(trial.unfinishedTwists), trial.samples);
      rows.add("twists_on_target", static_cast<double>(trial.twistsOnTarget), trial.twists);
      rows.add("mean_absolute_error_deg", trial.meanAbsoluteError_deg, trial.twists);
      rows.add("peak_torque_Nm", trial.peakTorque_Nm, trial.samples);
      rows.add("peak_force_N", trial.peakForce_N, trial.samples);
      rows.add("peak_device_force_N", trial.peakDeviceForce_N, trial.samples);
    }
    rows.add("refused_samples", static_cast<double>(trial.refusedSamples), trial.samples);
    if (trial.forceCuts > 0) {
      rows.add("force_cuts", static_cast<double>(trial.forceCuts), trial.samples);
    }
    for (std::size_t i = 0; i < trial.attempts.size(); ++i) {
      rows.place.index = std::to_string(i + 1);
      rows.add("twist_error_deg", trial.attempts[i].error_deg, 1);
    }
    rows.place.index.clear();
    for (const auto& [metric, value] : trial.detorsion) {
      rows.add(metric, value, trial.samples);
    }
    rows.addText("trial", trial.trialId, trial.samples);
    rows.addText("content_hash", trial.contentHash, trial.samples);
  }
}

void addCompetence(const CohortInputs& in, std::vector<CohortCsvRow>& out) {
  CsvRows rows(out);
  rows.place.section = "competence";
  for (const CohortCompetence& one : in.competence) {
    rows.place.item = one.trainee;
    rows.place.group = in.groups[one.group].name.str();
    rows.place.index = one.exercise.str();
    rows.place.flags =
        csvFlags(commonFlags(in), one.designVersion > 0
                                      ? std::vector<std::string>{}
                                      : std::vector<std::string>{"design shipped with the exercise"});
    rows.addText("level", one.level.str(), one.attempts);
    rows.add("failed", static_cast<double>(one.failed), one.attempts);
    rows.add("able", one.able ? 1.0 : 0.0, one.attempts);
    if (one.ableAt) {
      rows.add("able_at_attempt", static_cast<double>(*one.ableAt), one.attempts);
    }
    rows.add("false_pass", one.falsePass, one.withinAttempts);
    rows.add("false_fail", one.falseFail, one.withinAttempts);
    rows.add("false_alarm", one.falseAlarm, one.withinAttempts);
    rows.add("within_attempts", static_cast<double>(one.withinAttempts), one.attempts);
    rows.add("design_version", static_cast<double>(one.designVersion), one.attempts);
  }
}

void addDeviations(const CohortInputs& in, std::vector<CohortCsvRow>& out) {
  CsvRows rows(out);
  rows.place.section = "deviation";
  rows.place.flags = csvFlags(commonFlags(in), {});
  for (const CohortDeviation& deviation : in.deviations) {
    rows.place.item = deviation.trainee.empty() ? "all" : deviation.trainee;
    rows.place.occasion = formatUtc(deviation.happenedUtc_us);
    rows.addText(deviation.kind, deviation.description, 1);
  }
}

/// What an aggregated table may hold: summaries over at least kSmallestCell.
bool isAggregate(const CohortCsvRow& row) {
  if (row.section == "scoring_sheet" || row.section == "record") {
    return true;
  }
  if (row.item != "all" || row.section == "deviation" || row.section == "trial") {
    return false;
  }
  return row.section == "evaluation" || std::stoll(row.n) >= kSmallestCell;
}

}  // namespace

std::string numberAddress(const CohortCsvRow& row) {
  std::string address;
  for (const std::string* field :
       {&row.section, &row.item, &row.group, &row.model, &row.index, &row.occasion, &row.statistic}) {
    address += (field == &row.section ? "" : ",") + csvCell(*field);
  }
  return address;
}

AnalysedCohort analysedCohort(const CohortInputs& inputs) {
  AnalysedCohort made;
  made.shown = shownInputs(inputs, made.left);
  if (inputs.identity == ReportIdentity::kAggregated) {
    made.shown = withoutSmallGroups(made.shown, made.left);
  }
  if (!made.shown.trainingMarks.empty()) {
    made.study = analyseStudy(made.shown);
  }
  made.rows = csvRowsOf(inputs, made.shown, made.study);
  return made;
}

std::vector<CohortCsvRow> cohortCsvRows(const CohortInputs& inputs) {
  return analysedCohort(inputs).rows;
}

std::vector<CohortCsvRow> csvRowsOf(const CohortInputs& inputs, const CohortInputs& in,
                                    const std::optional<StudyAnalysis>& study) {
  std::vector<CohortCsvRow> rows;
  addEvaluation(in, rows);
  addTraining(in, rows);
  addCriteriaRows(in, rows);
  if (study) {
    addStudyRows(in, *study, rows);
  }
  addTrials(in, rows);
  addCompetence(in, rows);
  addDeviations(in, rows);
  if (inputs.sheetsAsked > inputs.sheetsPresent) {
    CsvRows sheets(rows);
    sheets.place.section = "training";
    sheets.place.item = "all";
    sheets.place.flags = csvFlags(commonFlags(in), {});
    sheets.add("sheets_asked", static_cast<double>(inputs.sheetsAsked), inputs.sheetsAsked);
    sheets.add("sheets_present", static_cast<double>(inputs.sheetsPresent), inputs.sheetsAsked);
  }
  if (!in.auditHead.empty()) {
    CsvRows record(rows);
    record.place.section = "record";
    record.place.item = "audit_trail";
    record.place.flags = formatUtc(in.createdUtc_us);
    record.addText("head", in.auditHead, in.auditEntries);
  }
  if (!in.programHash.empty()) {
    CsvRows record(rows);
    record.place.section = "record";
    record.place.item = "program";
    record.place.model = in.softwareVersion;
    record.addText("file_blake2b", in.programHash, 1);
  }
  if (!inputs.singleMarks) {
    std::erase_if(rows, [](const CohortCsvRow& row) {
      return row.statistic == "mark" || row.statistic == "rater_mark" || row.statistic == "criterion_mark";
    });
  }
  if (inputs.identity == ReportIdentity::kAggregated) {
    std::erase_if(rows, [](const CohortCsvRow& row) { return !isAggregate(row); });
  }
  return rows;
}

std::string cohortCsvText(const std::vector<CohortCsvRow>& rows) {
  std::string text = "section,item,group,model,index,occasion,statistic,value,n,flags\r\n";
  for (const CohortCsvRow& row : rows) {
    bool first = true;
    for (const std::string* field : {&row.section, &row.item, &row.group, &row.model, &row.index,
                                     &row.occasion, &row.statistic, &row.value, &row.n, &row.flags}) {
      if (!first) {
        text += ',';
      }
      first = false;
      appendCsvCell(text, *field);
    }
    text += "\r\n";
  }
  return text;
}

}  // namespace torsio
