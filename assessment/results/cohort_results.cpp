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
#include "assessment/statistics/distributions.h"
#include "assessment/statistics/quantiles.h"
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

/// Adds the means of the classes of raters for an index.
void addClassMeans(const CohortInputs& in, const ScoreStatistics& s, ResultWriter& rows) {
  for (std::size_t c = 0; c < s.classMeans.size(); ++c) {
    rows.place.raterClass = in.instrument.classes[c].id;
    rows.add("class_mean", s.classMeans[c], s.classCounts[c]);
  }
  rows.place.raterClass.clear();
}

/// Adds the distribution of the raters' own scores of a model.
void addComposites(const ModelEvaluation& model, ResultWriter& rows) {
  std::vector<double> scores;
  for (const RaterComposite& composite : model.composites) {
    if (composite.score) {
      scores.push_back(*composite.score);
    }
  }
  const std::int64_t n = std::ssize(scores);
  rows.madeOf = partsOf(
      {ResultPattern{.section = kEvaluation, .statistic = "composite", .of = kEach, .model = model.model},
       RecordRef{RecordKind::kCampaign}});
  rows.addCount("raters_with_all_marks", n, n);
  const auto& statistics = model.compositeStatistics;
  rows.add("composite_M", statistics ? std::optional(statistics->m) : std::nullopt, n);
  rows.add("composite_se_of_M", statistics ? statistics->standardError : std::nullopt, n);
  if (statistics && statistics->standardError && statistics->standardErrorDf) {
    const double reach = tQuantile(0.5 * (1.0 + kDefaultConfidence), *statistics->standardErrorDf) *
                         *statistics->standardError;
    rows.put("composite_M_95", Interval{statistics->m - reach, statistics->m + reach}, n);
  }
  if (const std::optional<BoxNumbers> box = boxNumbers(scores)) {
    rows.add("composite_lowest", box->min, n);
    rows.add("composite_lower_whisker", box->whiskerLow, n);
    rows.add("composite_lower_quartile", box->q1, n);
    rows.add("composite_median", box->median, n);
    rows.add("composite_upper_quartile", box->q3, n);
    rows.add("composite_upper_whisker", box->whiskerHigh, n);
    rows.add("composite_highest", box->max, n);
    rows.add("composite_plain_mean", box->mean, n);
  }
}

