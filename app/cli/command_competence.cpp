// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include <CLI/CLI.hpp>

#include "app/access/access_service.h"
#include "app/access/session_context.h"
#include "app/cli/commands.h"
#include "app/cli/json_output.h"
#include "app/recording/competence_service.h"
#include "assessment/attempt/competence.h"
#include "sim/base/angle.h"
#include "sim/base/error.h"

namespace torsio::cli {

namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kPasswordVariable = "TORSIO_PASSWORD";

struct CompetenceArguments {
  CompetenceDesign design;
  std::string database = "torsio.sqlite";
  std::string login;
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
  json["fewest_attempts"] = fewestForAble(design);
  return json;
}

/// A session of somebody with a password; rights are asked for by the services, as in the window.
SessionContext signedIn(const CompetenceArguments& arguments) {
  const char* password = std::getenv(kPasswordVariable);  // NOLINT(concurrency-mt-unsafe): before any thread
  if (password == nullptr) {
    throw Error(ErrorCode::kUsage, Text::verbatim("no password was given"), std::string(kPasswordVariable),
                Text::verbatim("Put the password of this login into the environment variable"));
  }
  if (arguments.database.find("://") == std::string::npos && !std::filesystem::exists(arguments.database)) {
    throw Error(ErrorCode::kFileMissing, Text::verbatim("there is no such database"), arguments.database,
                Text::verbatim("Give the file of the record with --database"));
  }
  SessionContext session({.locator = arguments.database, .station = stationName()});
  if (signIn(session, arguments.login, password).outcome != SignIn::kOk) {
    throw Error(ErrorCode::kPermission, Text::verbatim("signing in failed"), arguments.login,
                Text::verbatim("Sign in at the window once to see why"));
  }
  return session;
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
  SessionContext session = signedIn(arguments);
  Json all = Json::array();
  session.beginCall();
  for (const ExerciseDesigns& exercise : competenceDesigns(session)) {
    Json json{{"exercise", exercise.moduleId.text()},
              {"curriculum", exercise.curriculum},
              {"curriculum_version", exercise.curriculumVersion},
              {"code", exercise.code},
              {"title", exercise.title}};
    json["shipped"] = designJson(exercise.shipped);
    json["registered"] = Json::array();
    for (const CompetenceDesign& design : exercise.registered) {
      json["registered"].push_back(designJson(design));
    }
    all.push_back(std::move(json));
  }
  printJson(all);
}

void enrolDesign(const CompetenceArguments& arguments) {
  SessionContext session = signedIn(arguments);
  CompetenceDesign design = arguments.design;
  design.moduleId = arguments.exercise;
  if (!arguments.expertCohort.empty()) {
    session.beginCall();
    const ProficiencyThreshold experts =
        expertTolerance_deg(session, design.moduleId, arguments.expertCohort);
    design.source = ToleranceSource::kExperts;
    design.experts = static_cast<std::int64_t>(experts.experts);
    design.tolerance_rad = radians(experts.toleranceBound);
  } else if (arguments.tolerance_deg) {
    design.source = ToleranceSource::kChosen;
    design.tolerance_rad = radians(*arguments.tolerance_deg);
  }
  session.beginCall();
  printJson(designJson(registerCompetence(session, design)));
}

void addNumbers(CLI::App& command, const std::shared_ptr<CompetenceArguments>& arguments) {
  CompetenceDesign& design = arguments->design;
  command.add_option("--adequate", design.adequate, "Failure rate of a trainee who is able")
      ->capture_default_str();
  command.add_option("--inadequate", design.inadequate, "Failure rate of one who is not")
      ->capture_default_str();
  command.add_option("--attempts", design.attempts, "Attempts within which the error rates are promised")
      ->capture_default_str();
  command.add_option("--false-pass", design.falsePassMost, "Largest share of inadequate trainees that pass")
      ->capture_default_str();
  command
      .add_option("--false-fail", design.falseFailMost, "Largest share of adequate trainees that do not pass")
      ->capture_default_str();
  command.add_option("--tolerance", arguments->tolerance_deg, "Degrees; without it that of the exercise");
}

void addSignIn(CLI::App& command, const std::shared_ptr<CompetenceArguments>& arguments) {
  command.add_option("--database", arguments->database, "SQLite file or postgresql://... address")
      ->capture_default_str();
  command.add_option("--login", arguments->login, "Who signs in; the password stands in TORSIO_PASSWORD")
      ->required();
}

}  // namespace

void addCompetence(CLI::App& program) {
  auto arguments = std::make_shared<CompetenceArguments>();
  CLI::App* competence = program.add_subcommand(
      "competence", "By what trainees are held to be able, and how often that is wrong");
  competence->require_subcommand(1);

  CLI::App* command = competence->add_subcommand("plan", "Chooses the limit and prints both error rates");
  addNumbers(*command, arguments);
  command->callback([arguments] { plan(*arguments); });

  command = competence->add_subcommand("show", "Prints the designs of all exercises of a record");
  addSignIn(*command, arguments);
  command->callback([arguments] { show(*arguments); });

  command = competence->add_subcommand("register", "Registers a design for an exercise; it never changes");
  addSignIn(*command, arguments);
  addNumbers(*command, arguments);
  command->add_option("--exercise", arguments->exercise, "Id of the exercise, as show prints it")->required();
  command->add_option("--experts", arguments->expertCohort,
                      "Id of a cohort of experts: the tolerance covers nine in ten of them");
  command->add_option("--reason", arguments->design.reason, "Why; needed with a tolerance of one's own");
  command->callback([arguments] { enrolDesign(*arguments); });
}

}  // namespace torsio::cli
