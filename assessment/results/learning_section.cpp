// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "assessment/catalogue/quantity.h"
#include "assessment/results/number_format.h"
#include "assessment/results/report_labels.h"
#include "assessment/results/report_sections.h"

namespace torsio {

namespace {

/// Shows a group's mean error at its n-th twist with a 95 % interval over the trainees who made it.
ReportFigure learningFigure(const CohortInputs& in, const Ledger& ledger) {
  ReportFigure figure = itemOf<ReportFigure>(
      in, "figure-learning", Text::tr("Angle error by twist, mean of the trainees with 95 % interval"),
      Text::tr("mean of the absolute error over trainees, Student's t"));
  figure.kind = FigureKind::kLines;
  figure.xLabel = Text::tr("number of the twist");
  figure.yLabel = Text::tr("absolute angle error (deg)");
  figure.yMin = 0.0;
  const Result* mostAtFirst = nullptr;
  const Result* fewestAtLast = nullptr;
  for (std::size_t g = 0; g < in.groups.size(); ++g) {
    FigureSeries series{.name = in.groups[g].name, .look = g};
    const Result* last = nullptr;
    for (ResultKey key{.section = ResultSection::kPractice, .group = ledger.group(g), .number = 1};;
         ++key.number) {
      const ResultsAt at(ledger, key);
      const Result* mean = at.find("mean_twist_error_deg");
      if (mean == nullptr) {
        break;
      }
      series.x.push_back(static_cast<double>(key.number));
      addPoint(series, at, "mean_twist_error_deg", true);
      mostAtFirst = mostAtFirst == nullptr || mean->n > mostAtFirst->n ? mean : mostAtFirst;
      last = mean;
    }
    if (!series.y.empty()) {
      fewestAtLast = fewestAtLast == nullptr || last->n < fewestAtLast->n ? last : fewestAtLast;
      figure.series.push_back(std::move(series));
    }
  }
  figure.provenance.n = ResultsAt(ledger, {.section = ResultSection::kPractice}).count("twists_in_means");
  figure.notes = {Text::tr("Twists on the simulator only; a point needs at least two trainees.")};
  if (mostAtFirst != nullptr && fewestAtLast->n < mostAtFirst->n) {
    const ReportCell most = ResultsAt(ledger, mostAtFirst->key)(mostAtFirst->key.statistic, kValues);
    const ReportCell fewest = ResultsAt(ledger, fewestAtLast->key)(fewestAtLast->key.statistic, kValues);
    figure.notes.push_back(
        {Text::tr("The first points rest on up to %1 {trainee|trainees} of a group, the last on %2.",
                  most.words(), fewest.words()),
         {most, fewest}});
  }
  return figure;
}

ReportTable learningTable(const CohortInputs& in, const std::vector<PracticeCourse>& all,
                          const Ledger& ledger) {
  ReportTable table =
      itemOf<ReportTable>(in, "table-learning", Text::tr("Learning of every trainee on the simulator"),
                          Text::tr("exponential learning curve"));
  table.annex = true;
  table.individual = true;
  ResultTable rows(
      ledger, table,
      {{Text::tr("Group")},
       {Text::tr("Trainee")},
       {rowOf(Quantity::kCompletedTwists).name, "twists"},
       {rowOf(Quantity::kTargetsReached).name, "twists_on_target"},
       {Text::tr("Mean error, first half (deg)"), "mean_error_first_half_deg", fixed(2), Text::tr("too few")},
       {Text::tr("Second half (deg)"), "mean_error_second_half_deg", fixed(2)},
       {Text::tr("Error left in the end (deg)")}});
  for (const PracticeCourse& course : all) {
    const ResultKey place{
        .section = ResultSection::kPractice, .of = course.trainee, .group = ledger.group(course.group)};
    const ResultsAt at(ledger, place);
    ReportCell left = at("error_left_deg", fixed(2));
    if (const Result* found = at.find("error_left_deg"); found != nullptr) {
      if (const auto* none = std::get_if<Undefined>(&found->value)) {
        static_cast<Text&>(left) = Text::tr("not fitted: %1", none->reason);
      } else if (numberIn(found->value) == 0.0) {
        static_cast<Text&>(left) = Text::tr("%1, held at zero", left.words());
      }
    }
    rows.row({in.groups[course.group].name, course.trainee, left}, place);
  }
  const ResultsAt whole(ledger, {.section = ResultSection::kPractice});
  table.provenance.n = whole.count("twists");
  const ReportCell fitted = whole("trainees_with_curve");
  const ReportCell trainees = whole("trainees_with_curve", kValues);
  table.notes = {
      Text::tr(
          "Each trainee is fitted alone; eight twists are the fewest for a curve with three parameters."),
      {Text::tr(
           "A curve was fitted to %1 of %2 {trainee|trainees}. An error that falls like a straight line, "
           "or not at all, does not level off and has none.",
           fitted.words(), trainees.words()),
       {fitted, trainees}}};
  return table;
}

ReportTable doseTable(const CohortInputs& in, const Ledger& ledger) {
  ReportTable table =
      itemOf<ReportTable>(in, "table-dose", Text::tr("Time spent training and resting"),
                          Text::tr("plan of the arms; times noted; lengths of the recordings"));
  ResultTable rows(ledger, table,
                   {{Text::tr("Group")},
                    {Text::tr("Trainees"), "rest_min", kValues},
                    {Text::tr("Virtual, planned (min)")},
                    {Text::tr("Virtual, mean noted (min)"), "mean_noted_virtual_min", fixed(1)},
                    {Text::tr("Virtual, mean recorded (min)"), "mean_recorded_virtual_min", fixed(1)},
                    {Text::tr("Real, planned (min)")},
                    {Text::tr("Real, mean noted (min)"), "mean_noted_real_min", fixed(1)},
                    {Text::tr("Trainees who rested"), "trainees_who_rested"},
                    {Text::tr("Rest in all (min)"), "rest_min", fixed(1)}});
  for (std::size_t g = 0; g < in.groups.size(); ++g) {
    const ResultKey place{.section = ResultSection::kPractice, .group = ledger.group(g)};
    const ResultsAt at(ledger, place);
    if (at.find("rest_min") == nullptr) {
      continue;
    }
    const ResultsAt plan(ledger, {.section = ResultSection::kParticipants, .group = ledger.group(g)});
    rows.row({in.groups[g].name, plan("planned_virtual_min", fixed(1), Text::tr("no plan")),
              plan("planned_real_min", fixed(1), Text::tr("no plan"))},
             place);
  }
  table.provenance.n = ResultsAt(ledger, {.section = ResultSection::kPractice}).count("trainees_with_times");
  table.notes = {Text::tr("Rest stops the clock of the training phases.")};
  const ResultsAt whole(ledger, wholeKey(kTrainingTimes));
  if (whole.number("recorded_share")) {
    const ReportCell share = whole("recorded_share", percent(1));
    table.notes.push_back(
        {Text::tr("Recordings make up %1 of the time noted on the simulator; the rest was spent between the "
                  "runs, or is not recorded.",
                  share.words()),
         {share}});
  }
  return table;
}

}  // namespace

ReportSection learningSection(const CohortInputs& in, const Ledger& ledger) {
  ReportSection section{"learning", Text::tr("Learning")};
  const std::vector<PracticeCourse> all = practiceCourses(in);
  if (!in.doses.empty()) {
    section.tables.push_back(doseTable(in, ledger));
  }
  if (all.empty()) {
    return section;
  }
  section.paragraphs.push_back(
      Text::tr("Measured by the simulator, twist by twist, in the order of the recordings. The marks of the "
               "physicians "
               "are a separate matter."));
  const ReportFigure learning = learningFigure(in, ledger);
  if (!learning.series.empty()) {
    section.figures.push_back(learning);
  }
  section.tables.push_back(learningTable(in, all, ledger));
  return section;
}

}  // namespace torsio
