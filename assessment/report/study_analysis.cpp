// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/report/study_analysis.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "assessment/statistics/descriptive.h"
#include "assessment/statistics/distributions.h"

namespace torsio {

namespace {

std::size_t rank(const std::vector<std::string>& sorted, const std::string& code) {
  return static_cast<std::size_t>(std::lower_bound(sorted.begin(), sorted.end(), code) - sorted.begin());
}

void sortUnique(std::vector<std::string>& codes) {
  std::sort(codes.begin(), codes.end());
  codes.erase(std::unique(codes.begin(), codes.end()), codes.end());
}

void gatherMarks(const CohortInputs& in, StudyAnalysis& out) {
  for (const TrainingMark& mark : in.trainingMarks) {
    out.trainees.push_back(mark.trainee);
    out.raters.push_back(mark.rater);
  }
  sortUnique(out.trainees);
  sortUnique(out.raters);
  out.occasions.resize(in.occasions.size());
  for (OccasionMarks& occasion : out.occasions) {
    occasion.marks.assign(out.trainees.size(), std::vector<std::optional<double>>(out.raters.size()));
  }
  for (const TrainingMark& mark : in.trainingMarks) {
    out.occasions[mark.occasion].marks[rank(out.trainees, mark.trainee)][rank(out.raters, mark.rater)] =
        pointsFromSteps(mark.steps, in.trainingScale);
  }
}

std::optional<NumberTable> complete(const OccasionMarks& occasion) {
  if (occasion.missing > 0 || occasion.marks.empty()) {
    return std::nullopt;
  }
  NumberTable table(occasion.marks.size(), occasion.marks.front().size());
  for (std::size_t i = 0; i < table.rows(); ++i) {
    for (std::size_t r = 0; r < table.columns(); ++r) {
      table.at(i, r) = *occasion.marks[i][r];
    }
  }
  return table;
}

void measureAgreement(OccasionMarks& occasion) {
  IncompleteRatings byRater(occasion.marks.empty() ? 0 : occasion.marks.front().size(),
                            std::vector<std::optional<double>>(occasion.marks.size()));
  for (std::size_t i = 0; i < occasion.marks.size(); ++i) {
    for (std::size_t r = 0; r < occasion.marks[i].size(); ++r) {
      byRater[r][i] = occasion.marks[i][r];
      ++(occasion.marks[i][r] ? occasion.n : occasion.missing);
    }
  }
  const std::optional<NumberTable> table = complete(occasion);
  occasion.icc =
      table ? intraclassCorrelation(*table) : Outcome<IccResult>::undefined(Text::tr("marks are missing"));
  occasion.alpha = krippendorffAlpha(byRater, AlphaMetric::kInterval);
}

/// Differences from the mean of the other raters, averaged over a trainee's scoring points first: the trainee
/// is the unit.
std::vector<RaterSeverity> severities(const StudyAnalysis& study) {
  std::vector<RaterSeverity> out;
  for (std::size_t r = 0; r < study.raters.size(); ++r) {
    std::vector<double> offsets;
    for (std::size_t i = 0; i < study.trainees.size(); ++i) {
      std::vector<double> own;
      for (const OccasionMarks& occasion : study.occasions) {
        const std::vector<std::optional<double>>& row = occasion.marks[i];
        if (!row[r]) {
          continue;
        }
        if (const std::optional<double> others = meanOfOthers(row, r)) {
          own.push_back(*row[r] - *others);
        }
      }
      if (!own.empty()) {
        offsets.push_back(meanOf(own));
      }
    }
    if (offsets.empty()) {
      continue;
    }
    RaterSeverity severity{study.raters[r], std::ssize(offsets), meanOf(offsets), {}};
    if (const std::optional<double> sd = sampleDeviation(offsets)) {
      const auto n = static_cast<double>(offsets.size());
      const double half = tQuantile(0.5 + 0.5 * kUsualConfidence, n - 1.0) * *sd / std::sqrt(n);
      severity.interval = Interval{severity.offset - half, severity.offset + half};
    }
    out.push_back(std::move(severity));
  }
  return out;
}

/// Scores of every scoring point by group, in the order of the trainee codes.
std::vector<std::optional<Groups>> scoresByGroup(const CohortInputs& in) {
  std::vector<std::size_t> members(in.groups.size(), 0);
  for (const CohortTrainee& trainee : in.trainees) {
    ++members[trainee.group];
  }
  std::vector<std::vector<std::map<std::string, double>>> found(
      in.occasions.size(), std::vector<std::map<std::string, double>>(in.groups.size()));
  for (const TraineeScore& score : in.scores) {
    found[score.occasion][score.group][score.trainee] = score.score;
  }
  std::vector<std::optional<Groups>> out;
  for (const auto& occasion : found) {
    Groups groups;
    bool whole = true;
    for (std::size_t g = 0; g < occasion.size(); ++g) {
      whole = whole && occasion[g].size() == members[g];
      groups.emplace_back();
      for (const auto& [code, score] : occasion[g]) {
        groups.back().push_back(score);
      }
    }
    out.push_back(whole ? std::optional<Groups>(std::move(groups)) : std::nullopt);
  }
  return out;
}

Outcome<MixedAnova> courseOf(const std::vector<std::optional<Groups>>& scores, std::size_t groupCount) {
  std::vector<NumberTable> groups;
  for (std::size_t g = 0; g < groupCount; ++g) {
    NumberTable table((*scores.front())[g].size(), scores.size());
    for (std::size_t t = 0; t < scores.size(); ++t) {
      for (std::size_t i = 0; i < table.rows(); ++i) {
        table.at(i, t) = (*scores[t])[g][i];
      }
    }
    groups.push_back(std::move(table));
  }
  return mixedAnova(groups);
}

}  // namespace

std::optional<double> meanOfOthers(const std::vector<std::optional<double>>& marks, std::size_t rater) {
  double sum = 0.0;
  std::int64_t others = 0;
  for (std::size_t k = 0; k < marks.size(); ++k) {
    if (k != rater && marks[k]) {
      sum += *marks[k];
      ++others;
    }
  }
  return others > 0 ? std::optional(sum / static_cast<double>(others)) : std::nullopt;
}

StudyAnalysis analyseStudy(const CohortInputs& in) {
  StudyAnalysis out;
  gatherMarks(in, out);
  for (OccasionMarks& occasion : out.occasions) {
    measureAgreement(occasion);
  }
  out.severity = severities(out);
  if (!out.occasions.empty()) {
    if (const std::optional<NumberTable> last = complete(out.occasions.back());
        last && last->columns() >= 2) {
      out.againstPanel = blandAltmanAgainstPanel(*last);
    }
  }
  out.scores = scoresByGroup(in);
  const bool whole = out.scores.size() >= 2 && std::all_of(out.scores.begin(), out.scores.end(),
                                                           [](const auto& at) { return at.has_value(); });
  if (!whole) {
    return out;
  }
  out.ancova = ancova(*out.scores.front(), *out.scores.back());
  out.course = courseOf(out.scores, in.groups.size());
  Groups gains;
  for (std::size_t g = 0; g < in.groups.size(); ++g) {
    const auto exact = exactGains(in.scores, 0, in.occasions.size() - 1, g);
    if (!exact) {
      return out;
    }
    gains.emplace_back();
    for (const std::int64_t gain : *exact) {
      gains.back().push_back(static_cast<double>(gain));
    }
  }
  out.wholeGains = {std::move(gains)};
  return out;
}

}  // namespace torsio
