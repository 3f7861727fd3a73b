// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/results/study_analysis.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "assessment/results/received_training.h"
#include "assessment/results/study_parts.h"
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

void findPresent(OccasionMarks& occasion) {
  const std::size_t raters = occasion.marks.empty() ? 0 : occasion.marks.front().size();
  for (std::size_t r = 0; r < raters; ++r) {
    if (std::any_of(occasion.marks.begin(), occasion.marks.end(),
                    [r](const auto& marks) { return marks[r].has_value(); })) {
      occasion.present.push_back(r);
    }
  }
}

void measureAgreement(const CohortInputs& in, const std::vector<std::size_t>& groupOf,
                      OccasionMarks& occasion) {
  findPresent(occasion);
  IncompleteRatings byRater;
  std::vector<NumberTable> within;
  for (const std::size_t r : occasion.present) {
    byRater.emplace_back();
    for (const std::vector<std::optional<double>>& marks : occasion.marks) {
      byRater.back().push_back(marks[r]);
      ++(marks[r] ? occasion.n : occasion.missing);
    }
  }
  occasion.reliability = incompleteReliability(byRater, groupOf);
  for (std::size_t g = 0; g < in.groups.size(); ++g) {
    within.push_back(completeMarks(occasion, groupOf, g));
    const auto trainees = static_cast<std::int64_t>(within.back().rows());
    occasion.completeTrainees += trainees;
    occasion.groups.push_back({g, trainees, intraclassCorrelation(within.back()), {}});
  }
  occasion.within = gStudyPRWithin(within);
}

/// Returns differences from the mean of the other raters, averaged first over a trainee's occasions: the
/// trainee is the unit.
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
      const double half = tQuantile(0.5 + 0.5 * kDefaultConfidence, n - 1.0) * *sd / std::sqrt(n);
      severity.interval = Interval{severity.offset - half, severity.offset + half};
    }
    out.push_back(std::move(severity));
  }
  return out;
}

/// Marks of all allocated trainees at the first and last occasion, by code.
struct Ends {
  std::vector<std::string> codes;
  std::vector<MarkedTrainee> trainees;
};

Ends endsOf(const CohortInputs& in, const StudyAnalysis& study) {
  std::map<std::string, std::size_t> groupOf;
  for (const CohortTrainee& trainee : in.trainees) {
    groupOf[trainee.code] = trainee.group;
  }
  for (const TrainingMark& mark : in.trainingMarks) {
    groupOf[mark.trainee] = mark.group;
  }
  const std::vector<std::optional<double>> none(study.raters.size());
  Ends out;
  for (const auto& [code, group] : groupOf) {
    const std::size_t at = rank(study.trainees, code);
    const bool marked = at < study.trainees.size() && study.trainees[at] == code;
    out.codes.push_back(code);
    out.trainees.push_back({group, marked ? study.occasions.front().marks[at] : none,
                            marked ? study.occasions.back().marks[at] : none});
  }
  return out;
}

/// Returns whether all trainees with marks were marked by the same raters.
bool sameRatersOf(const OccasionMarks& occasion) {
  std::set<std::vector<bool>> patterns;
  for (const std::vector<std::optional<double>>& marks : occasion.marks) {
    std::vector<bool> given;
    for (const std::optional<double>& mark : marks) {
      given.push_back(mark.has_value());
    }
    if (std::find(given.begin(), given.end(), true) != given.end()) {
      patterns.insert(std::move(given));
    }
  }
  return patterns.size() <= 1;
}

void compareEnds(const CohortInputs& in, StudyAnalysis& out) {
  const Ends ends = endsOf(in, out);
  out.ends = completeCases(ends.trainees, in.groups.size());
  out.endCodes.resize(in.groups.size());
  const std::vector<MissingCount> counts = missingMarks(ends.trainees);
  for (std::size_t i = 0; i < counts.size(); ++i) {
    const bool leftOut = std::binary_search(out.ends.leftOut.begin(), out.ends.leftOut.end(), i);
    if (!leftOut) {
      out.endCodes[ends.trainees[i].group].push_back(ends.codes[i]);
    }
    out.endMissing += static_cast<std::int64_t>(counts[i].before + counts[i].after);
    if (leftOut || counts[i].before + counts[i].after > 0) {
      out.missing.push_back({ends.codes[i], ends.trainees[i].group, counts[i], leftOut});
    }
  }
  out.endMarks = out.occasions.front().n + out.occasions.back().n;
  out.sameRaters = sameRatersOf(out.occasions.back());
  out.ancova = ancova(out.ends.before, out.ends.after);
  if (out.ancova && out.ancova->equalSlopes && out.ancova->equalSlopes->p < kSlopesDiffer) {
    out.slopes = separateSlopes(out.ends.before, out.ends.after, defaultBaselines(out.ends.before));
  }
  if (!out.asPlanned()) {
    out.mixed = mixedComparison(ends.trainees, in.groups.size());
  }
  if (!out.missing.empty()) {
    out.bounds =
        missingBounds(ends.trainees, in.groups.size(), pointsFromSteps(in.trainingScale.lo, in.trainingScale),
                      pointsFromSteps(in.trainingScale.hi, in.trainingScale));
  }
}

