// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "assessment/results/number_format.h"
#include "assessment/results/record_sentences.h"
#include "assessment/results/report_labels.h"
#include "assessment/results/report_sections.h"

namespace torsio {

namespace {

constexpr int kRaterDecimals = 3;

/// Like itemOf(), for content about single people.
template <typename Item>
Item individualItem(const CohortInputs& in, const std::string& id, const Text& title, const Text& formula) {
  Item item = itemOf<Item>(in, id, title, formula);
  item.individual = true;
  return item;
}

/// Shows each rater's mean mark of each trainee over the occasions.
ReportFigure heatMap(const CohortInputs& in, const StudyAnalysis& study, const Ledger& ledger) {
  ReportFigure figure =
      individualItem<ReportFigure>(in, "figure-marks", Text::tr("Marks by trainee and rater, last occasion"),
                                   Text::tr("marks as submitted"));
  figure.kind = FigureKind::kHeatMap;
  figure.xLabel = Text::tr("trainee");
  figure.yLabel = Text::tr("mark (points)");
  figure.yMin = pointsFromSteps(in.trainingScale.lo, in.trainingScale);
  figure.yMax = pointsFromSteps(in.trainingScale.hi, in.trainingScale);
  figure.categories.assign(study.trainees.begin(), study.trainees.end());
  const ResultsAt last(ledger, {.section = ResultSection::kAgreement, .occasion = ledger.lastOccasion()});
  for (const std::string& rater : study.raters) {
    FigureSeries series{.name = rater};
    for (std::size_t i = 0; i < study.trainees.size(); ++i) {
      addPoint(series,
               ResultsAt(ledger, {.of = study.trainees[i],
                                  .group = ledger.group(study.groupOf[i]),
                                  .index = rater,
                                  .occasion = ledger.lastOccasion()}),
               "rater_mark");
    }
    figure.series.push_back(std::move(series));
  }
  figure.provenance.n = last.count("marks");
  figure.provenance.missing = last.count("marks_missing");
  figure.notes = {
      Text::tr("A row that is uniformly lighter or darker shows a stricter or more lenient rater. An empty "
               "cell is a missing mark.")};
  return figure;
}

ReportFigure severityFigure(const CohortInputs& in, const StudyAnalysis& study, const Ledger& ledger) {
  ReportFigure figure =
      individualItem<ReportFigure>(in, "figure-severity", Text::tr("Severity of the raters"),
                                   Text::tr("mean of own mark minus mean of the other raters"));
  figure.kind = FigureKind::kForest;
  figure.yLabel = Text::tr("own mark minus the other raters' mean (points)");
  figure.references = {{0.0, Text::tr("as the others")}};
  std::vector<RaterSeverity> ordered = study.severity;
  std::stable_sort(ordered.begin(), ordered.end(),
                   [](const RaterSeverity& a, const RaterSeverity& b) { return a.offset < b.offset; });
  FigureSeries series{.name = Text::tr("offset [95 %]")};
  bool alone = false;
  for (const RaterSeverity& rater : ordered) {
    figure.categories.emplace_back(rater.rater);
    addPoint(series, ResultsAt(ledger, {.section = ResultSection::kAgreement, .of = rater.rater}),
             "severity_offset", true);
    alone = alone || !rater.interval;
  }
  figure.provenance.n =
      ResultsAt(ledger, {.section = ResultSection::kAgreement}).count("trainees_of_every_rater");
  figure.series = {series};
  figure.notes = {
      allMarksGiven(in)
          ? Text::tr(
                "Strictest first. Scores are not corrected for severity: every trainee is scored by the same "
                "raters, so that it does not change their order.")
          : Text::tr(
                "Strictest first. Scores are not corrected for severity, and not every trainee is scored by "
                "the same raters: a strict or lenient rater may change their order.")};
  if (alone) {
    figure.notes.push_back(Text::tr("A rater who shares a single trainee with others has no interval."));
  }
  return figure;
}

/// Shows every mark of the last occasion against the mean of the other raters.
std::optional<ReportFigure> blandAltmanFigure(const CohortInputs& in, const Ledger& ledger) {
  ReportFigure figure = individualItem<ReportFigure>(
      in, "figure-bland-altman", Text::tr("Each mark against the other raters, last occasion"),
      Text::tr("each mark against the mean of the others, limits for repeated measures"));
  figure.kind = FigureKind::kScatter;
  figure.xLabel = Text::tr("mean of own mark and the others' mean (points)");
  figure.yLabel = Text::tr("own minus others' mean");
  FigureSeries series{.name = Text::tr("one mark")};
  for (const Result* mark :
       ledger.select({.section = ResultSection::kAgreement, .statistic = kMarkMinusOthers, .of = kEach})) {
    ResultKey both = mark->key;
    both.statistic = kMarkAndOthers;
    series.x.push_back(*numberIn(ledger.find(both)->value));
    addPoint(series, ResultsAt(ledger, mark->key), kMarkMinusOthers);
  }
  const ResultsAt at(ledger, {.section = ResultSection::kAgreement, .occasion = ledger.lastOccasion()});
  const std::optional<double> limit = at.number("limit_against_others");
  if (!limit) {
    return std::nullopt;
  }
  const ReportCell reach = at("limit_against_others", fixed(2));
  const ReportCell others = at("usual_number_of_others");
  figure.series = {series};
  figure.references = {{0.0, Text::tr("as the others")},
                       {-*limit, Text::tr("lower limit")},
                       {*limit, Text::tr("upper limit")}};
  figure.provenance.n = at.count("marks_with_others");
  figure.provenance.missing = at.count("marks_missing");
  figure.notes = {
      {Text::tr("Limits for repeated measures: plus and minus %2 points, 1.96 standard deviations of one "
                "rater's mark about the mean of %1 others, from the variances of raters and rest over all "
                "trainees.",
                others.words(), reach.words()),
       {others, reach}}};
  return figure;
}

ReportTable ratersTable(const CohortInputs& in, const StudyAnalysis& study, const Ledger& ledger) {
  ReportTable table =
      individualItem<ReportTable>(in, "table-raters", Text::tr("Raters side by side"),
                                  Text::tr("Bland and Altman against the mean of the others, last occasion"));
  ResultTable rows(ledger, table,
                   {{Text::tr("Rater")},
                    {Text::tr("Trainees"), "severity_offset", kValues},
                    {Text::tr("Offset [95 %], all occasions"), "severity_offset", kWithInterval},
                    {Text::tr("Limits of agreement, last occasion")}});
  for (const RaterSeverity& rater : study.severity) {
    const ResultsAt last(
        ledger, {.section = ResultSection::kAgreement, .of = rater.rater, .occasion = ledger.lastOccasion()});
    ReportCell limits = last("limit_of_agreement");
    const Result* found = last.find("limit_of_agreement");
    if (const auto* ends = found == nullptr ? nullptr : std::get_if<Interval>(&found->value)) {
      static_cast<Text&>(limits) = Text::tr("%1 to %2", formatFixed(ends->lower, kRaterDecimals),
                                            formatFixed(ends->upper, kRaterDecimals));
    }
    rows.row({rater.rater, limits}, {.section = ResultSection::kAgreement, .of = rater.rater});
  }
  table.provenance.n =
      ResultsAt(ledger, {.section = ResultSection::kAgreement}).count("trainees_of_every_rater");
  table.notes = {
      Text::tr("Raters are shown by code, for the organisers of the study; this is not a ranking.")};
  return table;
}

}  // namespace

ReportSection ratersSection(const CohortInputs& in, const StudyAnalysis& study, const Ledger& ledger) {
  ReportSection section{"raters", Text::tr("Raters")};
  section.paragraphs = {Text::tr(
      "Offsets are taken against the mean of the other raters; a mean that contains the rater would agree by "
      "construction.")};
  if (in.singleMarks) {
    section.figures.push_back(heatMap(in, study, ledger));
  } else {
    section.paragraphs.push_back(Text::tr(
        "Single marks are not shown. The role that made this report sees them, under codes, once every rater "
        "has submitted and the data set is frozen."));
  }
  if (!study.severity.empty()) {
    section.figures.push_back(severityFigure(in, study, ledger));
  }
  if (in.singleMarks) {
    if (const std::optional<ReportFigure> figure = blandAltmanFigure(in, ledger)) {
      section.figures.push_back(*figure);
    }
  }
  if (!study.severity.empty()) {
    section.tables = {ratersTable(in, study, ledger)};
  }
  return section;
}

}  // namespace torsio
