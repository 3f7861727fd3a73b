// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "assessment/results/number_format.h"
#include "assessment/results/report_sections.h"
#include "assessment/statistics/curve_fit.h"
#include "assessment/statistics/descriptive.h"
#include "assessment/statistics/distributions.h"

namespace torsio {

namespace {

/// All twists of a trainee in the order of recording.
struct Course {
  std::string trainee;
  std::size_t group = 0;
  std::vector<JudgedTwist> attempts;
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

/// Shows a group's mean error at its n-th twist with a 95 % interval over the trainees who made it.
ReportFigure learningFigure(const CohortInputs& in, const std::vector<Course>& all) {
  ReportFigure figure = itemOf<ReportFigure>(
      in, "figure-learning", Text::tr("Angle error by twist, mean of the trainees with 95 % interval"),
      Text::tr("mean of the absolute error over trainees, Student's t"));
  figure.kind = FigureKind::kLines;
  figure.xLabel = Text::tr("number of the twist");
  figure.yLabel = Text::tr("absolute angle error (deg)");
  figure.yMin = 0.0;
  std::size_t mostAtFirst = 0;
  std::size_t fewestAtLast = std::numeric_limits<std::size_t>::max();
  for (std::size_t g = 0; g < in.groups.size(); ++g) {
    FigureSeries series;
    series.name = in.groups[g].name;
    series.look = g;
    std::size_t last = 0;
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
      const double half = tQuantile(0.5 + 0.5 * kDefaultConfidence, count - 1.0) * *sampleDeviation(errors) /
                          std::sqrt(count);
      series.x.push_back(static_cast<double>(n + 1));
      series.y.emplace_back(mean);
      series.low.push_back(std::max(0.0, mean - half));
      series.high.push_back(mean + half);
      figure.provenance.n += std::ssize(errors);
      mostAtFirst = std::max(mostAtFirst, errors.size());
      last = errors.size();
    }
    fewestAtLast = last > 0 ? std::min(fewestAtLast, last) : fewestAtLast;
    if (!series.y.empty()) {
      figure.series.push_back(series);
    }
  }
  figure.notes = {Text::tr("Twists on the simulator only; a point needs at least two trainees.")};
  if (fewestAtLast < mostAtFirst) {
    figure.notes.push_back(
        Text::tr("The first points rest on up to %1 {trainee|trainees} of a group, the last on %2.",
                 mostAtFirst, fewestAtLast));
  }
  return figure;
}

ReportTable learningTable(const CohortInputs& in, const std::vector<Course>& all) {
  ReportTable table =
      itemOf<ReportTable>(in, "table-learning", Text::tr("Learning of every trainee on the simulator"),
                          Text::tr("exponential learning curve"));
  table.individual = true;
  table.columns = {Text::tr("Group"),
                   Text::tr("Trainee"),
                   rowOf(Quantity::kCompletedTwists).name,
                   rowOf(Quantity::kTargetsReached).name,
                   Text::tr("Mean error, first half (deg)"),
                   Text::tr("Second half (deg)"),
                   Text::tr("Error left in the end (deg)")};
  std::int64_t fitted = 0;
  for (const Course& course : all) {
    std::vector<double> number;
    std::vector<double> error;
    std::int64_t onTarget = 0;
    for (const JudgedTwist& attempt : course.attempts) {
      number.push_back(static_cast<double>(number.size() + 1));
      error.push_back(attempt.error_deg);
      onTarget += attempt.onTarget ? 1 : 0;
    }
    const std::size_t half = error.size() / 2;
    const std::span<const double> values(error);
    const Outcome<LearningCurve> fit = fitLearningCurve(LearningFamily::kExponential, number, error);
    table.rows.push_back({in.groups[course.group].name, course.trainee, std::to_string(error.size()),
                          std::to_string(onTarget),
                          half > 0 ? Text(formatFixed(meanOf(values.first(half)), 2)) : Text::tr("too few"),
                          formatFixed(meanOf(values.subspan(half)), 2),
                          !fit                   ? Text::tr("not fitted: %1", Text(fit.reason()))
                          : fit->asymptoteAtZero ? Text::tr("%1, held at zero", formatFixed(0.0, 2))
                                                 : Text(formatFixed(fit->asymptote, 2))});
    fitted += fit ? 1 : 0;
    table.provenance.n += std::ssize(error);
  }
  table.notes = {
      Text::tr(
          "Each trainee is fitted alone; eight twists are the fewest for a curve with three parameters."),
      Text::tr(
          "A curve was fitted to %1 of %2 {trainee|trainees}. An error that falls like a straight line, or "
          "not at all, does not level off and has none.",
          fitted, all.size())};
  return table;
}

/// Totals over the trainees of one group.
struct GroupTimes {
  std::int64_t trainees = 0;
  CohortDose noted;
  double recorded_min = 0.0;
  std::int64_t rested = 0;
};

GroupTimes timesOf(const CohortInputs& in, std::size_t group) {
  GroupTimes sum;
  std::set<std::string> members;
  for (const CohortTrainee& trainee : in.trainees) {
    if (trainee.group == group) {
      members.insert(trainee.code);
    }
  }
  for (const CohortDose& dose : in.doses) {
    if (!members.contains(dose.trainee)) {
      continue;
    }
    ++sum.trainees;
    sum.noted.virtual_min += dose.virtual_min;
    sum.noted.real_min += dose.real_min;
    sum.noted.rest_min += dose.rest_min;
    sum.rested += dose.rest_min > 0.0 ? 1 : 0;
  }
  for (const TrialSummaryRow& trial : in.trials) {
    // An untwisting does not belong to a phase of the study's arms.
    sum.recorded_min += members.contains(trial.trainee) && trial.detorsion.empty() ? trial.minutes : 0.0;
  }
  return sum;
}

ReportTable doseTable(const CohortInputs& in) {
  ReportTable table =
      itemOf<ReportTable>(in, "table-dose", Text::tr("Time spent training and resting"),
                          Text::tr("plan of the arms; times noted; lengths of the recordings"));
  table.columns = {Text::tr("Group"),
                   Text::tr("Trainees"),
                   Text::tr("Virtual, planned (min)"),
                   Text::tr("Virtual, mean noted (min)"),
                   Text::tr("Virtual, mean recorded (min)"),
                   Text::tr("Real, planned (min)"),
                   Text::tr("Real, mean noted (min)"),
                   Text::tr("Trainees who rested"),
                   Text::tr("Rest in all (min)")};
  const auto planned = [](const std::optional<double>& minutes) {
    return minutes ? Text(formatFixed(*minutes, 1)) : Text::tr("no plan");
  };
  double noted = 0.0;
  double recorded = 0.0;
  for (std::size_t g = 0; g < in.groups.size(); ++g) {
    const GroupTimes sum = timesOf(in, g);
    if (sum.trainees == 0) {
      continue;
    }
    const auto count = static_cast<double>(sum.trainees);
    table.rows.push_back(
        {in.groups[g].name, std::to_string(sum.trainees), planned(in.groups[g].plannedVirtual_min),
         formatFixed(sum.noted.virtual_min / count, 1), formatFixed(sum.recorded_min / count, 2),
         planned(in.groups[g].plannedReal_min), formatFixed(sum.noted.real_min / count, 1),
         std::to_string(sum.rested), formatFixed(sum.noted.rest_min, 1)});
    table.provenance.n += sum.trainees;
    noted += sum.noted.virtual_min;
    recorded += sum.recorded_min;
  }
  table.notes = {Text::tr("Rest stops the clock of the training phases.")};
  if (noted > 0.0) {
    table.notes.push_back(
        Text::tr("Recordings make up %1 % of the time noted on the simulator; the rest was spent between the "
                 "runs, or is "
                 "not recorded.",
                 formatFixed(100.0 * recorded / noted, 1)));
  }
  return table;
}

}  // namespace

ReportSection learningSection(const CohortInputs& in) {
  ReportSection section{"learning", Text::tr("Learning")};
  const std::vector<Course> all = courses(in);
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
  section.tables.push_back(learningTable(in, all));
  return section;
}

}  // namespace torsio