/// Repeats the comparison without the trainees who were not trained as planned.
void compareAsTreated(const CohortInputs& in, StudyAnalysis& out) {
  std::set<std::string> otherwise;
  for (const ReceivedTraining& one : receivedTraining(in)) {
    if (one.received != Received::kAsPlanned) {
      otherwise.insert(one.trainee);
    }
  }
  if (otherwise.empty()) {
    return;
  }
  CompleteCases kept = out.ends;
  for (std::size_t g = 0; g < out.endCodes.size(); ++g) {
    for (std::size_t i = out.endCodes[g].size(); i-- > 0;) {
      if (otherwise.contains(out.endCodes[g][i])) {
        kept.before[g].erase(kept.before[g].begin() + static_cast<std::ptrdiff_t>(i));
        kept.after[g].erase(kept.after[g].begin() + static_cast<std::ptrdiff_t>(i));
      } else {
        out.perProtocolCodes.push_back(out.endCodes[g][i]);
      }
    }
  }
  out.perProtocol = ancova(kept.before, kept.after);
}

/// Computes the course over the occasions for trainees with a score at each.
void followCourse(const CohortInputs& in, StudyAnalysis& out) {
  std::map<std::string, std::vector<std::optional<double>>> byTrainee;
  std::map<std::string, std::size_t> groupOf;
  for (const CohortTrainee& trainee : in.trainees) {
    byTrainee[trainee.code].resize(in.occasions.size());
    groupOf[trainee.code] = trainee.group;
  }
  for (const TraineeScore& score : in.scores) {
    byTrainee[score.trainee].resize(in.occasions.size());
    byTrainee[score.trainee][score.occasion] = score.score;
    groupOf[score.trainee] = score.group;
  }
  std::vector<std::vector<std::vector<double>>> rows(in.groups.size());
  for (const auto& [code, scores] : byTrainee) {
    std::vector<double> row;
    for (const std::optional<double>& score : scores) {
      if (score) {
        row.push_back(*score);
      }
    }
    if (row.size() == in.occasions.size()) {
      rows[groupOf[code]].push_back(std::move(row));
    } else {
      out.leftOutOfCourse.push_back(code);
    }
  }
  for (const std::vector<std::vector<double>>& group : rows) {
    out.courses.emplace_back(group);
  }
  out.course = mixedAnova(out.courses);
}

}  // namespace

NumberTable completeMarks(const OccasionMarks& occasion, const std::vector<std::size_t>& groupOf,
                          std::optional<std::size_t> only) {
  std::vector<std::vector<double>> rows;
  for (std::size_t i = 0; i < occasion.marks.size(); ++i) {
    if (only && groupOf[i] != *only) {
      continue;
    }
    std::vector<double> row;
    for (const std::size_t r : occasion.present) {
      if (occasion.marks[i][r]) {
        row.push_back(*occasion.marks[i][r]);
      }
    }
    if (row.size() == occasion.present.size()) {
      rows.push_back(std::move(row));
    }
  }
  return NumberTable(rows);
}

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

bool StudyAnalysis::spreadsDiffer() const noexcept {
  return ancova && ancova->spread.test && ancova->spread.test->p < kSpreadsDiffer;
}

PrimaryMethod StudyAnalysis::primaryMethod() const noexcept {
  if (mixed) {
    return PrimaryMethod::kMixed;
  }
  if (!ancova) {
    return PrimaryMethod::kNone;
  }
  if (sites && sites->together) {
    return PrimaryMethod::kCentres;
  }
  return ancova->spread.pairs.empty() ? PrimaryMethod::kCovariance : PrimaryMethod::kRobust;
}

bool StudyAnalysis::allowsForSpreads() const noexcept {
  const PrimaryMethod method = primaryMethod();
  return method == PrimaryMethod::kRobust ||
         (method == PrimaryMethod::kCentres && sites->term == SiteTerm::kFixed);
}

Text primaryMethodText(const StudyAnalysis& study) {
  switch (study.primaryMethod()) {
    case PrimaryMethod::kMixed:
      return Text::tr("linear mixed model, restricted maximum likelihood");
    case PrimaryMethod::kRobust:
      return Text::tr("analysis of covariance, one pooled slope, HC3");
    case PrimaryMethod::kCovariance:
      return Text::tr("analysis of covariance, one pooled slope");
    case PrimaryMethod::kCentres:
      return study.sites->term == SiteTerm::kFixed
                 ? Text::tr("analysis of covariance with the centre as a fixed factor, one pooled slope, HC3")
                 : Text::tr("analysis of covariance with the centre as a random effect, one pooled slope");
    case PrimaryMethod::kNone:
      break;
  }
  return {};
}

