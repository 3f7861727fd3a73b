// SPDX-License-Identifier: GPL-3.0-or-later

#include "tests/support/demonstration_cohort.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <regex>
#include <utility>

#include <gtest/gtest.h>

#include "assessment/results/cohort_csv.h"
#include "assessment/results/provenance_line.h"
#include "assessment/scoring/demonstration_marks.h"

namespace torsio::testing {

namespace {

std::vector<std::string> codes(char letter, std::size_t count) {
  std::vector<std::string> out;
  for (std::size_t i = 1; i <= count; ++i) {
    std::string code(1, letter);
    code += std::to_string(100 + i);
    out.push_back(code);
  }
  return out;
}

}  // namespace

CohortInputs demonstrationCohort() {
  CohortInputs in;
  in.demonstration = true;
  in.simulated = {demonstrationTrainingRule()};
  in.softwareVersion = "0.1.0";
  in.trainingTimeDivisor = 60;
  in.groups = {{Text::verbatim("Group %1", 1), Text::verbatim("40 min virtual")},
               {Text::verbatim("Group %1", 2), Text::verbatim("20 min virtual, 20 min real arm")},
               {Text::verbatim("Group %1", 3), Text::verbatim("40 min real arm")}};
  in.occasions = {Text::verbatim("before"), Text::verbatim("after %1 min", 20),
                  Text::verbatim("after %1 min", 40)};
  DemonstrationPeople people{{codes('x', 10), codes('y', 10), codes('z', 10)},
                             codes('R', 10),
                             {codes('A', 20), codes('B', 10), codes('C', 10)}};
  for (std::size_t g = 0; g < 3; ++g) {
    for (std::size_t i = 0; i < 10; ++i) {
      in.trainees.push_back({people.groups[g][i], g, i % 2 == 0 ? "male" : "female", "first-year graduate"});
    }
  }
  const std::vector<std::string> models = {"PM", "FEM", "MSM"};
  in.instrument = paperInstrument();
  in.ratings = groupRatings(in.instrument, demonstrationEvaluationMarks(in.instrument, people, models, 3));
  for (const ModelRatings& model : in.ratings) {
    in.evaluations.push_back(evaluateModel(in.instrument, model));
  }
  const std::vector<TrainingMark> marks = demonstrationTrainingMarks(in.trainingScale, people, 3);
  in.scores = traineeScores(in.trainingScale, marks);
  in.summaries = groupSummaries(in.trainingScale, marks);
  in.trainingRaters = 10;
  in.trainingMarks = marks;
  in.sheets = {{"Arm sheet",
                2,
                {{"time", "Pace", 1.0, 10.0, 1.0, {{1.0, "far too slow"}, {10.0, "quick and steady"}}},
                 {"accuracy", "Aim", 1.0, 10.0, 0.5, {}}}}};
  for (const TrainingMark& mark : marks) {
    const double points = pointsFromSteps(mark.steps, in.trainingScale);
    in.criterionMarks.push_back({mark.trainee, mark.rater, mark.group, mark.occasion, 0, 0, points});
    in.criterionMarks.push_back(
        {mark.trainee, mark.rater, mark.group, mark.occasion, 0, 1, 0.5 * points + 1.0});
  }
  TrialSummaryRow trial;
  trial.trialId = "t1";
  trial.trainee = "x101";
  trial.phase = Text::verbatim("virtual 0-20 min");
  trial.model = "saint_venant";
  trial.minutes = 0.5;
  trial.samples = 30000;
  trial.twists = 4;
  trial.meanAbsoluteError_deg = 3.25;
  trial.contentHash = std::string(64, 'a');
  in.trials = {trial};
  return in;
}

namespace {

bool allFinite(const ReportFigure& figure) {
  bool finite = true;
  for (const FigureSeries& series : figure.series) {
    for (const std::optional<double>& y : series.y) {
      finite = finite && (!y || std::isfinite(*y));
    }
    for (const std::vector<double>* list : {&series.x, &series.low, &series.high}) {
      finite = finite && std::all_of(list->begin(), list->end(), [](double x) { return std::isfinite(x); });
    }
  }
  return finite;
}

}  // namespace

CohortInputs scored(CohortInputs in) {
  in.scores = traineeScores(in.trainingScale, in.trainingMarks);
  in.summaries = groupSummaries(in.trainingScale, in.trainingMarks);
  return in;
}

CohortInputs losing(const std::function<bool(const TrainingMark&)>& lost) {
  CohortInputs in = demonstrationCohort();
  std::erase_if(in.trainingMarks, lost);
  return scored(std::move(in));
}

CohortInputs marking(const std::function<void(TrainingMark&)>& change) {
  CohortInputs in = demonstrationCohort();
  for (TrainingMark& mark : in.trainingMarks) {
    change(mark);
  }
  return scored(std::move(in));
}

CohortInputs withUntwistings() {
  CohortInputs in = demonstrationCohort();
  const auto add = [&in](std::map<std::string, double> values) {
    TrialSummaryRow trial;
    trial.trialId = "untwisting-" + std::to_string(in.trials.size());
    trial.trainee = in.trainees.front().code;
    trial.phase = Text::tr("volvulus");
    trial.samples = 1000;
    trial.detorsion = std::move(values);
    in.trials.push_back(trial);
  };
  add({{"detorse.done", 1.0},
       {"detorse.relapse", 0.0},
       {"detorse.first_direction", 1.0},
       {"detorse.time_to_flow", 20.0},
       {"detorse.dose", 0.2},
       {"detorse.overload_time", 0.0},
       {"detorse.regrips", 3.0},
       {"detorse.least_regrips", 2.0},
       {"detorse.slip_back", 0.0}});
  add({{"detorse.done", 1.0},
       {"detorse.relapse", 1.0},
       {"detorse.first_direction", 0.0},
       {"detorse.time_to_flow", 40.0},
       {"detorse.dose", 0.4},
       {"detorse.overload_time", 0.8},
       {"detorse.regrips", 5.0},
       {"detorse.least_regrips", 2.0},
       {"detorse.slip_back", 1.0}});
  add({{"detorse.done", 0.0},
       {"detorse.dose", 1.2},
       {"detorse.overload_time", 0.0},
       {"detorse.regrips", 0.0},
       {"detorse.least_regrips", 1.0},
       {"detorse.slip_back", 0.0}});
  return in;
}

CohortInputs aClassOfRatersIsMissing() {
  CohortInputs in = demonstrationCohort();
  UnfinishedEvaluation unfinished;
  unfinished.classesMissing = {in.instrument.classes[2].name};
  for (ModelRatings& model : in.ratings) {
    std::erase_if(model.sheets, [](const RaterSheet& sheet) { return sheet.raterClass == 2; });
    unfinished.marks += 9 * std::ssize(model.sheets);
    UnscoredIndices of{in.instrument.classes[2].name, model.model, {}};
    for (const EvaluationIndex& index : in.instrument.indices) {
      of.indices.push_back(index.name);
    }
    unfinished.unscored.push_back(of);
  }
  in.unfinishedEvaluation = unfinished;
  in.evaluations.clear();
  return in;
}

const ReportFigure* figureNamed(const ReportModel& report, const std::string& id) {
  for (const ReportSection& section : report.sections) {
    for (const ReportFigure& figure : section.figures) {
      if (figure.id == id) {
        return &figure;
      }
    }
  }
  return nullptr;
}

const ReportTable* tableNamed(const ReportModel& report, const std::string& id) {
  for (const ReportSection& section : report.sections) {
    for (const ReportTable& table : section.tables) {
      if (table.id == id) {
        return &table;
      }
    }
  }
  return nullptr;
}

std::string firstPageOf(const ReportModel& report) {
  std::string all;
  for (const ReportParagraph& paragraph : report.sections.front().paragraphs) {
    all += paragraph.str() + "\n";
  }
  return all;
}

std::string paragraphsOf(const ReportModel& report) {
  std::string all;
  for (const ReportSection& section : report.sections) {
    for (const Text& paragraph : section.paragraphs) {
      all += paragraph.str() + "\n";
    }
  }
  return all;
}

std::vector<CohortCsvRow> rowsNamed(const CohortInputs& in, const std::string& statistic) {
  std::vector<CohortCsvRow> found = cohortCsvRows(in);
  std::erase_if(found, [&](const CohortCsvRow& row) { return row.statistic != statistic; });
  return found;
}

std::int64_t csvCount(const CohortInputs& in, const std::string& statistic) {
  return static_cast<std::int64_t>(rowsNamed(in, statistic).size());
}

std::vector<Said> everythingSaid(const ReportModel& report) {
  std::vector<Said> all;
  const auto add = [&](const Text& text, const std::string& head = {}) { all.push_back({head, text.str()}); };
  for (const auto& [label, value] : report.facts) {
    add(value);
  }
  for (const ReportSection& section : report.sections) {
    for (const Text& paragraph : section.paragraphs) {
      add(paragraph);
    }
    for (const ReportFigure& figure : section.figures) {
      for (const Text& note : figure.notes) {
        add(note);
      }
      for (const Text& category : figure.categories) {
        add(category, figure.title.str());
      }
      add(provenanceLine(figure.provenance));
    }
    for (const ReportTable& table : section.tables) {
      for (const std::vector<ReportCell>& row : table.rows) {
        for (std::size_t c = 0; c < row.size(); ++c) {
          add(row[c], table.columns.at(c).str());
        }
      }
      for (const Text& note : table.notes) {
        add(note);
      }
      add(provenanceLine(table.provenance));
    }
  }
  return all;
}

std::string textOfAll(const CohortInputs& in) {
  std::string all;
  for (const Said& one : everythingSaid(cohortReport(in))) {
    all += one.text + "\n";
  }
  return all;
}

void expectWellSaid(const CohortInputs& in) {
  const std::regex noNumber(R"(\b(nan|inf)\b)");
  const std::regex interval(R"(\[-?[0-9.]+[,;] -?[0-9.]+\])");
  const auto has = [](const std::string& text, const char* part) {
    return text.find(part) != std::string::npos;
  };
  const auto saysLevel = [&](const std::string& text) {
    return has(text, "95 %") || has(text, "90 %") || has(text, "lowest; highest");
  };
  const ReportModel report = cohortReport(in);
  for (const Said& one : everythingSaid(report)) {
    EXPECT_FALSE((has(one.text, "nan") || has(one.text, "inf")) && std::regex_search(one.text, noNumber))
        << one.text;
    EXPECT_FALSE(has(one.text, "p = 0.000") || has(one.text, "%1")) << one.text;
    if (has(one.text, "[") && std::regex_search(one.text, interval)) {
      EXPECT_TRUE(saysLevel(one.text) || saysLevel(one.head)) << one.head << ": " << one.text;
    }
  }
  for (const ReportSection& section : report.sections) {
    for (const ReportFigure& figure : section.figures) {
      EXPECT_TRUE(allFinite(figure)) << figure.id;
    }
  }
  for (const CohortCsvRow& row : cohortCsvRows(in)) {
    EXPECT_FALSE(row.value == "nan" || row.value == "-nan" || row.value == "inf" || row.value == "-inf")
        << numberAddress(row);
    EXPECT_TRUE(!row.value.empty() || has(row.flags, "undefined")) << numberAddress(row);
  }
}

}  // namespace torsio::testing
