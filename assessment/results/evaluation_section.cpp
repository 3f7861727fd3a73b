// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <iterator>
#include <set>
#include <string>

#include "assessment/results/analysis_tables.h"
#include "assessment/results/number_format.h"
#include "assessment/results/report_labels.h"
#include "assessment/results/report_sections.h"
#include "sim/core/text.h"

namespace torsio {

namespace {

constexpr int kScoreDecimals = 4;  // Eq. 25 for 20/10/10 raters has at most four decimals
constexpr int kReadableDecimals = 2;

std::vector<Text> indexNames(const CohortInputs& in) {
  std::vector<Text> names;
  for (const EvaluationIndex& index : in.instrument.indices) {
    names.emplace_back(index.name);
  }
  return names;
}

std::vector<Text> mergedFlags(const CohortInputs& in) {
  std::vector<Text> flags = commonFlags(in);
  for (const ModelEvaluation& model : in.evaluations) {
    for (const std::string& flag : model.flags) {
      if (std::find(flags.begin(), flags.end(), Text(flag)) == flags.end()) {
        flags.emplace_back(flag);
      }
    }
  }
  return flags;
}

ResultKey indexKey(const CohortInputs& in, const ModelEvaluation& model, std::size_t index) {
  return {
      .section = ResultSection::kEvaluation, .model = model.model, .index = in.instrument.indices[index].id};
}

ResultKey compositeKey(const CohortInputs& in, const ModelEvaluation& model,
                       const RaterComposite& composite) {
  return {.section = ResultSection::kEvaluation,
          .of = composite.rater,
          .raterClass = in.instrument.classes[composite.raterClass].id,
          .model = model.model};
}

/// `model`: empty for all.
Provenance provenance(const CohortInputs& in, const Ledger& ledger, const Text& formula,
                      const std::string& model = {}) {
  const ResultsAt at(ledger, {.section = ResultSection::kEvaluation, .model = model});
  return {formula, kEvaluationFormulaVersion, at.count("marks_used"), at.count("marks_missing"),
          mergedFlags(in)};
}

ReportFigure figure(const CohortInputs& in, const Ledger& ledger, const std::string& id, const Text& title,
                    FigureKind kind, const Text& formula) {
  ReportFigure out;
  out.id = id;
  out.title = title;
  out.kind = kind;
  out.yLabel = Text::tr("score (points)");
  out.yMin = pointsFromSteps(in.instrument.scale.lo, in.instrument.scale);
  out.yMax = pointsFromSteps(in.instrument.scale.hi, in.instrument.scale);
  out.provenance = provenance(in, ledger, formula);
  return out;
}

ReportFigure rangesFigure(const CohortInputs& in, const Ledger& ledger) {
  ReportFigure out =
      figure(in, ledger, "figure-15", Text::tr("Lowest, weighted mean and highest score of each index"),
             FigureKind::kRanges, Text::tr("Eq. 25"));
  out.categories = indexNames(in);
  for (const ModelEvaluation& model : in.evaluations) {
    FigureSeries series{.name = model.model};
    for (std::size_t j = 0; j < model.indices.size(); ++j) {
      const ResultsAt at(ledger, indexKey(in, model, j));
      addPoint(series, at, "M");
      series.low.push_back(*at.number("min"));
      series.high.push_back(*at.number("max"));
    }
    out.series.push_back(std::move(series));
  }
  out.notes = {Text::tr(
      "Corresponds to Fig. 15 of the paper. The symbol in each range is the class-weighted mean M.")};
  return out;
}

ReportFigure barsFigure(const CohortInputs& in, const Ledger& ledger, bool variance) {
  ReportFigure out = variance ? figure(in, ledger, "figure-17",
                                       Text::tr("Variance of each index about the weighted mean, divisor n"),
                                       FigureKind::kGroupedBars, Text::tr("Eq. 26"))
                              : figure(in, ledger, "figure-16", Text::tr("Weighted mean score of each index"),
                                       FigureKind::kGroupedBars, Text::tr("Eq. 25"));
  out.categories = indexNames(in);
  for (const ModelEvaluation& model : in.evaluations) {
    FigureSeries series{.name = model.model};
    for (std::size_t j = 0; j < model.indices.size(); ++j) {
      addPoint(series, ResultsAt(ledger, indexKey(in, model, j)), variance ? "s2_eq26_divisor_n" : "M");
    }
    out.series.push_back(std::move(series));
  }
  if (variance) {
    out.yLabel = Text::tr("variance (points squared)");
    out.yMin = 0.0;
    out.yMax = std::nullopt;
    out.notes = {Text::tr(
        "Corresponds to Fig. 17 of the paper. The centre is the class-weighted mean M, not the plain mean, "
        "and every rater counts once; the value is the population variance plus the squared distance between "
        "the two means.")};
  } else {
    out.notes = {Text::tr("Corresponds to Fig. 16 of the paper.")};
  }
  return out;
}

ReportFigure chiefsFigure(const CohortInputs& in, const Ledger& ledger) {
  const Text of = in.instrument.classes[in.chiefClass].name;
  ReportFigure out =
      figure(in, ledger, "figure-18", Text::tr("Comprehensive score of each rater of the class %1", of),
             FigureKind::kPoints, Text::tr("Eq. 27 for one rater"));
  out.xLabel = Text::tr("rater");
  out.individual = true;
  out.annex = true;  // single raters: what only a reviewer looks up
  const ResultsAt all(
      ledger, {.section = ResultSection::kEvaluation, .raterClass = in.instrument.classes[in.chiefClass].id});
  out.provenance.n = all.count("composites");
  for (const ModelEvaluation& model : in.evaluations) {
    FigureSeries series{.name = model.model};
    for (const RaterComposite& composite : model.composites) {
      if (composite.raterClass != in.chiefClass) {
        continue;
      }
      const Text rater = composite.rater;
      auto at = std::find(out.categories.begin(), out.categories.end(), rater);
      if (at == out.categories.end()) {
        at = out.categories.insert(out.categories.end(), rater);
      }
      series.x.push_back(static_cast<double>(std::distance(out.categories.begin(), at)));
      addPoint(series, ResultsAt(ledger, compositeKey(in, model, composite)), "composite");
    }
    out.series.push_back(std::move(series));
  }
  out.notes = {Text::tr("Corresponds to Fig. 18 of the paper: %1 only, one point a rater and model.", of)};
  return out;
}

ReportFigure boxesFigure(const CohortInputs& in, const Ledger& ledger) {
  ReportFigure out = figure(in, ledger, "figure-19", Text::tr("Comprehensive scores of all raters"),
                            FigureKind::kBoxes, Text::tr("Eq. 27 for one rater; quantiles of type 7"));
  out.provenance.n = ResultsAt(ledger, {.section = ResultSection::kEvaluation}).count("composites");
  for (const ModelEvaluation& model : in.evaluations) {
    out.categories.push_back(model.model);
    FigureSeries series{.name = model.model};
    for (const RaterComposite& composite : model.composites) {
      if (composite.score) {
        addPoint(series, ResultsAt(ledger, compositeKey(in, model, composite)), "composite");
      }
    }
    const ResultsAt at(ledger, {.section = ResultSection::kEvaluation, .model = model.model});
    if (at.number("composite_median")) {
      series.boxKey = at("composite_median").key;
      const auto number = [&](const char* name) { return *at.number(std::string("composite_") + name); };
      series.box = BoxSummary{number("lower_whisker"),
                              number("lower_quartile"),
                              number("median"),
                              number("upper_quartile"),
                              number("upper_whisker"),
                              number("plain_mean"),
                              {}};
      for (const std::optional<double>& score : series.y) {
        if (score && (*score < series.box->lowerWhisker || *score > series.box->upperWhisker)) {
          series.box->outliers.push_back(*score);
        }
      }
      std::sort(series.box->outliers.begin(), series.box->outliers.end());
    }
    out.series.push_back(std::move(series));
  }
  out.notes = {
      Text::tr(
          "Corresponds to Fig. 19 of the paper. Eq. 27 gives one number for each model; what is drawn is the "
          "distribution of the scores that Eq. 27 gives for each single rater."),
      Text::tr(
          "Boxes end at the quartiles (rule: Hyndman and Fan type 7); whiskers reach the most extreme value "
          "within 1.5 interquartile ranges of the box; values beyond are drawn singly; the separate symbol "
          "is "
          "the mean.")};
  return out;
}

/// Shows where the classes of raters disagree: class means of every index, one row per model and class.
ReportFigure classesFigure(const CohortInputs& in, const Ledger& ledger) {
  ReportFigure out = figure(in, ledger, "figure-classes", Text::tr("Mean score by class of raters"),
                            FigureKind::kHeatMap, Text::tr("class means of Eq. 25"));
  out.annex = true;
  out.xLabel = Text::tr("index");
  out.categories = indexNames(in);
  for (const ModelEvaluation& model : in.evaluations) {
    for (std::size_t c = 0; c < in.instrument.classes.size(); ++c) {
      FigureSeries series{.name = Text::tr("%1, %2", model.model, Text(in.instrument.classes[c].name))};
      for (std::size_t j = 0; j < model.indices.size(); ++j) {
        ResultKey key = indexKey(in, model, j);
        key.raterClass = in.instrument.classes[c].id;
        addPoint(series, ResultsAt(ledger, key), "class_mean");
      }
      out.series.push_back(std::move(series));
    }
  }
  return out;
}

ReportTable comprehensiveTable(const CohortInputs& in, const Ledger& ledger) {
  ReportTable table;
  table.id = "table-comprehensive";
  table.title = Text::tr("Comprehensive score N of each model");
  const auto column = [](Phrase title, const char* statistic) {
    return ResultColumn{title, statistic, fixed(kScoreDecimals)};
  };
  ResultTable rows(ledger, table,
                   {{Text::tr("Model")},
                    column(Text::tr("N (Eq. 27)"), "N_eq27"),
                    {Text::tr("Raters with all marks"), "raters_with_all_marks"},
                    column(Text::tr("Mean of raters, by class weight"), "composite_M"),
                    {Text::tr("[95 %]"), "composite_M_95", intervalWith(2), ""},
                    column(Text::tr("SE"), "composite_se_of_M"),
                    column(Text::tr("Lowest"), "composite_lowest"),
                    column(Text::tr("Lower quartile"), "composite_lower_quartile"),
                    column(Text::tr("Median"), "composite_median"),
                    column(Text::tr("Upper quartile"), "composite_upper_quartile"),
                    column(Text::tr("Highest"), "composite_highest"),
                    {Text::tr("Flags")}});
  for (const ModelEvaluation& model : in.evaluations) {
    rows.row({model.model, listed(std::vector<Text>(model.flags.begin(), model.flags.end()))},
             {.section = ResultSection::kEvaluation, .model = model.model});
  }
  table.notes = {
      Text::tr("With no mark missing, the class-weighted mean of the raters' own scores equals N exactly.")};
  table.provenance = provenance(in, ledger, Text::tr("Eq. 27"));
  return table;
}

ReportTable indexTable(const CohortInputs& in, const ModelEvaluation& model, const Ledger& ledger) {
  ReportTable table;
  table.id = "table-indices-" + model.model;
  table.annex = true;
  table.title = Text::tr("Model %1: exact values by index", model.model);
  ResultTable rows(ledger, table,
                   {{Text::tr("Index")},
                    {Text::tr("Weight")},
                    {Text::verbatim("n"), "M", kValues},
                    {Text::tr("Lowest"), "min", fixed(1)},
                    {Text::tr("M (Eq. 25)"), "M", fixed(kScoreDecimals)},
                    {Text::tr("Highest"), "max", fixed(1)},
                    {Text::tr("s2 (Eq. 26)"), "s2_eq26_divisor_n", fixed(kScoreDecimals)},
                    {Text::tr("Plain mean"), "plain_mean", fixed(kScoreDecimals)},
                    {Text::tr("Sample variance"), "sample_variance", fixed(kScoreDecimals)},
                    {Text::tr("SE of M"), "se_of_M", fixed(kScoreDecimals)}});
  for (std::size_t j = 0; j < model.indices.size(); ++j) {
    const EvaluationIndex& index = in.instrument.indices[j];
    const ResultsAt weight(ledger, {.section = ResultSection::kEvaluation, .index = index.id});
    rows.row({index.name, weight("index_weight", fixed(3))}, indexKey(in, model, j));
  }
  table.notes = {Text::tr(
      "s2 is taken about M with divisor n (Eq. 26). The sample variance is taken about the plain mean with "
      "divisor n - 1. SE is the standard error of M from the spread within the rater classes.")};
  table.provenance = provenance(in, ledger, Text::tr("Eqs. 25 and 26"), model.model);
  return table;
}

}  // namespace

ReportSection evaluationSection(const CohortInputs& in, const Ledger& ledger) {
  ReportSection section{"evaluation", Text::tr("Evaluation of the models")};
  if (in.unfinishedEvaluation) {
    return unfinishedSection(in, ledger);
  }
  std::vector<Text> classes;
  std::vector<std::shared_ptr<const ResultKey>> keys;
  for (const RaterClass& raterClass : in.instrument.classes) {
    ResultKey place = wholeKey(kEvaluationMarks);
    place.raterClass = raterClass.id;
    const ReportCell raters = ResultsAt(ledger, std::move(place))("raters");
    const ReportCell weight =
        ResultsAt(ledger, {.section = ResultSection::kEvaluation, .raterClass = raterClass.id})(
            "class_weight", fixed(kReadableDecimals));
    classes.push_back(Text::tr("%1 %2 (weight %3)", Text(raterClass.name), raters.words(), weight.words()));
    keys.push_back(raters.key);
    keys.push_back(weight.key);
  }
  const ResultsAt whole(ledger, wholeKey(kEvaluationMarks));
  const ReportCell indices = whole("indices");
  const ReportCell lowest = whole("scale_lowest", fixed(0));
  const ReportCell highest = whole("scale_highest", fixed(0));
  const ReportCell lost = whole("missing");
  const std::int64_t missing = missingEvaluationMarks(in);
  section.paragraphs.push_back(
      {missing == 0
           ? Text::tr("Each rater scored every model on %1 indices from %2 to %3 points. Raters: %4.",
                      indices.words(), lowest.words(), highest.words(), listed(classes))
           : Text::tr("Raters scored the models on %1 indices from %2 to %3 points; %4 {mark "
                      "is|marks are} missing. "
                      "Raters: %5.",
                      indices.words(), lowest.words(), highest.words(), lost.words(), listed(classes)),
       {indices, lowest, highest, lost},
       keys});
  ReportParagraph ranked;
  std::vector<Text> ranking;
  for (const ModelEvaluation& model : in.evaluations) {
    const ResultsAt at(ledger, {.section = ResultSection::kEvaluation, .model = model.model});
    const ReportCell n = at("N_eq27", fixed(kReadableDecimals));
    const ReportCell interval = at("composite_M_95", intervalWith(kReadableDecimals), "");
    // With marks missing, N is not the mean of the raters' own scores, whose interval this is.
    const bool same = missing == 0 && interval.key != nullptr;
    ranking.push_back(same ? Text::verbatim("%1 %2 %3", model.model, n.words(), interval.words())
                           : Text::verbatim("%1 %2", model.model, n.words()));
    ranked.keys.push_back(n.key);
    if (same) {
      ranked.keys.push_back(interval.key);
    }
  }
  static_cast<Text&>(ranked) =
      Text::tr("Comprehensive score N, with 95 % intervals where no mark is missing: %1.",
               listed(ranking, Text::tr("%1; %2")));
  section.paragraphs.push_back(std::move(ranked));
  section.paragraphs.push_back(Text::tr(
      "Marks are whole steps of the scale; M, s2 and N are computed in whole numbers and rounded once, so "
      "the tables do not depend on the order of the raters."));
  section.figures = {rangesFigure(in, ledger), barsFigure(in, ledger, false), barsFigure(in, ledger, true),
                     chiefsFigure(in, ledger), boxesFigure(in, ledger),       classesFigure(in, ledger)};
  section.tables.push_back(comprehensiveTable(in, ledger));
  if (std::optional<ReportTable> differences = modelDifferencesTable(in, ledger)) {
    section.tables.push_back(std::move(*differences));
  }
  for (const ModelEvaluation& model : in.evaluations) {
    section.tables.push_back(indexTable(in, model, ledger));
  }
  return section;
}

}  // namespace torsio
