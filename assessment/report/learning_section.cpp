// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <map>

#include "assessment/report/number_format.h"
#include "assessment/report/report_sections.h"
#include "assessment/statistics/curve_fit.h"
#include "assessment/statistics/cusum.h"
#include "assessment/statistics/descriptive.h"
#include "assessment/statistics/distributions.h"

namespace torsio {

namespace {

/// All twists of one trainee in the order in which they were recorded.
struct Course {
  std::string trainee;
  std::size_t group = 0;
  std::vector<TwistAttempt> attempts;
};

std::vector<Course> courses(const CohortInputs& in) {
  std::map<std::string, Course> byTrainee;
  for (const TrialSummaryRow& trial : in.trials) {
    Course& course = byTrainee[trial.trainee];
    course.trainee = trial.trainee;
    course.group = trial.group;
    course.attempts.insert(course.attempts.end(), trial.attempts.begin(), trial.attempts.end());
  }
  std::vector<Course> out;
  for (auto& [code, course] : byTrainee) {
    if (!course.attempts.empty()) {
      out.push_back(std::move(course));
    }
  }
  std::stable_sort(out.begin(), out.end(),
                   [](const Course& a, const Course& b) { return a.group < b.group; });
  return out;
}

std::size_t longest(const std::vector<Course>& all) {
  std::size_t most = 0;
  for (const Course& course : all) {
    most = std::max(most, course.attempts.size());
  }
  return most;
}

/// Mean error of a group at its n-th twist with a 95 % interval over the trainees who made it.
ReportFigure learningFigure(const CohortInputs& in, const std::vector<Course>& all) {
  ReportFigure figure = itemOf<ReportFigure>(
      in, "figure-learning", Text::tr("Angle error by twist, mean of the trainees with 95 % interval"),
      Text::tr("mean of the absolute error over trainees, Student's t"));
  figure.kind = FigureKind::kLines;
  figure.xLabel = Text::tr("number of the twist");
  figure.yLabel = Text::tr("absolute angle error (deg)");
  figure.yMin = 0.0;
  for (std::size_t g = 0; g < in.groups.size(); ++g) {
    FigureSeries series;
    series.name = in.groups[g].name;
    series.look = g;
    for (std::size_t n = 0; n < longest(all); ++n) {
      std::vector<double> errors;
      for (const Course& course : all) {
        if (course.group == g && n < course.attempts.size()) {
          errors.push_back(course.attempts[n].error_deg);
        }
      }
      if (std::ssize(errors) < 2) {
        continue;
      }
      const double mean = meanOf(errors);
      const auto count = static_cast<double>(errors.size());
      const double half =
          tQuantile(0.5 + 0.5 * kUsualConfidence, count - 1.0) * *sampleDeviation(errors) / std::sqrt(count);
      series.x.push_back(static_cast<double>(n + 1));
      series.y.emplace_back(mean);
      series.low.push_back(std::max(0.0, mean - half));
      series.high.push_back(mean + half);
      figure.provenance.n += std::ssize(errors);
    }
    if (!series.y.empty()) {
      figure.series.push_back(series);
    }
  }
  figure.notes = {
      Text::tr("Twists on the simulator only; a point needs at least two trainees. Fewer trainees make more "
               "twists, so that the last points rest on few.")};
  return figure;
}

ReportFigure cusumFigure(const CohortInputs& in, const std::vector<Course>& all,
                         const LcCusumDesign& design) {
  ReportFigure figure = itemOf<ReportFigure>(in, "figure-lc-cusum", Text::tr("LC-CUSUM of every trainee"),
                                             Text::tr("LC-CUSUM, Biau and Porcher 2010"));
  figure.kind = FigureKind::kLines;
  figure.individual = true;
  figure.xLabel = Text::tr("number of the twist");
  figure.yLabel = Text::tr("cumulative sum");
  figure.yMin = 0.0;
  std::vector<bool> named(in.groups.size(), false);
  for (const Course& course : all) {
    std::vector<bool> failed;
    for (const TwistAttempt& attempt : course.attempts) {
      failed.push_back(!attempt.onTarget);
    }
    const LcCusum sums = lcCusum(failed, design);
    FigureSeries series;
    series.name = course.trainee;
    series.look = course.group;
    series.faint = true;
    for (std::size_t i = 0; i < sums.sums.size(); ++i) {
      series.x.push_back(static_cast<double>(i + 1));
      series.y.emplace_back(sums.sums[i]);
    }
    figure.provenance.n += std::ssize(sums.sums);
    figure.series.push_back(series);
  }
  figure.references = {{design.limit, Text::tr("adequate")}};
  figure.notes = {Text::tr(
      "A twist within the tolerance counts as success. Adequate: a failure rate of %1 against %2; a "
      "trainee whose sum reaches %3 is held to be adequate. Sums cannot fall below zero.",
      formatFixed(design.adequate, 2), formatFixed(design.inadequate, 2), formatFixed(design.limit, 2))};
  return figure;
}

ReportTable learningTable(const CohortInputs& in, const std::vector<Course>& all,
                          const LcCusumDesign& design) {
  ReportTable table =
      itemOf<ReportTable>(in, "table-learning", Text::tr("Learning of every trainee on the simulator"),
                          Text::tr("exponential learning curve; LC-CUSUM"));
  table.individual = true;
  table.columns = {Text::tr("Group"),
                   Text::tr("Trainee"),
                   Text::tr("Twists"),
                   Text::tr("On target"),
                   Text::tr("Mean error, first half (deg)"),
                   Text::tr("Second half (deg)"),
                   Text::tr("Error left in the end (deg)"),
                   Text::tr("Adequate at twist")};
  for (const Course& course : all) {
    std::vector<double> number;
    std::vector<double> error;
    std::vector<bool> failed;
    for (const TwistAttempt& attempt : course.attempts) {
      number.push_back(static_cast<double>(number.size() + 1));
      error.push_back(attempt.error_deg);
      failed.push_back(!attempt.onTarget);
    }
    const std::size_t half = error.size() / 2;
    const std::span<const double> values(error);
    const Outcome<LearningCurve> fit = fitLearningCurve(LearningFamily::kExponential, number, error);
    const std::optional<std::size_t> adequate = lcCusum(failed, design).competentAt;
    table.rows.push_back(
        {in.groups[course.group].name, course.trainee, std::to_string(error.size()),
         std::to_string(std::count(failed.begin(), failed.end(), false)),
         half > 0 ? Text(formatFixed(meanOf(values.first(half)), 2)) : Text::tr("too few"),
         formatFixed(meanOf(values.subspan(half)), 2),
         fit ? Text(formatFixed(fit->asymptote, 2)) : Text::tr("not fitted: %1", Text(fit.reason())),
         adequate ? Text(std::to_string(*adequate)) : Text::tr("not yet")});
    table.provenance.n += std::ssize(error);
  }
  table.notes = {Text::tr(
      "Each trainee is fitted alone; eight twists are the fewest for a curve with three parameters.")};
  return table;
}

ReportTable doseTable(const CohortInputs& in) {
  ReportTable table = itemOf<ReportTable>(in, "table-dose", Text::tr("Time spent training and resting"),
                                          Text::tr("sums of the recorded times"));
  table.columns = {Text::tr("Group"),
                   Text::tr("Trainees"),
                   Text::tr("Mean virtual (min)"),
                   Text::tr("Mean real (min)"),
                   Text::tr("Trainees who rested"),
                   Text::tr("Rest in all (min)")};
  std::map<std::string, std::size_t> groupOf;
  for (const CohortTrainee& trainee : in.trainees) {
    groupOf[trainee.code] = trainee.group;
  }
  for (std::size_t g = 0; g < in.groups.size(); ++g) {
    CohortDose sum;
    std::int64_t n = 0;
    std::int64_t rested = 0;
    for (const CohortDose& dose : in.doses) {
      const auto found = groupOf.find(dose.trainee);
      if (found == groupOf.end() || found->second != g) {
        continue;
      }
      ++n;
      sum.virtual_min += dose.virtual_min;
      sum.real_min += dose.real_min;
      sum.rest_min += dose.rest_min;
      rested += dose.rest_min > 0.0 ? 1 : 0;
    }
    if (n == 0) {
      continue;
    }
    const auto count = static_cast<double>(n);
    table.rows.push_back({in.groups[g].name, std::to_string(n), formatFixed(sum.virtual_min / count, 1),
                          formatFixed(sum.real_min / count, 1), std::to_string(rested),
                          formatFixed(sum.rest_min, 1)});
    table.provenance.n += n;
  }
  table.notes = {Text::tr("Rest stops the clock of the training phases.")};
  return table;
}

}  // namespace

ReportSection learningSection(const CohortInputs& in) {
  ReportSection section;
  section.title = Text::tr("Learning");
  const std::vector<Course> all = courses(in);
  const LcCusumDesign design;
  if (!in.doses.empty()) {
    section.tables.push_back(doseTable(in));
  }
  if (all.empty()) {
    return section;
  }
  section.paragraphs.push_back(
      Text::tr("Measured by the simulator, twist by twist, in the order of the recordings. The marks of the "
               "physicians "
               "are a separate matter."));
  const ReportFigure learning = learningFigure(in, all);
  if (!learning.series.empty()) {
    section.figures.push_back(learning);
  }
  section.figures.push_back(cusumFigure(in, all, design));
  section.tables.push_back(learningTable(in, all, design));
  return section;
}

}  // namespace torsio