PrimaryStatistics primaryStatistics(PrimaryMethod method) noexcept {
  switch (method) {
    case PrimaryMethod::kMixed:
      return {"mixed_model_difference", "mixed_model_difference_holm_95", "mixed_model_p_holm"};
    case PrimaryMethod::kRobust:
      return {"robust_difference", "robust_difference_holm_95", "robust_p_holm"};
    case PrimaryMethod::kCovariance:
      return {"adjusted_difference", "adjusted_difference_holm_95", "p_holm"};
    case PrimaryMethod::kCentres:
      return {"centre_difference", "centre_difference_holm_95", "centre_difference_p_holm"};
    case PrimaryMethod::kNone:
      break;
  }
  return {};
}

std::vector<PrimaryDifference> primaryDifferences(const StudyAnalysis& study) {
  std::vector<PrimaryDifference> out;
  if (study.mixed) {
    for (const MixedComparison::Pair& pair : study.mixed->pairs) {
      const ModelEstimate& of = pair.difference;
      out.push_back({pair.first, pair.second, of.value, of.error, of.df, pair.pHolm, pair.asHolm});
    }
  } else if (study.ancova) {
    const bool centres = study.primaryMethod() == PrimaryMethod::kCentres;
    for (const AdjustedDifference& pair :
         centres ? study.sites->together->pairs : concludedPairs(*study.ancova)) {
      out.push_back({pair.first, pair.second, pair.difference, pair.error, pair.df, pair.pHolm, pair.asHolm});
    }
  }
  return out;
}

std::vector<std::vector<std::int64_t>> missingByGroup(const CohortInputs& in) {
  std::map<std::string, std::vector<MarkedTrainee>> byTrainee;  // one entry per occasion
  const auto entry = [&](const std::string& code, std::size_t group) -> std::vector<MarkedTrainee>& {
    return byTrainee.try_emplace(code, in.occasions.size(), MarkedTrainee{group, {}, {}}).first->second;
  };
  for (const CohortTrainee& trainee : in.trainees) {
    entry(trainee.code, trainee.group);
  }
  for (const TrainingMark& mark : in.trainingMarks) {
    entry(mark.trainee, mark.group)[mark.occasion].before.emplace_back(0.0);
  }
  std::vector<std::vector<std::int64_t>> out(in.groups.size(),
                                             std::vector<std::int64_t>(in.occasions.size(), 0));
  for (std::size_t t = 0; t < in.occasions.size(); ++t) {
    std::vector<MarkedTrainee> all;
    for (const auto& [code, occasions] : byTrainee) {
      all.push_back(occasions[t]);
    }
    const std::vector<MissingCount> counts = missingMarks(all);
    for (std::size_t i = 0; i < all.size(); ++i) {
      out[all[i].group][t] += static_cast<std::int64_t>(counts[i].before);
    }
  }
  return out;
}

std::vector<std::size_t> groupsWithoutEnds(const StudyAnalysis& study) {
  std::vector<std::size_t> out;
  for (std::size_t g = 0; g < study.ends.after.size(); ++g) {
    if (study.ends.after[g].empty()) {
      out.push_back(g);
    }
  }
  return out;
}

StudyAnalysis analyseStudy(const CohortInputs& in) {
  StudyAnalysis out;
  gatherMarks(in, out);
  out.groupOf.resize(out.trainees.size(), 0);
  for (const TrainingMark& mark : in.trainingMarks) {
    out.groupOf[rank(out.trainees, mark.trainee)] = mark.group;
  }
  for (OccasionMarks& occasion : out.occasions) {
    measureAgreement(in, out.groupOf, occasion);
  }
  out.severity = severities(out);
  if (out.occasions.empty()) {
    return out;
  }
  addRaterModels(out);
  out.againstPanel.assign(
      out.raters.size(), Outcome<BlandAltmanResult>::undefined(Text::tr("too few trainees with every mark")));
  const OccasionMarks& end = out.occasions.back();
  if (const NumberTable last = completeMarks(end); last.rows() >= 2 && last.columns() >= 2) {
    std::vector<Outcome<BlandAltmanResult>> found = blandAltmanAgainstPanel(last);
    for (std::size_t i = 0; i < found.size(); ++i) {
      out.againstPanel[end.present[i]] = std::move(found[i]);
    }
  }
  if (out.occasions.size() < 2) {
    return out;
  }
  compareEnds(in, out);
  compareAsTreated(in, out);
  out.sites = analyseSites(in, out.ends, out.endCodes);
  followCourse(in, out);
  addGains(in, out);
  return out;
}

}  // namespace torsio
