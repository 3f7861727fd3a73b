// SPDX-License-Identifier: GPL-3.0-or-later
#include <iostream>
#include <memory>
#include <string>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "app/cli/commands.h"
#include "app/cli/json_output.h"
#include "app/cli/options.h"
#include "app/services/recording/trial_playback.h"
#include "sim/core/error.h"

namespace torsio::cli {

namespace {

struct ReplayArguments {
  std::string trial;
  DatabaseOption database;
  OrganArguments organ;
  bool verify = false;
  bool json = false;
};

std::string differenceText(const ReplayReport& report) {
  if (!report.contentIntact) {
    return "the record's own hashes do not fit: it was changed or damaged";
  }
  if (report.gapAfterTick) {
    return "samples are missing after tick " + std::to_string(*report.gapAfterTick);
  }
  if (!report.first) {
    return "none";
  }
  return report.first->field + " at tick " + std::to_string(report.first->tick);
}

void print(const ReplayResult& result, bool json) {
  const ReplayReport& report = result.report;
  if (!json) {
    std::cout << "run " << result.header.trialId << ", scene " << result.header.sceneId << ", pattern "
              << result.header.patternId << ", model " << tissueModelId(result.header.model) << ", "
              << report.samples << " samples\n"
              << (report.identical() ? std::string("replay is bit-identical to the recording")
                                     : "replay differs: " + differenceText(report))
              << "\n";
    return;
  }
  nlohmann::ordered_json out;
  out["trial"] = result.header.trialId;
  out["scene"] = result.header.sceneId;
  out["pattern"] = result.header.patternId;
  out["model"] = std::string(tissueModelId(result.header.model));
  out["recorded_with"] = result.header.softwareVersion;
  out["samples"] = report.samples;
  out["chunks"] = report.chunks;
  out["identical"] = report.identical();
  out["content_hash"] = result.summary.contentHash;
  if (!report.identical()) {
    out["first_difference"] = differenceText(report);
  }
  std::cout << jsonText(out) << '\n';
}

void runReplay(const ReplayArguments& arguments) {
  const SceneRequest scene = sceneRequest(arguments.organ);
  ReplayRequest request;
  request.database = arguments.database.locator();
  request.trialId = arguments.trial;
  request.assets = scene.assets;
  request.organFile = scene.organFile;
  request.organScale_m = scene.organScale_m;
  const ReplayResult result = replayStoredTrial(request);
  print(result, arguments.json);
  if (arguments.verify && !result.report.identical()) {
    throw Error(ErrorCode::kVerifyFailed,
                "the replay differs from the recording (" + differenceText(result.report) + ")",
                "run " + result.header.trialId,
                "Check that the recording was made by this version (" + result.header.softwareVersion + ")");
  }
}

}  // namespace

void addReplay(CLI::App& program) {
  auto arguments = std::make_shared<ReplayArguments>();
  CLI::App* command =
      program.add_subcommand("replay", "Compute a recorded run again from its device samples");
  command->add_option("RUN", arguments->trial, "Id of the run, or its first characters")->required();
  addDatabaseOption(*command, arguments->database);
  command->add_option("--organ", arguments->organ.organ, "The mesh file that the run was recorded on");
  addUnitOption(*command, arguments->organ.unit);
  command->add_flag("--verify", arguments->verify, "Exit with code 13 unless the replay is bit-identical");
  command->add_flag("--json", arguments->json, "Print JSON");
  command->callback([arguments] { runReplay(*arguments); });
}

}  // namespace torsio::cli
