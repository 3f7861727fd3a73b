// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/report/shown_inputs.h"

#include <set>
#include <utility>

namespace torsio {

namespace {

bool isOpen(const CohortInputs& in) {
  return in.sheetsAsked > in.sheetsPresent && !in.freeze;
}

void withholdMarks(CohortInputs& out, std::vector<Text>& left) {
  if (!out.trainingMarks.empty()) {
    left.push_back(
        Text::tr("The training study is not shown: %1 of %2 sheets that raters were asked for are present. "
                 "Marks and means "
                 "appear once all are, or once the data set is frozen.",
                 out.sheetsPresent, out.sheetsAsked));
  }
  out.scores.clear();
  out.summaries.clear();
  out.trainingMarks.clear();
  out.notAssessable = 0;
}

/// Takes away what one or two marks could be read from.
void withholdSmallCells(CohortInputs& out, std::vector<Text>& left) {
  std::set<std::pair<std::size_t, std::string>> few;  // occasion, trainee
  for (const TraineeScore& score : out.scores) {
    if (score.n < kFewestMarks) {
      few.insert({score.occasion, score.trainee});
    }
  }
  const auto fewMarks = [&](const auto& item) { return few.contains({item.occasion, item.trainee}); };
  std::set<std::pair<std::size_t, std::size_t>> small;  // occasion, group
  for (const GroupSummary& summary : out.summaries) {
    if (summary.trainees < kFewestMarks) {
      small.insert({summary.occasion, summary.group});
    }
  }
  const auto smallGroup = [&](const auto& item) { return small.contains({item.occasion, item.group}); };
  const std::size_t before = out.scores.size() + out.summaries.size();
  // A mean over the group that holds the withheld score would give it back.
  for (const TraineeScore& score : out.scores) {
    if (fewMarks(score)) {
      small.insert({score.occasion, score.group});
    }
  }
  std::erase_if(out.summaries, smallGroup);
  std::erase_if(out.scores, fewMarks);
  std::erase_if(out.trainingMarks, fewMarks);
  if (out.scores.size() + out.summaries.size() < before) {
    left.push_back(Text::tr(
        "Scores of fewer than %1 marks, and means of fewer than %1 trainees or with such a score among "
        "them, are left out: a single mark could be read from them.",
        kFewestMarks));
  }
}

}  // namespace

CohortInputs shownInputs(const CohortInputs& inputs, std::vector<Text>& left) {
  CohortInputs out = inputs;
  if (isOpen(out)) {
    withholdMarks(out, left);
  } else if (!out.singleMarks) {
    withholdSmallCells(out, left);
  }
  return out;
}

}  // namespace torsio
