// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdint>
#include <iostream>
#include <memory>
#include <string>

#include <CLI/CLI.hpp>
#include <QUuid>
#include <nlohmann/json.hpp>

#include "app/cli/commands.h"
#include "app/cli/json_output.h"
#include "app/cli/options.h"
#include "app/services/maintenance/copies.h"
#include "app/services/recording/recorded_run.h"
#include "app/services/recording/recording_spec.h"
#include "app/services/recording/unstored_trials.h"
#include "sim/core/clock.h"
#include "sim/core/tissue_model.h"
#include "sim/scene/scene.h"

namespace torsio::cli {

namespace {

struct RecordArguments {
  DatabaseOption database;
  std::string model = "twist";
  double duration_s = 20.0;
  std::uint64_t seed = 1;
  bool json = false;
  OrganArguments organ;
};

void runRecord(const RecordArguments& arguments) {
  SceneRequest request = sceneRequest(arguments.organ);
  request.tissue = tissueModelOf(arguments.model);
  const Scene scene = loadScene(request);
  const TrialStore store(arguments.database.locator());  // creates the database if missing
  for (const Text& closed : closeRecordFiles(arguments.database.locator(), {})) {
    say(closed);
  }
  ScriptedTrial trial;
  trial.recording = {.trialId = QUuid::createUuid().toString(QUuid::WithoutBraces).toStdString(),
                     .startedUtc_us = utcNow_us(),
                     .demonstration = true,
                     .context = stationContext()};
  trial.personSeed = arguments.seed;
  trial.trialSeed = arguments.seed;
  trial.duration_s = arguments.duration_s;
  const std::unique_ptr<TrialSink> sink =
      recordingSink(arguments.database.locator(), trial.recording.context);
  const TrialSummary summary = recordScriptedTrial(scene, trial, *sink);
  if (arguments.json) {
    nlohmann::ordered_json out{{"trial", trial.recording.trialId},
                               {"model", arguments.model},
                               {"scene", scene.id},
                               {"pattern", scene.pattern.id},
                               {"samples", summary.samples},
                               {"content_hash", summary.contentHash}};
    for (const OrganWarning& warning : scene.organWarnings) {
      out["organ_warnings"].push_back(coded(warning).str());
    }
    std::cout << jsonText(out) << '\n';
    return;
  }
  std::cout << "run " << trial.recording.trialId << ", scene " << scene.id << ", pattern " << scene.pattern.id
            << ", model " << arguments.model << ", " << summary.samples << " samples\n"
            << "Replay it: torsio replay " << trial.recording.trialId << " --database " << store.location()
            << " --verify\n";
}

}  // namespace

void addRecord(CLI::App& program) {
  auto arguments = std::make_shared<RecordArguments>();
  CLI::App* command = program.add_subcommand("record", "Record a simulated hand that twists an organ");
  addDatabaseOption(*command, arguments->database)->required();
  addDefaulted(*command, "--model", arguments->model, "Model that responds to the hand: twist, fem, msm",
               CLI::IsMember({"twist", "fem", "msm"}));
  addDefaulted(*command, "--duration", arguments->duration_s, "Seconds to record", CLI::Range(1.0, 3600.0));
  addDefaulted(*command, "--seed", arguments->seed, "Same seed, same hand");
  command->add_flag("--json", arguments->json, "Print JSON");
  addOrganOptions(*command, arguments->organ);
  command->callback([arguments] { runRecord(*arguments); });
}

}  // namespace torsio::cli
