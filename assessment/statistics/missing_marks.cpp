// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/statistics/missing_marks.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "assessment/statistics/descriptive.h"
#include "assessment/statistics/multiplicity.h"

namespace torsio {

namespace {

std::size_t given(const std::vector<std::optional<double>>& marks) {
  return static_cast<std::size_t>(
      std::count_if(marks.begin(), marks.end(), [](const auto& mark) { return mark.has_value(); }));
}

/// Returns the most frequent positive number of marks per trainee; ties: the larger one. `traineesWith`:
/// number of trainees by number of marks.
std::size_t mostFrequent(const std::map<std::size_t, std::size_t>& traineesWith) {
  std::size_t usual = 0;
  std::size_t most = 0;
  for (const auto& [number, count] : traineesWith) {
    if (number > 0 && count >= most) {
      usual = number;
      most = count;
    }
  }
  return usual;
}

std::size_t usualNumber(const std::vector<MarkedTrainee>& trainees,
                        std::vector<std::optional<double>> MarkedTrainee::*occasion) {
  std::map<std::size_t, std::size_t> traineesWith;
  for (const MarkedTrainee& trainee : trainees) {
    ++traineesWith[given(trainee.*occasion)];
  }
  return mostFrequent(traineesWith);
}

/// Returns a trainee's score with `missing` marks imputed as `as`.
std::optional<double> filled(const std::vector<std::optional<double>>& marks, std::size_t missing,
                             double as) {
  std::vector<double> all(missing, as);
  for (const std::optional<double>& mark : marks) {
    if (mark) {
      all.push_back(*mark);
    }
  }
  if (all.empty()) {
    return std::nullopt;
  }
  const double mean = meanOf(all);
  // If the sum overflows, return the largest mark, which is too large for the statistics as well.
  return std::isfinite(mean) ? mean : *std::max_element(all.begin(), all.end());
}

Outcome<AdjustedDifference> pairOf(const Outcome<Ancova>& of, std::size_t first, std::size_t second) {
  if (!of) {
    return Outcome<AdjustedDifference>::undefined(of.reason());
  }
  for (const AdjustedDifference& pair : of->pairs) {
    if (pair.first == first && pair.second == second) {
      return pair;
    }
  }
  return Outcome<AdjustedDifference>::undefined(Text::tr("a group is empty"));
}

}  // namespace

std::optional<double> meanMark(const std::vector<std::optional<double>>& marks) {
  return filled(marks, 0, 0.0);
}

CompleteCases completeCases(const std::vector<MarkedTrainee>& trainees, std::size_t groups) {
  CompleteCases out;
  out.before.resize(groups);
  out.after.resize(groups);
  for (std::size_t i = 0; i < trainees.size(); ++i) {
    const std::optional<double> before = meanMark(trainees[i].before);
    const std::optional<double> after = meanMark(trainees[i].after);
    if (before && after) {
      out.before[trainees[i].group].push_back(*before);
      out.after[trainees[i].group].push_back(*after);
    } else {
      out.leftOut.push_back(i);
    }
  }
  return out;
}

namespace {

/// Trainees with a mark at both occasions, and their marks at the end.
struct Participants {
  std::vector<CrossedMark> marks;
  std::vector<double> before;
  std::vector<std::size_t> group;
};

Participants participantsOf(const std::vector<MarkedTrainee>& trainees) {
  Participants out;
  std::map<std::size_t, std::size_t> numberOf;  // of the raters who gave any of these marks
  for (const MarkedTrainee& trainee : trainees) {
    const std::optional<double> score = meanMark(trainee.before);
    if (!score || given(trainee.after) == 0) {
      continue;
    }
    for (std::size_t r = 0; r < trainee.after.size(); ++r) {
      if (trainee.after[r]) {
        const std::size_t rater = numberOf.emplace(r, numberOf.size()).first->second;
        out.marks.push_back({out.before.size(), rater, *trainee.after[r]});
      }
    }
    out.before.push_back(*score);
    out.group.push_back(trainee.group);
  }
  return out;
}

/// Design matrix: one mean per group, and the slope on the score before.
NumberTable fixedPart(const Participants& of, const std::vector<std::size_t>& groups, double middle) {
  NumberTable fixed(of.before.size(), groups.size() + 1);
  for (std::size_t i = 0; i < of.before.size(); ++i) {
    const auto at = std::lower_bound(groups.begin(), groups.end(), of.group[i]);
    fixed.at(i, static_cast<std::size_t>(at - groups.begin())) = 1.0;
    fixed.at(i, groups.size()) = of.before[i] - middle;
  }
  return fixed;
}

void addContrasts(const CrossedModel& model, double confidence, MixedComparison& out) {
  const std::size_t groups = out.groups.size();
  const auto weights = [groups](std::size_t plus, std::optional<std::size_t> minus) {
    std::vector<double> of(groups + 1, 0.0);
    of[plus] = 1.0;
    if (minus) {
      of[*minus] = -1.0;
    }
    return of;
  };
  out.slope = model.estimate(weights(groups, std::nullopt), confidence);
  std::vector<std::vector<double>> contrasts;
  std::vector<double> p;
  const double number = 0.5 * static_cast<double>(groups * (groups - 1));
  for (std::size_t g = 0; g < groups; ++g) {
    out.adjusted.push_back(model.estimate(weights(g, std::nullopt), confidence));
    if (g > 0) {
      contrasts.push_back(weights(0, g));
    }
    for (std::size_t h = g + 1; h < groups; ++h) {
      const std::vector<double> of = weights(g, h);
      MixedComparison::Pair pair{out.groups[g], out.groups[h], model.estimate(of, confidence), {}, 0.0, {}};
      pair.simultaneous = model.estimate(of, 1.0 - (1.0 - confidence) / number).interval;
      p.push_back(pair.difference.p);
      out.pairs.push_back(pair);
    }
  }
  const std::vector<double> adjusted = adjustHolm(p);
  const std::vector<double> factors = holmFactors(p);
  for (std::size_t i = 0; i < adjusted.size(); ++i) {
    MixedComparison::Pair& pair = out.pairs[i];
    pair.pHolm = adjusted[i];
    const ModelEstimate& of = pair.difference;
    pair.asHolm = holmInterval(of.value, of.error, of.df, factors[i], confidence);
  }
  out.group = model.test(contrasts);
}

}  // namespace

Outcome<MixedComparison> mixedComparison(const std::vector<MarkedTrainee>& trainees, std::size_t groups,
                                         double confidence) {
  using Undefined = Outcome<MixedComparison>;
  const Participants part = participantsOf(trainees);
  if (const std::optional<Text> reason = beyondArithmetic(part.before)) {
    return Undefined::undefined(*reason);
  }
  MixedComparison out;
  for (std::size_t g = 0; g < groups; ++g) {
    if (std::find(part.group.begin(), part.group.end(), g) != part.group.end()) {
      out.groups.push_back(g);
    }
  }
  if (out.groups.size() < 2) {
    return Undefined::undefined(Text::tr("fewer than two groups have scores at both occasions"));
  }
  out.trainees = part.before.size();
  out.covariateMean = meanOf(part.before);
  const Outcome<CrossedModel> model =
      CrossedModel::fit(part.marks, fixedPart(part, out.groups, out.covariateMean));
  if (!model) {
    return Undefined::undefined(model.reason());
  }
  out.marks = model->marks();
  out.varianceTrainees = model->varianceTargets();
  out.varianceRaters = model->varianceRaters();
  out.varianceResidual = model->varianceResidual();
  out.criterion = model->criterion();
  addContrasts(*model, confidence, out);
  return out;
}

Outcome<IncompleteReliability> incompleteReliability(const IncompleteRatings& codersByUnit,
                                                     const std::vector<std::size_t>& groupOf) {
  std::vector<CrossedMark> marks;
  std::map<std::size_t, std::size_t> unitOf;
  std::map<std::size_t, std::size_t> marksOf;
  std::size_t raters = 0;
  for (const std::vector<std::optional<double>>& coder : codersByUnit) {
    const std::size_t before = marks.size();
    for (std::size_t unit = 0; unit < coder.size(); ++unit) {
      if (coder[unit]) {
        marks.push_back({unitOf.emplace(unit, unitOf.size()).first->second, raters, *coder[unit]});
        ++marksOf[unit];
      }
    }
    raters += marks.size() > before ? 1 : 0;
  }
  std::map<std::size_t, std::size_t> unitsWith;
  for (const auto& [unit, number] : marksOf) {
    ++unitsWith[number];
  }
  std::map<std::size_t, std::size_t> columnOf;  // of a group with marks
  for (const auto& [unit, row] : unitOf) {
    columnOf.emplace(groupOf.empty() ? 0 : groupOf[unit], columnOf.size());
  }
  NumberTable level(unitOf.size(), columnOf.size());
  for (const auto& [unit, row] : unitOf) {
    level.at(row, columnOf.at(groupOf.empty() ? 0 : groupOf[unit])) = 1.0;
  }
  const Outcome<CrossedModel> model = CrossedModel::fit(marks, level);
  if (!model) {
    return Outcome<IncompleteReliability>::undefined(model.reason());
  }
  IncompleteReliability out;
  out.marks = marks.size();
  out.usualRaters = mostFrequent(unitsWith);
  out.varianceTargets = model->varianceTargets();
  out.varianceRaters = model->varianceRaters();
  out.varianceResidual = model->varianceResidual();
  const double error = out.varianceRaters + out.varianceResidual;
  const double errorOfMean = error / static_cast<double>(out.usualRaters);
  out.single = out.varianceTargets / (out.varianceTargets + error);
  out.mean = out.varianceTargets / (out.varianceTargets + errorOfMean);
  out.semSingle = std::sqrt(error);
  out.semMean = std::sqrt(errorOfMean);
  return out;
}

std::vector<MissingCount> missingMarks(const std::vector<MarkedTrainee>& trainees) {
  const std::size_t before = usualNumber(trainees, &MarkedTrainee::before);
  const std::size_t after = usualNumber(trainees, &MarkedTrainee::after);
  const auto shortOf = [](std::size_t usual, std::size_t has) { return usual > has ? usual - has : 0; };
  std::vector<MissingCount> out;
  out.reserve(trainees.size());
  for (const MarkedTrainee& trainee : trainees) {
    out.push_back({shortOf(before, given(trainee.before)), shortOf(after, given(trainee.after))});
  }
  return out;
}

std::vector<MissingBounds> missingBounds(const std::vector<MarkedTrainee>& trainees, std::size_t groups,
                                         double lowest, double highest) {
  const std::vector<MissingCount> missing = missingMarks(trainees);
  std::vector<double> known;
  for (const MarkedTrainee& trainee : trainees) {
    if (const std::optional<double> score = meanMark(trainee.before)) {
      known.push_back(*score);
    }
  }
  const auto analysed = [&](std::size_t low, std::size_t high) {
    Groups before(groups);
    Groups after(groups);
    for (std::size_t i = 0; i < trainees.size(); ++i) {
      const std::size_t g = trainees[i].group;
      const bool inPair = g == low || g == high;
      const std::optional<double> score =
          filled(trainees[i].after, inPair ? missing[i].after : 0, g == low ? lowest : highest);
      if (score && !known.empty()) {
        before[g].push_back(meanMark(trainees[i].before).value_or(meanOf(known)));
        after[g].push_back(*score);
      }
    }
    return ancova(before, after);
  };
  std::vector<MissingBounds> out;
  for (std::size_t g = 0; g < groups; ++g) {
    for (std::size_t h = g + 1; h < groups; ++h) {
      out.push_back({g, h, pairOf(analysed(g, h), g, h), pairOf(analysed(h, g), g, h)});
    }
  }
  return out;
}

}  // namespace torsio
