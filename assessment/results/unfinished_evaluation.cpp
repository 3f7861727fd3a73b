// SPDX-License-Identifier: GPL-3.0-or-later
// An evaluation that cannot be computed yet: what is missing, and each rater class's own result.
#include <algorithm>
#include <set>
#include <string>

#include "assessment/results/report_labels.h"
#include "assessment/results/report_sections.h"
#include "sim/core/text.h"

namespace torsio {

namespace {

constexpr int kClassScoreDecimals = 4;
constexpr int kWeightDecimals = 2;
constexpr std::int64_t kWholeWeight = 1000;  // thousandths

/// Lists what is missing from an unfinished evaluation.
ReportTable unscoredTable(const CohortInputs& in, const Ledger& ledger) {
  ReportTable table;
  table.id = "table-evaluation-unscored";
  table.title = Text::tr("What no rater of a class has scored");
  table.columns = {Text::tr("Class"), Text::tr("Model"), Text::tr("Indices without a mark")};
  for (const UnscoredIndices& of : in.unfinishedEvaluation->unscored) {
    const std::vector<Text> names(of.indices.begin(), of.indices.end());
    table.rows.push_back({of.raterClass, of.model,
                          of.indices.size() == in.instrument.indices.size()
                              ? Text::tr("all %1", of.indices.size())
                              : listed(names)});
  }
  table.provenance.formula = Text::tr("counts");
  table.provenance.n = ResultsAt(ledger, {.section = ResultSection::kEvaluation}).count("marks_in_so_far");
  table.provenance.missing = ResultsAt(ledger, wholeKey(kEvaluationMarks)).count("missing");
  table.provenance.flags = commonFlags(in);
  return table;
}

/// Returns Eq. 27 of each class alone: results of the others while a class has not scored.
ReportTable classesTable(const CohortInputs& in, const Ledger& ledger) {
  ReportTable table;
  table.id = "table-evaluation-classes";
  table.title = Text::tr("Score of each class of raters by itself");
  ResultTable rows(ledger, table,
                   {{Text::tr("Model")},
                    {Text::tr("Class")},
                    {Text::tr("Weight")},
                    {Text::tr("Raters"), "class_raters"},
                    {Text::tr("Marks"), "class_marks"},
                    {Text::tr("Score of the class"), kClassScoreStatistic, fixed(kClassScoreDecimals)}});
  for (const ModelRatings& model : in.ratings) {
    for (const RaterClass& raterClass : in.instrument.classes) {
      const ResultsAt weight(ledger, {.section = ResultSection::kEvaluation, .raterClass = raterClass.id});
      rows.row({model.model, raterClass.name, weight("class_weight", fixed(kWeightDecimals))},
               {.section = ResultSection::kEvaluation, .raterClass = raterClass.id, .model = model.model});
    }
  }
  table.notes = {Text::tr(
      "The index weights of Eq. 27 on the plain means of one class. No N is formed while a class that has a "
      "weight is missing: the weights of the others would have to be made up.")};
  table.provenance.formula = Text::tr("Eq. 27 on the means of one class");
  table.provenance.formulaVersion = kEvaluationFormulaVersion;
  table.provenance.n = ResultsAt(ledger, wholeKey(kEvaluationMarks)).count("missing", kValues);
  table.provenance.missing = ResultsAt(ledger, wholeKey(kEvaluationMarks)).count("missing");
  table.provenance.flags = commonFlags(in);
  return table;
}

}  // namespace

std::set<std::string> evaluationRaters(const CohortInputs& in) {
  std::set<std::string> raters;
  for (const ModelRatings& model : in.ratings) {
    for (const RaterSheet& sheet : model.sheets) {
      raters.insert(sheet.rater);
    }
  }
  return raters;
}

std::int64_t givenMarks(const ModelRatings& model) {
  std::int64_t given = 0;
  for (const RaterSheet& sheet : model.sheets) {
    given += std::count_if(sheet.steps.begin(), sheet.steps.end(),
                           [](const auto& steps) { return steps.has_value(); });
  }
  return given;
}

std::int64_t missingEvaluationMarks(const CohortInputs& in, const ModelRatings& model) {
  return std::ssize(evaluationRaters(in)) * std::ssize(in.instrument.indices) - givenMarks(model);
}

std::int64_t missingEvaluationMarks(const CohortInputs& in) {
  std::int64_t missing = 0;
  for (const ModelRatings& model : in.ratings) {
    missing += missingEvaluationMarks(in, model);
  }
  return missing;
}

std::vector<ClassScore> classScores(const CohortInputs& in) {
  std::vector<ClassScore> out;
  for (const ModelRatings& model : in.ratings) {
    for (std::size_t c = 0; c < in.instrument.classes.size(); ++c) {
      ModelRatings own{model.model, {}};
      for (const RaterSheet& sheet : model.sheets) {
        if (sheet.raterClass == c) {
          own.sheets.push_back(sheet);
        }
      }
      bool whole = !own.sheets.empty();
      for (std::size_t j = 0; j < in.instrument.indices.size(); ++j) {
        whole = whole && std::any_of(own.sheets.begin(), own.sheets.end(),
                                     [j](const RaterSheet& sheet) { return sheet.steps[j].has_value(); });
      }
      ClassScore score{model.model, c, std::ssize(own.sheets), givenMarks(own), std::nullopt};
      if (whole) {
        EvaluationInstrument alone = in.instrument;
        for (RaterClass& raterClass : alone.classes) {
          raterClass.weight_milli = &raterClass == &alone.classes[c] ? kWholeWeight : 0;
        }
        score.score = evaluateModel(alone, own).n27;
      }
      out.push_back(std::move(score));
    }
  }
  return out;
}

ReportSection unfinishedSection(const CohortInputs& in, const Ledger& ledger) {
  ReportSection section{"evaluation", Text::tr("Evaluation of the models")};
  const std::vector<std::string>& names = in.unfinishedEvaluation->classesMissing;
  const ReportCell marks = ResultsAt(ledger, {.section = ResultSection::kEvaluation})("marks_in_so_far");
  section.paragraphs = {
      {Text::tr("The evaluation is not finished: %1 {mark is|marks are} in so far. Scores are computed once "
                "every class of raters that has a weight has scored every index of every model.",
                marks.words()),
       {marks}},
      Text::tr("Marks are still missing from: %1.", listed(std::vector<Text>(names.begin(), names.end())))};
  if (!in.unfinishedEvaluation->unscored.empty()) {
    section.tables.push_back(unscoredTable(in, ledger));
  }
  if (!in.ratings.empty()) {
    section.tables.push_back(classesTable(in, ledger));
  }
  return section;
}

}  // namespace torsio
