// SPDX-License-Identifier: GPL-3.0-or-later
// Fills the ledger of a cohort. study_results.cpp adds the results about raters and groups,
// criteria_section.cpp those about criteria.
#include <algorithm>
#include <optional>
#include <string>

#include "assessment/results/aggregated_inputs.h"
#include "assessment/results/analysed_cohort.h"
#include "assessment/results/analysis_tables.h"
#include "assessment/results/number_format.h"
#include "assessment/results/report_sections.h"
#include "assessment/results/result_writer.h"
#include "assessment/results/shown_inputs.h"
#include "assessment/statistics/descriptive.h"
#include "sim/core/text.h"

namespace torsio {

namespace {

using enum ResultSection;

void addStatistics(ResultWriter& rows, const ScoreStatistics& s) {
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

void addMarks(const CohortInputs& in, const ModelRatings& ratings, ResultWriter& rows) {
  rows.place.model = ratings.model;
  for (const RaterSheet& sheet : ratings.sheets) {
    rows.place.of = sheet.rater;
    rows.place.raterClass = in.instrument.classes[sheet.raterClass].id;
    for (std::size_t j = 0; j < sheet.steps.size(); ++j) {
      rows.place.index = in.instrument.indices[j].id;
      rows.madeOf = partsOf({RecordRef{RecordKind::kEvaluationMark, sheet.markOf(j)}});
      std::optional<double> mark;
      if (sheet.steps[j]) {
        mark = pointsFromSteps(*sheet.steps[j], in.instrument.scale);
      }
      rows.add("mark", mark, mark ? 1 : 0);
    }
  }
}

/// Adds the raters' order of the models.
void addModelOrder(const CohortInputs& in, Ledger& ledger) {
  const std::optional<ModelOrder> order = modelOrder(in);
  if (!order) {
    return;
  }
  ResultWriter rows(ledger, {.section = kEvaluation}, commonFlags(in));
  rows.madeOf = partsOf({ResultPattern{.section = kEvaluation, .statistic = "composite", .of = kEach}});
  const std::int64_t n = order->raters;
  rows.add("models_friedman_chi_squared", order->test, &Friedman::chiSquared, n);
  rows.add("models_friedman_p", order->test, &Friedman::p, n);
  rows.add("models_kendall_w", order->test, &Friedman::kendallW, n);
  for (std::size_t k = 0; k < order->meanRanks.size(); ++k) {
    rows.place.model = in.evaluations[k].model;
    rows.add("mean_rank", order->meanRanks[k], n);
  }
}

/// Adds what is available before a class of raters has scored everything.
void addUnfinishedEvaluation(const CohortInputs& in, Ledger& ledger) {
  ResultWriter marks(ledger, {.section = kEvaluation}, commonFlags(in), {"unfinished"});
  for (const ModelRatings& ratings : in.ratings) {
    addMarks(in, ratings, marks);
  }
  ResultWriter rows(ledger, {.section = kEvaluation}, commonFlags(in), {"unfinished"});
  for (const ClassScore& of : classScores(in)) {
    rows.place.model = of.model;
    rows.place.raterClass = in.instrument.classes[of.raterClass].id;
    rows.madeOf = partsOf({ResultPattern{.section = kEvaluation,
                                         .statistic = "mark",
                                         .of = kEach,
                                         .raterClass = rows.place.raterClass,
                                         .model = of.model},
                           RecordRef{RecordKind::kCampaign}});
    rows.add(kClassScoreStatistic, of.score, of.raters);
  }
}

void addEvaluation(const CohortInputs& in, Ledger& ledger) {
  if (in.unfinishedEvaluation) {
    addUnfinishedEvaluation(in, ledger);
    return;
  }
  for (std::size_t k = 0; k < in.evaluations.size(); ++k) {
    const ModelEvaluation& model = in.evaluations[k];
    ResultWriter rows(ledger, {.section = kEvaluation, .model = model.model}, commonFlags(in), model.flags);
    rows.madeOf = partsOf({ResultPattern{.section = kEvaluation, .statistic = "M", .model = model.model}});
    rows.add("N_eq27", model.n27, std::ssize(model.composites));
    for (std::size_t j = 0; j < model.indices.size(); ++j) {
      rows.place.index = in.instrument.indices[j].id;
      rows.setFlags(model.indices[j].flags);
      rows.madeOf = partsOf({ResultPattern{.section = kEvaluation,
                                           .statistic = "mark",
                                           .of = kEach,
                                           .model = model.model,
                                           .index = rows.place.index}});
      addStatistics(rows, model.indices[j]);
    }
    rows.place.index.clear();
    rows.setFlags({});
    for (const RaterComposite& composite : model.composites) {
      rows.place.of = composite.rater;
      rows.place.raterClass = in.instrument.classes[composite.raterClass].id;
      rows.madeOf = partsOf({ResultPattern{
          .section = kEvaluation, .statistic = "mark", .of = composite.rater, .model = model.model}});
      rows.add("composite", composite.score, composite.score ? 1 : 0);
    }
    addMarks(in, in.ratings[k], rows);
  }
  addModelOrder(in, ledger);
}

std::int64_t marksAt(const CohortInputs& in, std::size_t group, std::size_t occasion) {
  return std::count_if(in.trainingMarks.begin(), in.trainingMarks.end(), [&](const TrainingMark& mark) {
    return mark.group == group && mark.occasion == occasion;
  });
}

void addSummaries(const CohortInputs& in, ResultWriter& rows) {
  for (const GroupSummary& s : in.summaries) {
    rows.place.group = s.group;
    rows.place.occasion = s.occasion;
    rows.madeOf =
        partsOf({ResultPattern{.statistic = "score", .of = kEach, .group = s.group, .occasion = s.occasion}});
    const std::vector<double> scores = scoresOf(in, s.group, s.occasion);
    rows.addInterval("mean", s.mean, meanInterval(scores), s.trainees);
    rows.add("median", s.median, s.trainees);
    rows.add("min", s.min, s.trainees);
    rows.add("max", s.max, s.trainees);
    rows.add("variance_of_scores_divisor_n", s.varianceOfScores, s.trainees);
    rows.add("variance_of_scores_divisor_n_minus_1", s.sampleVarianceOfScores, s.trainees);
    rows.madeOf = partsOf(
        {ResultPattern{.statistic = "rater_mark", .of = kEach, .group = s.group, .occasion = s.occasion}});
    rows.add("variance_of_all_marks_divisor_n", s.varianceOfMarks, s.marks);
    rows.add("mean_between_rater_variance_divisor_n_minus_1", s.meanBetweenRaterVariance, s.marks);
  }
  if (in.trainingMarks.empty()) {
    return;
  }
  const std::vector<std::vector<std::int64_t>> missing = missingByGroup(in);
  for (std::size_t g = 0; g < missing.size(); ++g) {
    for (std::size_t t = 0; t < missing[g].size(); ++t) {
      rows.place.group = g;
      rows.place.occasion = t;
      rows.madeOf = partsOf({ResultPattern{.statistic = "rater_mark", .of = kEach, .group = g, .occasion = t},
                             RecordRef{RecordKind::kEnrolments}});
      rows.addCount("marks_missing_at_occasion", missing[g][t], marksAt(in, g, t));
    }
  }
}

void addTraining(const CohortInputs& in, Ledger& ledger) {
  ResultWriter rows(ledger, {.section = kTraining}, commonFlags(in));
  addSummaries(in, rows);
  for (const TraineeScore& score : in.scores) {
    rows.place.of = score.trainee;
    rows.place.group = score.group;
    rows.place.occasion = score.occasion;
    rows.madeOf =
        partsOf({ResultPattern{.statistic = "rater_mark", .of = score.trainee, .occasion = score.occasion}});
    rows.add("score", score.score, score.n);
  }
  for (const TrainingMark& mark : in.trainingMarks) {
    rows.place.of = mark.trainee;
    rows.place.group = mark.group;
    rows.place.index = mark.rater;
    rows.place.occasion = mark.occasion;
    rows.madeOf = partsOf({RecordRef{RecordKind::kMark, mark.id}});
    rows.add("rater_mark", pointsFromSteps(mark.steps, in.trainingScale), 1);
  }
}

void addTrials(const CohortInputs& in, Ledger& ledger) {
  for (const TrialSummaryRow& trial : in.trials) {
    ResultWriter rows(
        ledger, trialKey(trial), commonFlags(in),
        trial.interrupted ? std::vector<std::string>{"interrupted"} : std::vector<std::string>{});
    rows.madeOf = partsOf({RecordRef{RecordKind::kRecording, trial.trialId.text()}});
    rows.add("minutes", trial.minutes, trial.samples);
    if (trial.detorsion.empty()) {
      rows.addCount("twists", trial.twists, trial.samples);
      rows.addCount("twists_not_completed", trial.unfinishedTwists, trial.samples);
      rows.addCount("twists_on_target", trial.twistsOnTarget, trial.twists);
      rows.add("mean_absolute_error_deg", trial.meanAbsoluteError_deg, trial.twists);
      rows.add("peak_torque_Nm", trial.peakTorque_Nm, trial.samples);
      rows.add("peak_force_N", trial.peakForce_N, trial.samples);
      rows.add("peak_device_force_N", trial.peakDeviceForce_N, trial.samples);
    }
    rows.addCount("refused_samples", trial.refusedSamples, trial.samples);
    if (trial.forceCuts > 0) {
      rows.addCount("force_cuts", trial.forceCuts, trial.samples);
    }
    for (const JudgedTwist& attempt : trial.attempts) {
      ++rows.place.number;
      rows.add("twist_error_deg", attempt.error_deg, 1);
    }
    rows.place.number = 0;
    for (const auto& [metric, value] : trial.detorsion) {
      rows.add(metric, value, trial.samples);
    }
    rows.put("outcome", wordOf(trial.outcome), trial.samples);
    rows.put("trial", Text(trial.trialId), trial.samples);
    rows.put("content_hash", Text(trial.contentHash), trial.samples);
  }
}

void addCompetence(const CohortInputs& in, Ledger& ledger) {
  for (std::size_t i = 0; i < in.competence.size(); ++i) {
    const CohortCompetence& one = in.competence[i];
    ResultWriter rows(ledger, competenceKey(in, i), commonFlags(in),
                      one.designVersion > 0 ? std::vector<std::string>{}
                                            : std::vector<std::string>{"design shipped with the exercise"});
    std::vector<ResultPart> parts{
        RecordRef{RecordKind::kCompetenceDesign, std::to_string(one.designVersion)}};
    for (const TrialId& run : one.runs) {
      parts.emplace_back(RecordRef{RecordKind::kRecording, run.text()});
    }
    rows.madeOf = partsOf(std::move(parts));
    rows.put("level", one.level, one.attempts);
    rows.addCount("failed", one.failed, one.attempts);
    rows.put("able", one.able, one.attempts);
    if (one.ableAt) {
      rows.addCount("able_at_attempt", *one.ableAt, one.attempts);
    }
    rows.add("false_pass", one.falsePass, one.withinAttempts);
    rows.add("false_fail", one.falseFail, one.withinAttempts);
    rows.add("false_alarm", one.falseAlarm, one.withinAttempts);
    rows.addCount("within_attempts", one.withinAttempts, one.attempts);
    rows.addCount("design_version", one.designVersion, one.attempts);
  }
}

void addDeviations(const CohortInputs& in, Ledger& ledger) {
  ResultWriter rows(ledger, {.section = kDeviation}, commonFlags(in));
  for (std::size_t i = 0; i < in.deviations.size(); ++i) {
    const CohortDeviation& deviation = in.deviations[i];
    rows.place.of = deviation.trainee;
    rows.place.when = formatUtc(deviation.happenedUtc_us);
    rows.place.record = std::to_string(i);
    rows.madeOf = partsOf({RecordRef{RecordKind::kDeviation, deviation.id}});
    rows.put(deviation.kind, Text(deviation.description), 1);
  }
}

/// Returns whether an aggregated table may contain the row: a summary over at least kSmallestCell.
bool isAggregate(const Result& result) {
  const ResultKey& key = result.key;
  if (key.section == kScoringSheet || key.section == kRecord) {
    return true;
  }
  if (!key.of.empty() || key.section == kDeviation || key.section == kTrial) {
    return false;
  }
  return key.section == kEvaluation || result.n >= kSmallestCell;
}

bool isSingleMark(const ResultKey& key) {
  return key.statistic == "mark" || key.statistic == "rater_mark" || key.statistic == "criterion_mark";
}

/// Lists all results: `in` is the visible part of `inputs`, `study` its analysis, empty without marks.
Ledger ledgerOf(const CohortInputs& inputs, const CohortInputs& in,
                const std::optional<StudyAnalysis>& study) {
  ResultNames names{{}, in.occasions};
  for (const CohortGroup& group : in.groups) {
    names.groups.push_back(group.name);
  }
  Ledger ledger(std::move(names));
  addEvaluation(in, ledger);
  addTraining(in, ledger);
  addCriteriaResults(in, ledger);
  if (study) {
    addStudyResults(in, *study, ledger);
  }
  addTrials(in, ledger);
  addCompetence(in, ledger);
  addDeviations(in, ledger);
  if (inputs.sheetsAsked > inputs.sheetsPresent) {
    ResultWriter sheets(ledger, {.section = kTraining}, commonFlags(in));
    sheets.madeOf = partsOf({RecordRef{RecordKind::kSheetRequests}});
    sheets.addCount("sheets_asked", inputs.sheetsAsked, inputs.sheetsAsked);
    sheets.addCount("sheets_present", inputs.sheetsPresent, inputs.sheetsAsked);
  }
  if (!in.auditHead.empty()) {
    ResultWriter trail(ledger, {.section = kRecord, .of = "audit_trail"}, {formatUtc(in.createdUtc_us)});
    trail.madeOf = partsOf({RecordRef{RecordKind::kAuditTrail}});
    trail.put("head", Text(in.auditHead), in.auditEntries);
  }
  if (!in.programHash.empty()) {
    ResultWriter program(ledger, {.section = kRecord, .of = "program", .model = in.softwareVersion}, {});
    program.madeOf = partsOf({RecordRef{RecordKind::kProgram}});
    program.put("file_blake2b", Text(in.programHash), 1);
  }
  const bool aggregated = inputs.identity == ReportIdentity::kAggregated;
  if (inputs.singleMarks && !aggregated) {
    return ledger;
  }
  return ledger.filtered([&](const Result& result) {
    return (inputs.singleMarks || !isSingleMark(result.key)) && (!aggregated || isAggregate(result));
  });
}

}  // namespace

void ResultWriter::setFlags(const std::vector<std::string>& own) {
  std::vector<Text> all = flags_;
  all.insert(all.end(), own.begin(), own.end());
  joined_ = listed(all, Text::tr("%1; %2")).str();
}

void ResultWriter::put(const std::string& statistic, ResultValue value, std::int64_t n) {
  Result result{place, std::move(value), n, joined_, madeOf};
  result.key.statistic = statistic;
  if (std::holds_alternative<Undefined>(result.value)) {
    result.flags += result.flags.empty() ? "undefined" : "; undefined";
  }
  ledger_.add(std::move(result));
}

void ResultWriter::add(const std::string& statistic, const std::optional<double>& value, std::int64_t n) {
  put(statistic, value ? ResultValue(*value) : ResultValue(Undefined{}), n);
}

void ResultWriter::addInterval(const std::string& statistic, double value,
                               const std::optional<Interval>& interval, std::int64_t n) {
  add(statistic, value, n);
  if (interval) {
    addBounds(statistic, *interval, n);
  }
}

void ResultWriter::addBounds(const std::string& statistic, const Interval& interval, std::int64_t n) {
  add(statistic + "_lower_95", interval.lower, n);
  add(statistic + "_upper_95", interval.upper, n);
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
  made.ledger = ledgerOf(inputs, made.shown, made.study);
  return made;
}

}  // namespace torsio
