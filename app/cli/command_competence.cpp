// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <cstdint>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>

#include "app/cli/commands.h"
#include "app/cli/json_output.h"
#include "app/cli/options.h"
#include "app/services/maintenance/maintenance_desk.h"
#include "app/services/recording/competence.h"
#include "app/services/recording/competence_service.h"
#include "assessment/attempt/competence.h"
#include "assessment/attempt/competence_simulation.h"
#include "assessment/results/number_format.h"
#include "sim/core/angle.h"
#include "sim/core/error.h"
#include "sim/core/file_io.h"

namespace torsio::cli {

namespace {

using Json = nlohmann::ordered_json;

struct CompetenceArguments {
  CompetenceDesign design;
  DatabaseOption database;
  MaintenanceOptions maintenance;
  std::string exercise;
  std::string expertCohort;
  std::string run;
  std::string excuse;
  std::optional<double> tolerance_deg;
};

Json designJson(const CompetenceDesign& design) {
  Json json{{"version", design.version}};
  json["tolerance_deg"] = degrees(design.tolerance_rad);
  json["tolerance_source"] = storedText(design.source);
  json["adequate"] = design.adequate;
  json["inadequate"] = design.inadequate;
  json["attempts"] = design.attempts;
  json["session_correlation"] = design.sessionCorrelation;
  json["lag_correlation"] = design.lagCorrelation;
  json["runs_per_session"] = design.runsPerSession;
  json["dependence_runs"] = design.dependenceRuns;
  json["valid_days"] = design.validDays;
  json["limit"] = design.limit;
  const CompetenceErrors errors = competenceErrors(design, design.attempts);
  json["false_pass"] = errors.falsePass;
  json["false_fail"] = errors.falseFail;
  json["false_alarm"] = errors.falseAlarm;
  json["fewest_attempts"] = fewestForAble(design);
  const CompetenceOdds odds = competenceOdds(design, design.attempts);
  json["declared_if_failing"] = Json::array();
  for (std::size_t i = 0; i < kStatedFailureRates.size(); ++i) {
    json["declared_if_failing"].push_back(
        {{"failure_rate", kStatedFailureRates[i]}, {"declared", odds.declared[i]}});
  }
  return json;
}

/// Signs in; rights are checked by the services, as in the window.
MaintenanceDesk deskOf(const CompetenceArguments& arguments) {
  return {arguments.maintenance.maintainer(), arguments.database.locator()};
}

void plan(const CompetenceArguments& arguments) {
  CompetenceDesign design = arguments.design;
  design.tolerance_rad = radians(arguments.tolerance_deg.value_or(degrees(design.tolerance_rad)));
  const CompetencePreview preview = previewOfCompetence(design);
  Json json = designJson(preview.design);
  json.erase("version");
  json["false_fail_kept"] = preview.falseFailKept;
  if (!arguments.tolerance_deg) {
    json.erase("tolerance_deg");
    json.erase("tolerance_source");
  }
  printJson(json);
}

void show(const CompetenceArguments& arguments) {
  MaintenanceDesk desk = deskOf(arguments);
  Json all = Json::array();
  for (const ExerciseDesigns& exercise : competenceDesigns(desk.session())) {
    Json json{{"exercise", exercise.moduleId.text()},
              {"curriculum", exercise.curriculum},
              {"curriculum_version", exercise.curriculumVersion},
              {"code", exercise.code},
              {"title", exercise.title}};
    json["shipped"] = designJson(exercise.shipped);
    json["rule"] = competenceRuleText(exercise.inForce).str();
    json["registered"] = Json::array();
    for (const CompetenceDesign& design : exercise.registered) {
      json["registered"].push_back(designJson(design));
    }
    all.push_back(std::move(json));
  }
  printJson(all);
}

void enrolDesign(const CompetenceArguments& arguments) {
  MaintenanceDesk desk = deskOf(arguments);
  CompetenceDesign design = arguments.design;
  design.moduleId = arguments.exercise;
  if (!arguments.expertCohort.empty()) {
    const ProficiencyThreshold experts =
        expertTolerance_deg(desk.session(), design.moduleId, arguments.expertCohort);
    design.source = ToleranceSource::kExperts;
    design.experts = static_cast<std::int64_t>(experts.experts);
    design.tolerance_rad = radians(experts.toleranceBound);
  } else if (arguments.tolerance_deg) {
    design.source = ToleranceSource::kChosen;
    design.tolerance_rad = radians(*arguments.tolerance_deg);
  }
  printJson(designJson(registerCompetence(desk.session(), design)));
}

void listInterrupted(const CompetenceArguments& arguments) {
  MaintenanceDesk desk = deskOf(arguments);
  Json all = Json::array();
  for (const ExerciseDesigns& exercise : competenceDesigns(desk.session())) {
    for (const InterruptedRun& run : interruptedRuns(desk.session(), exercise.moduleId)) {
      all.push_back({{"run", run.trialId.text()},
                     {"exercise", exercise.moduleId.text()},
                     {"title", exercise.title},
                     {"trainee", run.trainee},
                     {"started_utc_us", run.startedUtc_us},
                     {"excused", run.excused},
                     {"reason", run.reason}});
    }
  }
  printJson(all);
}

void excuse(const CompetenceArguments& arguments) {
  MaintenanceDesk desk = deskOf(arguments);
  excuseRun(desk.session(), arguments.run, arguments.excuse);
  std::cout << "The run is excused and does not count as failed.\n";
}

void addNumbers(CLI::App& command, const std::shared_ptr<CompetenceArguments>& arguments) {
  addDesignOptions(command, arguments->design);
  addDefaulted(command, "--attempts", arguments->design.attempts,
               "Number of runs for which the error rates hold");
  command.add_option("--tolerance", arguments->tolerance_deg,
                     "Tolerance in degrees; default: the exercise's");
}

void addDesk(CLI::App& command, const std::shared_ptr<CompetenceArguments>& arguments) {
  addDatabaseOption(command, arguments->database);
  addSignIn(command, arguments->maintenance, "--login")->required();
}

struct SimulateArguments {
  std::int64_t trainees = 2'000;
  std::uint64_t seed = 1;
  std::string designFile;
  bool json = false;
};

/// Reads a design as `plan` and `show` print it; what is missing is taken from the shipped one.
CompetenceDesign designFrom(const std::string& file) {
  const auto refused = [&file](const std::string& what) {
    throw Error(ErrorCode::kBadData, what, file,
                Text::verbatim("Give a file with the output of \"torsio competence plan\""));
  };
  const std::string text = readFile(file);
  const Json json = Json::parse(text, nullptr, false);
  if (!json.is_object()) {
    refused("this is not a JSON object");
  }
  CompetenceDesign design;
  const auto take = [&](const char* key, auto& value) {
    if (const auto found = json.find(key); found != json.end()) {
      if (!found->is_number()) {
        refused(std::string(key) + " is not a number");
      }
      found->get_to(value);
    }
  };
  take("adequate", design.adequate);
  take("inadequate", design.inadequate);
  take("attempts", design.attempts);
  take("limit", design.limit);
  requireSoundNumbers(design);
  if (!(design.limit > 0.0)) {
    refused("the limit is not above 0");
  }
  return design;
}

/// `trainees`: how many were simulated, from which the standard error of `declared` follows.
Json shareJson(const SimulatedShare& share, std::int64_t trainees) {
  return {
      {"failure_rate", share.failureRate},
      {"declared", share.declared},
      {"standard_error", std::sqrt(share.declared * (1.0 - share.declared) / static_cast<double>(trainees))},
      {"printed", share.printed}};
}

void simulate(const SimulateArguments& arguments) {
  const bool own = !arguments.designFile.empty();
  const std::vector<CompetenceScenario> scenarios = simulateCompetence(
      own ? designFrom(arguments.designFile) : CompetenceDesign{}, arguments.trainees, arguments.seed, own);
  if (!arguments.json) {
    std::cout << "Declared competent within the planned runs, simulated (as printed), per cent\n";
    for (const CompetenceScenario& scenario : scenarios) {
      const auto shown = [](const SimulatedShare& share) {
        return formatFixed(100.0 * share.declared, 1) + " (" + formatFixed(100.0 * share.printed, 1) +
               ") of those who fail " + formatFixed(100.0 * share.failureRate, 0) + " %";
      };
      std::cout << scenario.name << ": " << shown(scenario.inadequate) << ", " << shown(scenario.adequate)
                << "; before the centre has enough runs: " << shown(scenario.assumedInadequate) << ", "
                << shown(scenario.assumedAdequate) << "; " << scenario.description << "\n";
    }
    return;
  }
  Json out{{"trainees", arguments.trainees}, {"seed", arguments.seed}, {"scenarios", Json::array()}};
  for (const CompetenceScenario& scenario : scenarios) {
    Json json{{"name", scenario.name}, {"description", scenario.description}};
    json["failure_rate"] = scenario.inadequate.failureRate;
    json["declared"] = scenario.inadequate.declared;
    json["printed"] = scenario.inadequate.printed;
    json["adequate"] = shareJson(scenario.adequate, arguments.trainees);
    json["assumed"] = {{"inadequate", shareJson(scenario.assumedInadequate, arguments.trainees)},
                       {"adequate", shareJson(scenario.assumedAdequate, arguments.trainees)}};
    json["session_correlation"] = scenario.design.sessionCorrelation;
    json["lag_correlation"] = scenario.design.lagCorrelation;
    json["runs_per_session"] = scenario.design.runsPerSession;
    json["dependence_runs"] = scenario.design.dependenceRuns;
    json["attempts"] = scenario.design.attempts;
    json["limit"] = scenario.design.limit;
    json["fewest_attempts"] = fewestForAble(scenario.design);
    out["scenarios"].push_back(std::move(json));
  }
  printJson(out);
}

void addSimulate(CLI::App& competence) {
  auto arguments = std::make_shared<SimulateArguments>();
  CLI::App* command = competence.add_subcommand(
      "simulate", "Simulates the rule on trainees whose runs depend on each other, beside the printed rates");
  addDefaulted(*command, "--trainees", arguments->trainees,
               "Simulated trainees of each failure rate and scenario",
               CLI::Range(std::int64_t{1}, kMaxSimulatedTrainees));
  addDefaulted(*command, "--seed", arguments->seed, "Seed of the random numbers");
  command->add_option(
      "--design", arguments->designFile,
      "File with a design as plan prints it, whose limit is kept; default: the shipped design, "
      "its limit chosen anew for each scenario, as registering does");
  command->add_flag("--json", arguments->json, "Print JSON");
  command->callback([arguments] { simulate(*arguments); });
}

}  // namespace

void addCompetence(CLI::App& program) {
  auto arguments = std::make_shared<CompetenceArguments>();
  CLI::App* competence =
      program.add_subcommand("competence", "When trainees count as competent, with the error rates");
  competence->require_subcommand(1);

  CLI::App* command = competence->add_subcommand("plan", "Chooses the limit and prints both error rates");
  addNumbers(*command, arguments);
  command->callback([arguments] { plan(*arguments); });

  command = competence->add_subcommand("show", "Prints the designs of all exercises of a record");
  addDesk(*command, arguments);
  command->callback([arguments] { show(*arguments); });

  addSimulate(*competence);

  command =
      competence->add_subcommand("register", "Registers a design for an exercise; it cannot be changed");
  addDesk(*command, arguments);
  addNumbers(*command, arguments);
  command->add_option("--exercise", arguments->exercise, "Id of the exercise, as show prints it")->required();
  command->add_option("--experts", arguments->expertCohort,
                      "Id of a cohort of experts: the tolerance covers nine in ten of them");
  command->add_option("--reason", arguments->design.reason, "Reason; required with --tolerance");
  addDefaulted(*command, "--valid-days", arguments->design.validDays,
               "Days that competence lasts after the last run; 0: it does not expire");
  command->callback([arguments] { enrolDesign(*arguments); });

  command = competence->add_subcommand(
      "interrupted", "Lists the interrupted runs, which count as failed unless they are excused");
  addDesk(*command, arguments);
  command->callback([arguments] { listInterrupted(*arguments); });

  command = competence->add_subcommand("excuse", "Excuses an interrupted run; final, in the audit trail");
  addDesk(*command, arguments);
  command->add_option("--run", arguments->run, "Id of the run, as interrupted prints it")->required();
  command->add_option("--reason", arguments->excuse, "Why it does not count as failed")->required();
  command->callback([arguments] { excuse(*arguments); });
}

}  // namespace torsio::cli
