// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/results/shown_inputs.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace torsio {

namespace {

bool isOpen(const CohortInputs& in) {
  return in.sheetsAsked > in.sheetsPresent && !in.freeze;
}

void withholdMarks(CohortInputs& out, std::vector<Text>& left) {
  if (!out.trainingMarks.empty()) {
    left.push_back(Text::tr(
        "The training study is not shown: %1 of %2 {sheet that raters were asked for is|sheets that raters "
        "were asked for are} present. Marks and means appear once all are, or once the data set is frozen.",
        out.sheetsPresent, out.sheetsAsked));
  }
  out.scores.clear();
  out.summaries.clear();
  out.trainingMarks.clear();
  out.criterionMarks.clear();
  out.sheets.clear();
  out.notAssessable = 0;
}

/// Counts raters with a mark for every index of every model.
std::int64_t ratersPresent(const CohortInputs& in) {
  std::map<std::string, std::size_t> whole;
  for (const ModelRatings& model : in.ratings) {
    for (const RaterSheet& sheet : model.sheets) {
      whole[sheet.rater] += std::all_of(sheet.steps.begin(), sheet.steps.end(),
                                        [](const auto& steps) { return steps.has_value(); })
                                ? 1
                                : 0;
    }
  }
  return std::count_if(whole.begin(), whole.end(),
                       [&](const auto& rater) { return rater.second == in.ratings.size(); });
}

void withholdEvaluation(CohortInputs& out, std::vector<Text>& left) {
  const std::int64_t present = ratersPresent(out);
  if (out.freeze || present >= out.evaluationRatersAsked) {
    return;
  }
  if (out.evaluations.empty()) {  // the section explains what is missing
    out.ratings.clear();
    return;
  }
  left.push_back(Text::tr(
      "The evaluation of the models is not shown: %1 of %2 {rater who was asked has|raters who were asked "
      "have} given all marks. Marks and scores appear once all have, or once the data set is frozen.",
      present, out.evaluationRatersAsked));
  out.ratings.clear();
  out.evaluations.clear();
}

/// Removes values from which one or two marks could be inferred.
void withholdSmallCells(CohortInputs& out, std::vector<Text>& left) {
  std::set<std::pair<std::size_t, std::string>> few;  // occasion, trainee
  for (const TraineeScore& score : out.scores) {
    if (score.n < kMinMarks) {
      few.insert({score.occasion, score.trainee});
    }
  }
  const auto fewMarks = [&](const auto& item) { return few.contains({item.occasion, item.trainee}); };
  std::set<std::pair<std::size_t, std::size_t>> small;  // occasion, group
  for (const GroupSummary& summary : out.summaries) {
    if (summary.trainees < kMinMarks) {
      small.insert({summary.occasion, summary.group});
    }
  }
  const auto smallGroup = [&](const auto& item) { return small.contains({item.occasion, item.group}); };
  const std::size_t before = out.scores.size() + out.summaries.size();
  // The withheld score could be inferred from a mean of its group.
  for (const TraineeScore& score : out.scores) {
    if (fewMarks(score)) {
      small.insert({score.occasion, score.group});
    }
  }
  std::erase_if(out.summaries, smallGroup);
  std::erase_if(out.scores, fewMarks);
  std::erase_if(out.trainingMarks, fewMarks);
  std::erase_if(out.criterionMarks, [&](const auto& mark) { return fewMarks(mark) || smallGroup(mark); });
  if (out.scores.size() + out.summaries.size() < before) {
    left.push_back(Text::tr(
        "Scores of fewer than %1 marks, and means of fewer than %1 trainees or with such a score among "
        "them, are left out: a single mark could be read from them.",
        kMinMarks));
  }
}

}  // namespace

CohortInputs shownInputs(const CohortInputs& inputs, std::vector<Text>& left) {
  CohortInputs out = inputs;
  withholdEvaluation(out, left);
  if (isOpen(out)) {
    withholdMarks(out, left);
  } else if (!out.singleMarks) {
    withholdSmallCells(out, left);
  }
  return out;
}

}  // namespace torsio
