// SPDX-License-Identifier: GPL-3.0-or-later
// Fills the ledger of a cohort: scores, recordings, competence, deviations and sources here, the rest by the
// functions of result_writer.h.
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

std::int64_t marksGiven(const CohortInputs& in, std::size_t group, std::size_t occasion) {
  return std::count_if(in.trainingMarks.begin(), in.trainingMarks.end(), [&](const TrainingMark& mark) {
    return mark.group == group && mark.occasion == occasion;
  });
}

void addSummaries(const CohortInputs& in, ResultWriter& rows) {
  for (const GroupSummary& s : in.summaries) {
    rows.place.group = rows.group(s.group);
    rows.place.occasion = rows.occasion(s.occasion);
    rows.madeOf = partsOf({ResultPattern{
        .statistic = "score", .of = kEach, .group = rows.place.group, .occasion = rows.place.occasion}});
    const std::vector<double> scores = scoresOf(in, s.group, s.occasion);
    rows.addInterval("mean", s.mean, meanInterval(scores), s.trainees);
    rows.add("median", s.median, s.trainees);
    rows.add("min", s.min, s.trainees);
    rows.add("max", s.max, s.trainees);
    rows.add("variance_of_scores_divisor_n", s.varianceOfScores, s.trainees);
    rows.add("variance_of_scores_divisor_n_minus_1", s.sampleVarianceOfScores, s.trainees);
    rows.add("standard_deviation_of_scores", sampleDeviation(scores), s.trainees);
    rows.madeOf = partsOf({marksAt(rows.place.occasion, rows.place.group)});
    rows.add("variance_of_all_marks_divisor_n", s.varianceOfMarks, s.marks);
    rows.add("mean_between_rater_variance_divisor_n_minus_1", s.meanBetweenRaterVariance, s.marks);
  }
  if (in.trainingMarks.empty()) {
    return;
  }
  const std::vector<std::vector<std::int64_t>> missing = missingByGroup(in);
  std::int64_t inAll = 0;
  for (std::size_t g = 0; g < missing.size(); ++g) {
    for (std::size_t t = 0; t < missing[g].size(); ++t) {
      rows.place.group = rows.group(g);
      rows.place.occasion = rows.occasion(t);
      rows.madeOf =
          partsOf({marksAt(rows.place.occasion, rows.place.group), RecordRef{RecordKind::kEnrolments}});
      rows.addCount("marks_missing_at_occasion", missing[g][t], marksGiven(in, g, t));
      inAll += missing[g][t];
    }
  }
  rows.place = {};
  rows.madeOf = partsOf({ResultPattern{.statistic = "marks_missing_at_occasion"}});
  rows.addCount("marks_missing", inAll, std::ssize(in.trainingMarks));
}