void addWeights(const CohortInputs& in, Ledger& ledger) {
  ResultWriter rows(ledger, {.section = kEvaluation}, commonFlags(in));
  rows.madeOf = partsOf({RecordRef{RecordKind::kCampaign}});
  for (const EvaluationIndex& index : in.instrument.indices) {
    rows.place.index = index.id;
    rows.add("index_weight", static_cast<double>(index.weight_milli) / 1000.0, 1);
  }
  rows.place.index.clear();
  for (const RaterClass& raterClass : in.instrument.classes) {
    rows.place.raterClass = raterClass.id;
    rows.add("class_weight", static_cast<double>(raterClass.weight_milli) / 1000.0, 1);
  }
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

/// Adds the differences between the models.
void addModelDifferences(const CohortInputs& in, Ledger& ledger) {
  for (const ModelDifference& pair : modelDifferences(in)) {
    ResultWriter rows(ledger, modelPairKey(in, pair), commonFlags(in));
    std::vector<ResultPart> parts{RecordRef{RecordKind::kCampaign}};
    for (const std::size_t of : {pair.first, pair.second}) {
      parts.emplace_back(ResultPattern{
          .section = kEvaluation, .statistic = "composite", .of = kEach, .model = in.evaluations[of].model});
    }
    rows.madeOf = partsOf(std::move(parts));
    rows.add("composite_difference", pair.test, &TTest::difference, pair.raters);
    if (pair.test) {
      rows.put("composite_difference_holm_95", pair.asHolm, pair.raters);
      rows.add("composite_difference_p_holm", pair.pHolm, pair.raters);
    }
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
    rows.put(kClassScoreStatistic,
             of.score ? ResultValue(*of.score) : Undefined{Text::tr("an index has no mark")}, of.raters);
    rows.addCount("class_raters", of.raters, of.raters);
    rows.addCount("class_marks", of.marks, of.marks);
  }
}

void addEvaluation(const CohortInputs& in, Ledger& ledger) {
  if (!in.ratings.empty()) {
    addWeights(in, ledger);
  }
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
      addClassMeans(in, model.indices[j], rows);
    }
    rows.place.index.clear();
    rows.setFlags({});
    addComposites(model, rows);
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
  addModelDifferences(in, ledger);
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
    rows.add("standard_deviation_of_scores", sampleDeviation(scores), s.trainees);
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
  if (const std::int64_t marks = std::ssize(in.trainingMarks); marks > 0) {
    rows.madeOf = partsOf({ResultPattern{.statistic = "rater_mark", .of = kEach}});
    rows.addCount("raters", static_cast<std::int64_t>(in.trainingRaters), marks);
    rows.addCount("marks", marks, marks);
  }
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

/// Adds per group how many are competent at each exercise, and at all that they tried.
void addCompetenceOfGroups(const CohortInputs& in, Ledger& ledger) {
  ResultWriter rows(ledger, {.section = kCompetence}, commonFlags(in));
  struct Counts {
    std::int64_t able = 0;
    std::int64_t notAble = 0;
    std::int64_t notShown = 0;
  };
  struct Person {
    bool able = true;
    bool tried = false;
  };
  std::map<std::pair<std::string, std::size_t>, Counts> cells;
  std::map<std::pair<std::size_t, std::string>, Person> people;
  for (const CohortCompetence& one : in.competence) {
    Counts& counts = cells[{one.exercise.str(), one.group}];
    ++(one.able ? counts.able : one.shown() ? counts.notAble : counts.notShown);
    Person& person = people[{one.group, one.trainee}];
    person.able = person.able && (one.able || !one.required);
    person.tried = person.tried || one.attempts > 0;
  }
  for (const auto& [place, counts] : cells) {
    rows.place.index = place.first;
    rows.place.group = place.second;
    rows.madeOf = partsOf({ResultPattern{.section = kCompetence,
                                         .statistic = "able",
                                         .of = kEach,
                                         .group = place.second,
                                         .index = place.first}});
    rows.put("competent_and_not",
             countsText({{Text::tr("competent"), counts.able},
                         {Text::tr("not competent"), counts.notAble},
                         {Text::tr("not shown yet"), counts.notShown}},
                        in.identity),
             counts.able + counts.notAble + counts.notShown);
  }
  rows.place.index.clear();
  for (std::size_t g = 0; g < in.groups.size(); ++g) {
    std::int64_t judged = 0;
    std::int64_t able = 0;
    bool tried = false;
    for (const auto& [place, person] : people) {
      judged += place.first == g ? 1 : 0;
      able += place.first == g && person.able ? 1 : 0;
      tried = tried || (place.first == g && person.tried);
    }
    if (tried) {
      rows.place.group = g;
      rows.madeOf =
          partsOf({ResultPattern{.section = kCompetence, .statistic = "able", .of = kEach, .group = g}});
      rows.addCount("able_at_every_exercise", able, judged);
    }
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
    rows.add("false_pass", one.falsePass, one.attempts);
    rows.add("false_fail", one.falseFail, one.attempts);
    rows.add("false_alarm", one.falseAlarm, one.attempts);
    for (std::size_t rate = 0; rate < kStatedFailureRates.size(); ++rate) {
      rows.add(declaredStatistic(rate, false), one.declaredWithinMade[rate], one.attempts);
      rows.add(declaredStatistic(rate, true), one.declaredWithinPlanned[rate], one.plannedAttempts);
    }
    rows.addCount("planned_attempts", one.plannedAttempts, one.attempts);
    rows.addCount("fewest_attempts", one.fewestAttempts, one.attempts);
    rows.addCount("design_version", one.designVersion, one.attempts);
    for (const double sum : one.sums) {
      ++rows.place.number;
      rows.add("cumulative_sum_of_limit", sum / one.limit, rows.place.number);
    }
  }
  addCompetenceOfGroups(in, ledger);
}

void addDeviations(const CohortInputs& in, Ledger& ledger) {
  ResultWriter rows(ledger, {.section = kDeviation}, commonFlags(in));
  for (std::size_t i = 0; i < in.deviations.size(); ++i) {
    const CohortDeviation& deviation = in.deviations[i];
    rows.place = deviationKey(in, i);
    rows.madeOf = partsOf({RecordRef{RecordKind::kDeviation, deviation.id}});
    rows.put(deviation.kind, Text(deviation.description), 1);
  }
}

/// Adds the counts and hashes of what the parts of the report are computed from.
void addSources(const CohortInputs& in, Ledger& ledger) {
  ResultWriter rows(ledger, {.section = kRecord}, commonFlags(in));
  const auto add = [&](const char* of, const MarksHash& source, ResultPart part) {
    if (source.count > 0) {
      rows.place.of = of;
      rows.madeOf = partsOf({std::move(part)});
      rows.addCount("count", source.count, source.count);
      rows.put("blake2b", Text(source.hash), source.count);
    }
  };
  add(kEvaluationMarks, hashOfEvaluationMarks(in), RecordRef{RecordKind::kCampaign});
  add(kTrainingMarks, hashOfTrainingMarks(in), ResultPattern{.statistic = "rater_mark", .of = kEach});
  add(kRecordings, hashOfTrials(in),
      ResultPattern{.section = kTrial, .statistic = "content_hash", .of = kEach});
  rows.place = {};
  std::map<std::string, std::int64_t> marks;
  for (const TrainingMark& mark : in.trainingMarks) {
    ++marks[mark.trainee];
  }
  for (const auto& [trainee, count] : marks) {
    rows.place.of = trainee;
    rows.madeOf = partsOf({ResultPattern{.statistic = "rater_mark", .of = trainee}});
    rows.addCount("marks", count, count);
  }
}

/// Returns whether an aggregated table may contain the row: a summary over at least kSmallestCell.
bool isAggregate(const Result& result) {
  const ResultKey& key = result.key;
  if (key.section == kScoringSheet || key.section == kRecord) {
    return true;
  }
  if (!key.of.empty() || key.section == kDeviation || (key.section == kTrial && !key.record.empty())) {
    return false;
  }
  return key.section == kEvaluation || result.n >= kSmallestCell;
}

bool isSingleMark(const ResultKey& key) {
  return key.statistic == "mark" || key.statistic == "rater_mark" || key.statistic == "criterion_mark" ||
         key.statistic == kMarkAndOthers || key.statistic == kMarkMinusOthers;
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
  std::vector<Text> unsaid;
  const bool aggregated = inputs.identity == ReportIdentity::kAggregated;
  addPracticeResults(in, aggregated ? withoutSmallGroups(inputs, unsaid) : inputs, ledger);
  addSources(in, ledger);
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
  Result result{place, std::move(value), n, joined_, madeOf, origin};
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
    put(statistic + "_95", *interval, n);
  }
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
