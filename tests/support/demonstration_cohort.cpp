// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/demonstration_cohort.h"

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

}  // namespace torsio::testing
