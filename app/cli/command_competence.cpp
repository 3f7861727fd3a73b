// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include <CLI/CLI.hpp>

#include "app/cli/commands.h"
#include "app/cli/json_output.h"
#include "app/cli/options.h"
#include "app/services/maintenance/maintenance_desk.h"
#include "app/services/recording/competence.h"
#include "app/services/recording/competence_service.h"
#include "assessment/attempt/competence.h"
#include "sim/core/angle.h"

namespace torsio::cli {

namespace {

using Json = nlohmann::ordered_json;

struct CompetenceArguments {
  CompetenceDesign design;
  std::string database = "torsio.sqlite";
  MaintenanceOptions maintenance;
  std::string exercise;
  std::string expertCohort;
  std::optional<double> tolerance_deg;
};

Json designJson(const CompetenceDesign& design) {
  Json json{{"version", design.version}};
  json["tolerance_deg"] = degrees(design.tolerance_rad);
  json["tolerance_source"] = storedText(design.source);
  json["adequate"] = design.adequate;
  json["inadequate"] = design.inadequate;
  json["attempts"] = design.attempts;
  json["limit"] = design.limit;
  const CompetenceErrors errors = competenceErrors(design, design.attempts);
  json["false_pass"] = errors.falsePass;
  json["false_fail"] = errors.falseFail;
  json["false_alarm"] = errors.falseAlarm;
  json["fewest_attempts"] = fewestForAble(design);
  return json;
}

/// Signs in; rights are checked by the services, as in the window.
MaintenanceDesk deskOf(const CompetenceArguments& arguments) {
  return {arguments.maintenance.maintainer(), arguments.database};
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

void addNumbers(CLI::App& command, const std::shared_ptr<CompetenceArguments>& arguments) {
  CompetenceDesign& design = arguments->design;
  addDefaulted(command, "--adequate", design.adequate, "Failure rate of a trainee who is competent");
  addDefaulted(command, "--inadequate", design.inadequate, "Failure rate of a trainee who is not competent");
  addDefaulted(command, "--attempts", design.attempts, "Number of attempts for which the error rates hold");
  addDefaulted(command, "--false-pass", design.falsePassMost,
               "Largest share of inadequate trainees that pass");
  addDefaulted(command, "--false-fail", design.falseFailMost,
               "Largest share of adequate trainees that do not pass");
  command.add_option("--tolerance", arguments->tolerance_deg,
                     "Tolerance in degrees; default: the exercise's");
}

void addDesk(CLI::App& command, const std::shared_ptr<CompetenceArguments>& arguments) {
  addDatabaseArgument(command, "--database", arguments->database, "SQLite file or postgresql://... address")
      ->capture_default_str();
  addSignIn(command, arguments->maintenance, "--login")->required();
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

  command =
      competence->add_subcommand("register", "Registers a design for an exercise; it cannot be changed");
  addDesk(*command, arguments);
  addNumbers(*command, arguments);
  command->add_option("--exercise", arguments->exercise, "Id of the exercise, as show prints it")->required();
  command->add_option("--experts", arguments->expertCohort,
                      "Id of a cohort of experts: the tolerance covers nine in ten of them");
  command->add_option("--reason", arguments->design.reason, "Reason; required with --tolerance");
  command->callback([arguments] { enrolDesign(*arguments); });
}

}  // namespace torsio::cli