/// Adds how many scores there are, and how many a trainee lacks, at each occasion, in each group and in all.
void addScoreCounts(const CohortInputs& in, Ledger& ledger) {
  if (in.scores.empty()) {
    return;
  }
  ResultWriter rows(ledger, {}, commonFlags(in));
  const auto add = [&](std::optional<std::size_t> group, std::optional<std::size_t> occasion) {
    rows.place = {.group = group ? rows.group(*group) : "",
                  .occasion = occasion ? rows.occasion(*occasion) : ""};
    const std::int64_t scores =
        std::count_if(in.scores.begin(), in.scores.end(), [&](const TraineeScore& one) {
          return group.value_or(one.group) == one.group && occasion.value_or(one.occasion) == one.occasion;
        });
    const std::int64_t members =
        std::count_if(in.trainees.begin(), in.trainees.end(),
                      [&](const CohortTrainee& one) { return group.value_or(one.group) == one.group; });
    ResultPattern each = rows.place;
    each.statistic = "score";
    each.of = kEach;
    rows.madeOf = partsOf({std::move(each), RecordRef{RecordKind::kEnrolments}});
    rows.addCount("scores", scores, scores);
    rows.addCount("scores_missing", members * (occasion ? 1 : std::ssize(in.occasions)) - scores, scores);
  };
  add(std::nullopt, std::nullopt);
  for (std::size_t t = 0; t < in.occasions.size(); ++t) {
    add(std::nullopt, t);
  }
  for (std::size_t g = 0; g < in.groups.size(); ++g) {
    add(g, std::nullopt);
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
  addScoreCounts(in, ledger);
  for (const TraineeScore& score : in.scores) {
    rows.place.of = score.trainee;
    rows.place.group = rows.group(score.group);
    rows.place.occasion = rows.occasion(score.occasion);
    rows.madeOf = partsOf({ResultPattern{
        .statistic = "rater_mark", .of = score.trainee, .occasion = ledger.occasion(score.occasion)}});
    rows.add("score", score.score, score.n);
  }
  for (const TrainingMark& mark : in.trainingMarks) {
    rows.place.of = mark.trainee;
    rows.place.group = rows.group(mark.group);
    rows.place.index = mark.rater;
    rows.place.occasion = rows.occasion(mark.occasion);
    rows.madeOf = partsOf({RecordRef{RecordKind::kMark, mark.id}});
    rows.add("rater_mark", pointsFromSteps(mark.steps, in.trainingScale), 1);
  }
}

void addTrials(const CohortInputs& in, Ledger& ledger) {
  for (const TrialSummaryRow& trial : in.trials) {
    ResultWriter rows(
        ledger, trialKey(ledger, trial), commonFlags(in),
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
    rows.place.group = rows.group(place.second);
    rows.madeOf = partsOf({ResultPattern{.section = kCompetence,
                                         .statistic = "able",
                                         .of = kEach,
                                         .group = ledger.group(place.second),
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
      rows.place.group = rows.group(g);
      rows.madeOf = partsOf({ResultPattern{
          .section = kCompetence, .statistic = "able", .of = kEach, .group = ledger.group(g)}});
      rows.addCount("able_at_every_exercise", able, judged);
    }
  }
}

/// Adds over all verdicts: runs made and needed, and how often the verdicts are wrong after the runs made.
void addVerdicts(const CohortInputs& in, Ledger& ledger) {
  if (in.competence.empty()) {
    return;
  }
  double falsePass = 0.0;
  double falseFail = 0.0;
  std::int64_t most = 0;
  std::int64_t fewest = in.competence.front().fewestAttempts;
  std::int64_t tooFew = 0;
  std::map<std::string, double> missed;  // by trainee: one exercise is enough for not being competent at all
  std::int64_t excused = 0;
  std::int64_t attempts = 0;
  for (const CohortCompetence& one : in.competence) {
    excused += std::ssize(one.excused);
    attempts += one.attempts;
    falsePass = std::max(falsePass, one.falsePass);
    most = std::max(most, one.attempts);
    fewest = std::min(fewest, one.fewestAttempts);
    tooFew += one.shown() ? 0 : 1;
    if (one.required) {
      missed[one.trainee] += one.falseFail + one.falseAlarm;
    }
  }
  for (const auto& [trainee, sum] : missed) {
    falseFail = std::clamp(sum, falseFail, 1.0);
  }
  ResultWriter rows(ledger, {.section = kCompetence}, commonFlags(in));
  rows.madeOf = partsOf({ResultPattern{.section = kCompetence, .statistic = "able", .of = kEach}});
  const std::int64_t verdicts = std::ssize(in.competence);
  rows.addCount("runs_judged", attempts, verdicts);
  rows.addCount("most_runs_made", most, verdicts);
  rows.addCount("fewest_runs_needed", fewest, verdicts);
  rows.addCount("verdicts_on_too_few_runs", tooFew, verdicts);
  rows.add("false_pass_at_most", falsePass, verdicts);
  rows.add("false_fail_at_most", falseFail, verdicts);
  rows.madeOf = partsOf({ResultPattern{.section = kCompetence, .statistic = "excused_runs", .of = kEach}});
  rows.addCount("excused_runs", excused, excused);
}

void addCompetence(const CohortInputs& in, Ledger& ledger) {
  for (std::size_t i = 0; i < in.competence.size(); ++i) {
    const CohortCompetence& one = in.competence[i];
    ResultWriter rows(ledger, competenceKey(ledger, in, i), commonFlags(in),
                      one.designVersion > 0 ? std::vector<std::string>{}
                                            : std::vector<std::string>{"design shipped with the exercise"});
    std::vector<ResultPart> parts{
        RecordRef{RecordKind::kCompetenceDesign, std::to_string(one.designVersion)}};
    for (const TrialId& run : one.runs) {
      parts.emplace_back(RecordRef{RecordKind::kRecording, run.text()});
    }
    std::vector<ResultPart> withExcused = parts;
    for (const TrialId& run : one.excused) {
      withExcused.emplace_back(RecordRef{RecordKind::kRecording, run.text()});
    }
    rows.madeOf = partsOf(std::move(withExcused));
    rows.addCount("excused_runs", std::ssize(one.excused), one.attempts + std::ssize(one.excused));
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
  addVerdicts(in, ledger);
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
  ResultNames names;
  for (const CohortGroup& group : in.groups) {
    names.groups.push_back(group.name.str());
  }
  for (const Text& occasion : in.occasions) {
    names.occasions.push_back(occasion.str());
  }
  Ledger ledger(std::move(names));
  addEvaluationResults(in, ledger);
  addTraining(in, ledger);
  addCriteriaResults(in, ledger);
  if (study) {
    addAgreementResults(in, *study, ledger);
    addComparisonResults(in, *study, ledger);
  }
  addTrials(in, ledger);
  addCompetence(in, ledger);
  addDeviations(in, ledger);
  std::vector<Text> unsaid;
  const bool aggregated = inputs.identity == ReportIdentity::kAggregated;
  addParticipantsResults(in, aggregated ? withoutSmallGroups(inputs, unsaid) : inputs, ledger);
  addPracticeResults(in, ledger);
  addRecordResults(in, ledger);
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
