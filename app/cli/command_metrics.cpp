// SPDX-License-Identifier: GPL-3.0-or-later
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "app/cli/commands.h"
#include "app/cli/json_output.h"
#include "app/cli/organ_option.h"
#include "app/recording/replay_service.h"
#include "app/recording/trial_trace.h"
#include "assessment/metrics/metric_cards.h"
#include "sim/base/angle.h"
#include "sim/base/error.h"
#include "sim/record/sample_codec.h"
#include "sim/record/trial_file.h"
#include "sim/scene/scene.h"

namespace torsio::cli {

namespace {

using Json = nlohmann::ordered_json;

struct MetricsArguments {
  std::string trial;
  std::string database = "torsio.sqlite";
  OrganArguments organ;
  double tolerance_deg = 2.0;
  bool scene = false;
  bool cards = false;
  TrialMeasurement options;
};

const char* directionText(Direction direction) {
  switch (direction) {
    case Direction::kLowerIsBetter:
      return "lower";
    case Direction::kHigherIsBetter:
      return "higher";
    case Direction::kNeither:
      return "neither";
  }
  return "";
}

Json metricsJson(const Outcome<TrialMetrics>& outcome) {
  return outcomeJson(outcome, [](const TrialMetrics& metrics) {
    Json out = Json::object();
    for (const MetricValue& metric : metrics.values) {
      const MetricCard& card = metricCard(metric.id);
      Json entry{{"value", outcomeJson(metric.value, [](double value) { return Json(value); })}};
      entry["unit"] = std::string(card.unit);
      out[std::string(metric.id)] = std::move(entry);
    }
    return out;
  });
}

Json cardsJson() {
  Json out = Json::object();
  for (const MetricCard& card : metricCards()) {
    out[std::string(card.id)] = {
        {"name", std::string(card.name)},       {"meaning", std::string(card.meaning)},
        {"formula", std::string(card.formula)}, {"unit", std::string(card.unit)},
        {"window", std::string(card.window)},   {"better", directionText(card.direction)},
        {"version", std::string(card.version)}};
  }
  return out;
}

/// A trial file when there is one of this name, else a trial of the database.
Trial loadTrial(const MetricsArguments& arguments) {
  if (std::filesystem::is_regular_file(arguments.trial)) {
    return readTrialFile(arguments.trial);
  }
  return loadStoredTrial(arguments.database, arguments.trial);
}

/// The scene on which the trial was recorded.
Scene sceneOf(const MetricsArguments& arguments, const TrialHeader& header) {
  const SceneRequest chosen = sceneRequest(arguments.organ);
  SceneRequest wanted = sceneRequestFor(header.parametersJson);
  wanted.assets = chosen.assets;
  wanted.id = header.sceneId;
  wanted.pattern = header.patternId;
  wanted.organFile = chosen.organFile;
  wanted.organScale_m = chosen.organScale_m;
  Scene scene = loadScene(wanted);
  if (scene.organHash != header.organHash) {
    throw Error(ErrorCode::kBadData, "this is not the organ on which the trial was recorded",
                "trial " + header.trialId, "Give the mesh file of the recording with --organ");
  }
  return scene;
}

void runMetrics(MetricsArguments arguments) {
  const Trial trial = loadTrial(arguments);
  const std::vector<Sample> samples = decodeTrial(trial);
  arguments.options.tolerance_rad = radians(arguments.tolerance_deg);
  std::optional<Scene> scene;
  if (arguments.scene || arguments.options.shearLimit_Pa) {
    scene = sceneOf(arguments, trial.header);
  }
  const MeasuredTrial measured =
      measureRecordedTrial(trial.header, samples, arguments.options, scene ? &*scene : nullptr);
  Json out;
  out["trial"] = trial.header.trialId;
  out["trainee"] = trial.header.traineeCode;
  out["scene"] = trial.header.sceneId;
  out["pattern"] = trial.header.patternId;
  out["phase"] = trial.header.phaseLabel;
  out["demonstration"] = trial.header.demonstration;
  out["interrupted"] = trial.summary.outcome == TrialOutcome::kInterrupted;
  out["content_hash"] = trial.summary.contentHash;
  out["version"] = kMetricsVersion;
  out["samples"] = samples.size();
  out["refused_samples"] = trial.summary.refusedSamples;
  out["lost_samples"] =
      outcomeJson(measured.whole, [](const TrialMetrics& metrics) { return Json(metrics.lostSamples); });
  out["clock"] = measured.deviceClock ? "device" : "ticks";
  out["duration_s"] = measured.duration_s;
  out["target_rad"] = trial.header.targetAngle_rad;
  out["tolerance_rad"] = arguments.options.tolerance_rad;
  out["whole"] = metricsJson(measured.whole);
  out["twists"] = Json::array();
  for (const MeasuredTwist& twist : measured.twists) {
    Json entry{{"start_s", twist.start_s}, {"samples", twist.samples}};
    entry["target_rad"] = twist.target_rad;
    entry["released_at_rad"] = twist.releasedAt_rad;
    entry["metrics"] = metricsJson(twist.metrics);
    out["twists"].push_back(std::move(entry));
  }
  if (arguments.cards) {
    out["cards"] = cardsJson();
  }
  printJson(out);
}

}  // namespace

void addMetrics(CLI::App& program) {
  auto arguments = std::make_shared<MetricsArguments>();
  CLI::App* command =
      program.add_subcommand("metrics", "Measured quantities of a recorded trial and of each twist in it");
  command->add_option("TRIAL", arguments->trial, "Id of the trial, or its first characters, or a trial file")
      ->required();
  command
      ->add_option("--database", arguments->database,
                   "SQLite file or postgresql://user:password@host:port/database")
      ->capture_default_str();
  command->add_option("--tolerance", arguments->tolerance_deg, "About the target angle, degrees")
      ->check(CLI::Range(0.001, 360.0))
      ->capture_default_str();
  command->add_option("--force-limit", arguments->options.forceLimit_N, "Counts violations, N")
      ->check(CLI::PositiveNumber);
  command->add_option("--torque-limit", arguments->options.torqueLimit_Nm, "Counts violations, N m")
      ->check(CLI::PositiveNumber);
  command->add_option("--shear-limit", arguments->options.shearLimit_Pa, "Time above it, Pa; loads the scene")
      ->check(CLI::PositiveNumber);
  command->add_flag("--scene", arguments->scene, "Load the scene: adds the wander about the organ's axis");
  command->add_option("--organ", arguments->organ.organ, "The mesh file that the trial was recorded on");
  command->add_option("--organ-unit", arguments->organ.unit, "Unit of that file")
      ->check(CLI::IsMember({"mm", "cm", "m"}));
  command->add_flag("--cards", arguments->cards, "Add what each quantity means");
  command->callback([arguments] { runMetrics(*arguments); });
}

}  // namespace torsio::cli
