// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/report/cohort_csv.h"

#include <optional>

#include "assessment/report/number_format.h"
#include "assessment/report/report_sections.h"

namespace torsio {

namespace {

std::string joinFlags(const std::vector<std::string>& common, const std::vector<std::string>& own) {
  std::string text;
  for (const std::vector<std::string>* list : {&common, &own})
    for (const std::string& flag : *list) {
      if (!text.empty()) text += "; ";
      text += flag;
    }
  return text;
}

/// Collects rows that share their place and differ in statistic and value.
class Rows {
 public:
  explicit Rows(std::vector<CohortCsvRow>& out) : out_(out) {}

  CohortCsvRow place;

  void add(const std::string& statistic, const std::optional<double>& value, std::int64_t n) {
    CohortCsvRow row = place;
    row.statistic = statistic;
    if (value) row.value = formatExact(*value);
    row.n = std::to_string(n);
    if (!value) row.flags += row.flags.empty() ? "undefined" : "; undefined";
    out_.push_back(row);
  }

 private:
  std::vector<CohortCsvRow>& out_;
};

void addStatistics(Rows& rows, const ScoreStatistics& s) {
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

void addEvaluation(const CohortInputs& in, std::vector<CohortCsvRow>& out) {
  const std::vector<std::string> common = commonFlags(in);
  for (std::size_t k = 0; k < in.evaluations.size(); ++k) {
    const ModelEvaluation& model = in.evaluations[k];
    Rows rows(out);
    rows.place.section = "evaluation";
    rows.place.item = "all";
    rows.place.model = model.model;
    rows.place.flags = joinFlags(common, model.flags);
    rows.add("N_eq27", model.n27, std::ssize(model.composites));
    for (std::size_t j = 0; j < model.indices.size(); ++j) {
      rows.place.index = in.instrument.indices[j].id;
      rows.place.flags = joinFlags(common, model.indices[j].flags);
      addStatistics(rows, model.indices[j]);
    }
    rows.place.index.clear();
    for (const RaterComposite& composite : model.composites) {
      rows.place.item = composite.rater;
      rows.place.group = in.instrument.classes[composite.raterClass].id;
      rows.place.flags = joinFlags(common, {});
      rows.add("composite", composite.score, composite.score ? 1 : 0);
    }
    for (const RaterSheet& sheet : in.ratings[k].sheets)
      for (std::size_t j = 0; j < sheet.steps.size(); ++j) {
        rows.place.item = sheet.rater;
        rows.place.group = in.instrument.classes[sheet.raterClass].id;
        rows.place.index = in.instrument.indices[j].id;
        std::optional<double> mark;
        if (sheet.steps[j]) mark = pointsFromSteps(*sheet.steps[j], in.instrument.scale);
        rows.add("mark", mark, mark ? 1 : 0);
      }
  }
}

void addTraining(const CohortInputs& in, std::vector<CohortCsvRow>& out) {
  Rows rows(out);
  rows.place.section = "training";
  rows.place.flags = joinFlags(commonFlags(in), {});
  for (const GroupSummary& s : in.summaries) {
    rows.place.item = "all";
    rows.place.group = in.groups[s.group].name;
    rows.place.occasion = in.occasions[s.occasion];
    rows.add("mean", s.mean, s.trainees);
    rows.add("median", s.median, s.trainees);
    rows.add("min", s.min, s.trainees);
    rows.add("max", s.max, s.trainees);
    rows.add("variance_of_scores_divisor_n", s.varianceOfScores, s.trainees);
    rows.add("variance_of_scores_divisor_n_minus_1", s.sampleVarianceOfScores, s.trainees);
    rows.add("variance_of_all_marks_divisor_n", s.varianceOfMarks, s.marks);
    rows.add("mean_between_rater_variance_divisor_n_minus_1", s.meanBetweenRaterVariance, s.marks);
  }
  for (const TraineeScore& score : in.scores) {
    rows.place.item = score.trainee;
    rows.place.group = in.groups[score.group].name;
    rows.place.occasion = in.occasions[score.occasion];
    rows.add("score", score.score, score.n);
  }
}

void addTrials(const CohortInputs& in, std::vector<CohortCsvRow>& out) {
  Rows rows(out);
  rows.place.section = "trial";
  for (const TrialDigest& trial : in.trials) {
    rows.place.item = trial.trainee;
    rows.place.group = in.groups[trial.group].name;
    rows.place.model = trial.model;
    rows.place.occasion = trial.phase;
    rows.place.flags = joinFlags(commonFlags(in), trial.interrupted ? std::vector<std::string>{"interrupted"}
                                                                    : std::vector<std::string>{});
    rows.add("minutes", trial.minutes, trial.samples);
    rows.add("twists", static_cast<double>(trial.twists), trial.samples);
    rows.add("twists_on_target", static_cast<double>(trial.twistsOnTarget), trial.twists);
    rows.add("mean_absolute_error_deg", trial.meanAbsoluteError_deg, trial.twists);
    rows.add("peak_torque_Nm", trial.peakTorque_Nm, trial.samples);
    rows.add("peak_force_N", trial.peakForce_N, trial.samples);
    rows.add("refused_samples", static_cast<double>(trial.refusedSamples), trial.samples);
  }
}

void appendField(std::string& text, const std::string& field) {
  if (field.find_first_of(",\"\r\n") == std::string::npos) {
    text += field;
    return;
  }
  text += '"';
  for (const char c : field) {
    if (c == '"') text += '"';
    text += c;
  }
  text += '"';
}

}  // namespace

std::vector<CohortCsvRow> cohortCsvRows(const CohortInputs& in) {
  std::vector<CohortCsvRow> rows;
  addEvaluation(in, rows);
  addTraining(in, rows);
  addTrials(in, rows);
  return rows;
}

std::string cohortCsvText(const std::vector<CohortCsvRow>& rows) {
  std::string text = "section,item,group,model,index,occasion,statistic,value,n,flags\r\n";
  for (const CohortCsvRow& row : rows) {
    bool first = true;
    for (const std::string* field : {&row.section, &row.item, &row.group, &row.model, &row.index,
                                     &row.occasion, &row.statistic, &row.value, &row.n, &row.flags}) {
      if (!first) text += ',';
      first = false;
      appendField(text, *field);
    }
    text += "\r\n";
  }
  return text;
}

}  // namespace torsio
