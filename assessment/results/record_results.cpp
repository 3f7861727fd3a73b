// SPDX-License-Identifier: GPL-3.0-or-later
// Results about the record as a whole: what the parts of the report are computed from, how marks were given,
// and what the recordings add up to.
#include <algorithm>
#include <map>
#include <set>
#include <string>

#include "assessment/results/analysed_cohort.h"
#include "assessment/results/record_sentences.h"
#include "assessment/results/report_sections.h"
#include "assessment/results/result_writer.h"

namespace torsio {

namespace {

using enum ResultSection;

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

/// Adds what the recordings add up to.
void addRecordings(const CohortInputs& in, Ledger& ledger) {
  if (in.trials.empty()) {
    return;
  }
  double minutes = 0.0;
  std::int64_t samples = 0;
  std::int64_t refused = 0;
  std::int64_t late = 0;
  std::int64_t cuts = 0;
  std::int64_t busy = 0;
  std::int64_t unsealed = 0;
  for (const TrialSummaryRow& trial : in.trials) {
    minutes += trial.minutes;
    samples += trial.samples;
    refused += trial.refusedSamples;
    late += trial.lateTicks;
    cuts += trial.forceCuts;
    busy += trial.forceCuts > 0 ? 1 : 0;
    unsealed += trial.contentHash.empty() ? 1 : 0;
  }
  ResultWriter rows(ledger, {.section = kRecord, .of = kRecordings}, commonFlags(in));
  rows.madeOf = partsOf({ResultPattern{.section = kTrial, .statistic = "minutes", .of = kEach}});
  const std::int64_t runs = std::ssize(in.trials);
  rows.add("minutes", minutes, runs);
  rows.addCount("samples", samples, runs);
  rows.addCount("refused_samples", refused, runs);
  rows.addCount("late_ticks", late, runs);
  rows.addCount("force_cuts", cuts, runs);
  rows.addCount("runs_with_force_cuts", busy, runs);
  rows.addCount("runs_without_hash", unsealed, runs);
}

/// Adds the ends of a scale in points.
void addScale(const ScoreScale& scale, std::int64_t marks, ResultWriter& rows) {
  rows.add("scale_lowest", pointsFromSteps(scale.lo, scale), marks);
  rows.add("scale_highest", pointsFromSteps(scale.hi, scale), marks);
}

/// Adds how the marks of the training study were given.
void addWaysOfMarks(const CohortInputs& in, Ledger& ledger) {
  const std::int64_t marks = std::ssize(in.trainingMarks);
  ResultWriter rows(ledger, {.section = kRecord, .of = kTrainingMarks}, commonFlags(in));
  rows.madeOf = partsOf({RecordRef{RecordKind::kSheetRequests}});
  rows.addCount("occasions", std::ssize(in.occasions), marks);
  rows.addCount("raters", static_cast<std::int64_t>(in.trainingRaters), marks);
  addScale(in.trainingScale, marks, rows);
  const MarkWays& ways = in.markWays;
  const std::int64_t all = ways.blinded + ways.live + ways.entered;
  rows.addCount("given_in_all", all, all);
  rows.addCount("given_blinded", ways.blinded, all);
  rows.addCount("given_live", ways.live, all);
  rows.addCount("entered_without_sheet", ways.entered, all);
  rows.addCount("not_assessable", in.notAssessable, marks);
  if (!in.signatures.empty()) {
    rows.addCount("signed", std::ssize(in.signatures), marks);
    rows.addCount("not_signed", in.unsignedMarks, marks);
  }
}

/// Adds how the marks of the evaluation of models were given.
void addWaysOfEvaluation(const CohortInputs& in, Ledger& ledger) {
  if (in.ratings.empty()) {
    return;
  }
  std::int64_t marks = 0;
  std::map<std::string, std::set<std::string>> ofClass;
  for (const ModelRatings& model : in.ratings) {
    marks += givenMarks(model);
    for (const RaterSheet& sheet : model.sheets) {
      ofClass[in.instrument.classes[sheet.raterClass].id].insert(sheet.rater);
    }
  }
  ResultWriter rows(ledger, {.section = kRecord, .of = kEvaluationMarks}, commonFlags(in));
  rows.madeOf = partsOf({RecordRef{RecordKind::kCampaign}});
  rows.addCount("indices", std::ssize(in.instrument.indices), marks);
  addScale(in.instrument.scale, marks, rows);
  rows.addCount("missing", missingEvaluationMarks(in), marks);
  rows.addCount("models", std::ssize(in.ratings), marks);
  rows.addCount("models_hidden", in.modelsHidden, marks);
  const std::set<std::string> raters = evaluationRaters(in);
  rows.addCount("raters_who_are_trainees",
                std::count_if(in.trainees.begin(), in.trainees.end(),
                              [&](const CohortTrainee& trainee) { return raters.contains(trainee.code); }),
                marks);
  for (const RaterClass& raterClass : in.instrument.classes) {
    rows.place.raterClass = raterClass.id;
    rows.addCount("raters", std::ssize(ofClass[raterClass.id]), marks);
  }
}

/// Adds who rested, and how much of the time noted on the simulator was recorded.
void addTimesInAll(const CohortInputs& in, Ledger& ledger) {
  double noted_min = 0.0;
  double recorded_min = 0.0;
  for (const CohortDose& dose : in.doses) {
    noted_min += dose.virtual_min;
  }
  for (const TrialSummaryRow& trial : in.trials) {
    recorded_min += trial.detorsion.empty() ? trial.minutes : 0.0;
  }
  ResultWriter rows(ledger, {.section = kRecord, .of = kTrainingTimes}, commonFlags(in));
  rows.madeOf = partsOf({RecordRef{RecordKind::kTrainingTimes}});
  const std::int64_t n = std::ssize(in.doses);
  rows.addCount("trainees_who_rested", in.rests, n);
  if (noted_min == 0.0) {
    return;
  }
  rows.add("noted_virtual_min", noted_min, n);
  rows.add("recorded_virtual_min", recorded_min, n);
  rows.add("recorded_share", recorded_min / noted_min, n);
  if (recorded_min > 0.0) {
    rows.add("noted_for_each_recorded", noted_min / recorded_min, n);
  }
}

}  // namespace

void addRecordResults(const CohortInputs& in, Ledger& ledger) {
  addSources(in, ledger);
  addRecordings(in, ledger);
  addWaysOfMarks(in, ledger);
  addWaysOfEvaluation(in, ledger);
  addTimesInAll(in, ledger);
}

}  // namespace torsio
