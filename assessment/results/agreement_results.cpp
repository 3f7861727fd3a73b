// SPDX-License-Identifier: GPL-3.0-or-later
// Results about the raters of the training study: agreement, severity, raters needed.
#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "assessment/results/analysis_tables.h"
#include "assessment/results/report_sections.h"
#include "assessment/results/result_writer.h"
#include "assessment/statistics/descriptive.h"

namespace torsio {

namespace {

using enum ResultSection;

/// Adds the coefficients of a group by itself.
void addCoefficients(ResultWriter& rows, const GroupAgreement& of) {
  if (of.icc) {
    rows.addInterval("icc_2_1", of.icc->agreementSingle.estimate, of.icc->agreementSingle.interval,
                     of.trainees);
    rows.addInterval("icc_2_k", of.icc->agreementMean.estimate, of.icc->agreementMean.interval, of.trainees);
    rows.add("sem_agreement", of.icc->semAgreement, of.trainees);
    rows.add("sem_of_mean", of.icc->semMean, of.trainees);
  } else {
    rows.put("icc_2_1", Undefined{of.icc.reason()}, of.trainees);
    rows.put("icc_2_k", Undefined{of.icc.reason()}, of.trainees);
  }
  rows.addCount("trainees_with_every_mark", of.trainees, of.trainees);
}

/// Adds the dependability of one rater and of the mean of all, within the groups.
void addWithin(ResultWriter& rows, const OccasionMarks& at) {
  const std::int64_t n = at.completeTrainees;
  const auto all = static_cast<double>(std::max<std::size_t>(1, at.present.size()));
  for (const auto& [name, sem, raters] : {std::tuple("dependability_of_one_rater", "sem_agreement", 1.0),
                                          std::tuple("dependability_of_all_raters", "sem_of_mean", all)}) {
    const Outcome<DStudy> of =
        at.within ? dStudyPR(*at.within, raters) : Outcome<DStudy>::undefined(at.within.reason());
    if (of) {
      rows.addInterval(name, of->dependability, dependabilityInterval(*at.within, raters), n);
      rows.add(sem, std::sqrt(of->absoluteError), n);
    } else {
      rows.put(name, Undefined{of.reason()}, n);
    }
  }
  rows.addCount("trainees_with_every_mark", n, n);
}

/// Adds pairwise agreement of the raters in whole points.
void addPoints(ResultWriter& rows, const PointAgreement& points) {
  const std::vector<double>& kappas = points.kappas;
  const auto known = [&](auto summary) {
    return kappas.empty() ? std::nullopt : std::optional<double>(summary());
  };
  rows.addCount("rater_pairs", static_cast<std::int64_t>(points.pairs), points.shared);
  rows.add("kappa_quadratic_median", known([&] { return medianOf(kappas); }), points.shared);
  rows.add("kappa_quadratic_lowest", known([&] { return *std::min_element(kappas.begin(), kappas.end()); }),
           points.shared);
  rows.add("kappa_quadratic_highest", known([&] { return *std::max_element(kappas.begin(), kappas.end()); }),
           points.shared);
  const auto share = [&](std::int64_t part) {
    return points.shared > 0 ? std::optional(static_cast<double>(part) / static_cast<double>(points.shared))
                             : std::nullopt;
  };
  rows.add("share_same_point", share(points.same), points.shared);
  rows.add("share_within_one_point", share(points.withinOne), points.shared);
}

/// Adds how many raters are needed: variance components, and the result for each number of raters.
void addRatersNeeded(const CohortInputs& in, const StudyAnalysis& study, Ledger& ledger) {
  const RatersNeeded& needed = study.needed;
  const Outcome<GStudy>& components = study.occasions.back().within;
  if (!components) {
    return;
  }
  ResultWriter rows(ledger, {.section = kAgreement, .occasion = ledger.lastOccasion()}, commonFlags(in),
                    {"complete cases"});
  rows.madeOf = partsOf({marksAt(ledger.lastOccasion())});
  rows.add("variance_of_trainees", components->at("p").variance, needed.marks);
  rows.add("variance_of_raters", components->at("r").variance, needed.marks);
  rows.add("variance_of_rest", components->at("pr").variance, needed.marks);
  for (const auto& [name, fewest] :
       {std::pair("raters_needed", needed.fewest), {"raters_needed_by_estimate", needed.fewestByEstimate}}) {
    rows.add(name, fewest ? std::optional(static_cast<double>(*fewest)) : std::nullopt, needed.marks);
  }
  for (const RatersNeeded::Planned& planned : needed.planned) {
    rows.place.index = ratersIndex(planned.raters);
    rows.add("dependability", planned.study, &DStudy::dependability, needed.marks);
    if (planned.study && planned.dependability) {
      rows.put("dependability_95", *planned.dependability, needed.marks);
    }
    rows.add("generalizability", planned.study, &DStudy::generalizability, needed.marks);
    rows.add("standard_error_of_mean_mark",
             planned.study ? std::optional(std::sqrt(planned.study->absoluteError)) : std::nullopt,
             needed.marks);
  }
}

/// Adds the raters' severity on one scale.
void addRasch(const CohortInputs& in, const StudyAnalysis& study, Ledger& ledger) {
  if (!study.rasch) {
    return;
  }
  ResultWriter rows(ledger, {.section = kAgreement, .occasion = ledger.lastOccasion()}, commonFlags(in));
  rows.madeOf = partsOf({marksAt(ledger.lastOccasion())});
  const auto& marks = study.occasions.back().marks;
  for (std::size_t r = 0; r < study.raters.size(); ++r) {
    const RaschRater& rater = study.rasch->raters[r];
    rows.place.of = study.raters[r];
    const std::int64_t n =
        std::count_if(marks.begin(), marks.end(), [r](const auto& row) { return row[r].has_value(); });
    rows.add("rasch_severity", rater.severity, n);
    rows.add("rasch_error", rater.error, n);
    if (const std::optional<CorrectedSeverity>& own = study.onOneScale[r]) {
      rows.addInterval("rasch_severity_corrected", own->severity, own->interval, n);
    }
    rows.add("rasch_infit", rater.infit, n);
    rows.add("rasch_outfit", rater.outfit, n);
  }
}

/// Adds agreement at each occasion: within the groups, with missing marks if there are any, and in each
/// group.
void addAgreement(const CohortInputs& in, const StudyAnalysis& study, Ledger& ledger) {
  std::int64_t n = 0;
  std::int64_t missing = 0;
  for (std::size_t t = 0; t < study.occasions.size(); ++t) {
    const OccasionMarks& at = study.occasions[t];
    ResultWriter rows(ledger, {.section = kAgreement, .occasion = ledger.occasion(t)}, commonFlags(in),
                      flagIf(at.missing > 0, "marks missing"));
    rows.madeOf = partsOf({marksAt(ledger.occasion(t))});
    rows.addCount("marks", at.n, at.n);
    rows.addCount("marks_missing", at.missing, at.n + at.missing);
    n += at.n;
    missing += at.missing;
    addWithin(rows, at);
    if (at.missing > 0) {
      rows.addCount("trainees_with_marks", std::ssize(at.marks), at.n);
      rows.add("reml_one_rater", at.reliability, &IncompleteReliability::single, at.n);
      rows.add("reml_mean", at.reliability, &IncompleteReliability::mean, at.n);
      rows.add("reml_sem_of_one_rater", at.reliability, &IncompleteReliability::semSingle, at.n);
      rows.add("reml_sem_of_mean", at.reliability, &IncompleteReliability::semMean, at.n);
    }
    for (const GroupAgreement& of : at.groups) {
      rows.place.group = rows.group(of.group);
      rows.madeOf = partsOf({marksAt(ledger.occasion(t), ledger.group(of.group))});
      addCoefficients(rows, of);
      addPoints(rows, of.points);
    }
  }
  ResultWriter rows(ledger, {.section = kAgreement}, commonFlags(in));
  rows.madeOf = partsOf({marksAt({})});
  rows.addCount("marks", n, n);
  rows.addCount("marks_missing", missing, n + missing);
}

/// Adds the limits between which one rater's mark lies about the mean of the usual number of others. A
/// trainee has several of these differences, so they are not independent: the limits are calculated from the
/// variances of raters and residual, for one more rater.
void addLimits(const OccasionMarks& at, ResultWriter& rows) {
  if (!at.reliability || at.reliability->usualRaters < 2) {
    return;
  }
  const auto others = static_cast<std::int64_t>(at.reliability->usualRaters) - 1;
  rows.addCount("usual_number_of_others", others, at.n);
  rows.add("limit_against_others",
           kAgreementLimit * std::sqrt((at.reliability->varianceRaters + at.reliability->varianceResidual) *
                                       (1.0 + 1.0 / static_cast<double>(others))),
           at.n);
}

/// Adds each rater compared with the others: one value per trainee, so that the differences are independent.
void addRaters(const CohortInputs& in, const StudyAnalysis& study, Ledger& ledger) {
  ResultWriter rows(ledger, {.section = kAgreement}, commonFlags(in));
  rows.madeOf = partsOf({marksAt({})});
  std::int64_t trainees = 0;
  for (const RaterSeverity& rater : study.severity) {
    rows.place.of = rater.rater;
    rows.addInterval("severity_offset", rater.offset, rater.interval, rater.n);
    trainees += rater.n;
  }
  rows.place.of.clear();
  rows.addCount("trainees_of_every_rater", trainees, trainees);
  rows.place.occasion = ledger.lastOccasion();
  rows.madeOf = partsOf({marksAt(ledger.lastOccasion())});
  for (std::size_t r = 0; r < study.againstPanel.size(); ++r) {
    const Outcome<BlandAltmanResult>& against = study.againstPanel[r];
    rows.place.of = study.raters[r];
    if (!against) {
      rows.put("limit_of_agreement", Undefined{against.reason()}, 0);
      continue;
    }
    const auto n = static_cast<std::int64_t>(against->n);
    rows.add("mean_difference_from_others", against->meanDifference, n);
    rows.put("limit_of_agreement", against->limits, n);
  }
  rows.place.of.clear();
  addLimits(study.occasions.back(), rows);
}

/// Adds each mark of the last occasion against the mean of the other raters.
void addAgainstOthers(const CohortInputs& in, const StudyAnalysis& study, Ledger& ledger) {
  ResultWriter rows(ledger, {.section = kAgreement, .occasion = ledger.lastOccasion()}, commonFlags(in));
  std::int64_t count = 0;
  for (std::size_t i = 0; i < study.trainees.size(); ++i) {
    const std::vector<std::optional<double>>& marks = study.occasions.back().marks[i];
    rows.place.of = study.trainees[i];
    rows.madeOf = partsOf({ResultPattern{
        .statistic = "rater_mark", .of = study.trainees[i], .occasion = ledger.lastOccasion()}});
    for (std::size_t r = 0; r < marks.size(); ++r) {
      if (const std::optional<double> others = marks[r] ? meanOfOthers(marks, r) : std::nullopt) {
        rows.place.index = study.raters[r];
        rows.add(kMarkAndOthers, 0.5 * (*marks[r] + *others), 1);
        rows.add(kMarkMinusOthers, *marks[r] - *others, 1);
        ++count;
      }
    }
  }
  rows.place = {.section = kAgreement, .occasion = ledger.lastOccasion()};
  rows.madeOf = partsOf({marksAt(ledger.lastOccasion())});
  rows.addCount("marks_with_others", count, count);
}

/// Adds how many raters are missing at one end of the study, or for some of the groups.
void addAbsentRaters(const CohortInputs& in, const StudyAnalysis& study, Ledger& ledger) {
  ResultWriter rows(ledger, {.section = kAgreement}, commonFlags(in));
  rows.madeOf = partsOf({marksAt(ledger.occasion(0)), marksAt(ledger.lastOccasion())});
  const std::int64_t raters = std::ssize(study.raters);
  for (const std::size_t t : std::set{std::size_t{0}, lastOf(in)}) {
    rows.place.occasion = rows.occasion(t);
    rows.addCount("raters_absent", std::ssize(absentRaters(study, t)), raters);
  }
  rows.addCount("raters_of_some_groups", std::ssize(ratersOfSomeGroups(in)), raters);
}

}  // namespace

std::vector<std::string> absentRaters(const StudyAnalysis& study, std::size_t occasion) {
  const std::vector<std::size_t>& here = study.occasions[occasion].present;
  const OccasionMarks& there = occasion == 0 ? study.occasions.back() : study.occasions.front();
  std::vector<std::string> codes;
  for (const std::size_t r : there.present) {
    if (std::find(here.begin(), here.end(), r) == here.end()) {
      codes.push_back(study.raters[r]);
    }
  }
  return codes;
}

std::vector<std::string> ratersOfSomeGroups(const CohortInputs& in) {
  std::map<std::string, std::set<std::size_t>> groupsOf;  // at the last occasion, by rater
  std::set<std::size_t> marked;
  for (const TrainingMark& mark : in.trainingMarks) {
    if (mark.occasion == lastOf(in)) {
      groupsOf[mark.rater].insert(mark.group);
      marked.insert(mark.group);
    }
  }
  std::vector<std::string> codes;
  for (const auto& [rater, groups] : groupsOf) {
    if (groups.size() < marked.size()) {
      codes.push_back(rater);
    }
  }
  return codes;
}

std::string ratersIndex(std::size_t raters) {
  return "raters " + std::to_string(raters);
}

void addAgreementResults(const CohortInputs& in, const StudyAnalysis& study, Ledger& ledger) {
  addAgreement(in, study, ledger);
  addRaters(in, study, ledger);
  addAgainstOthers(in, study, ledger);
  addAbsentRaters(in, study, ledger);
  if (study.raters.size() >= 2) {
    addRatersNeeded(in, study, ledger);
    addRasch(in, study, ledger);
  }
}

}  // namespace torsio
