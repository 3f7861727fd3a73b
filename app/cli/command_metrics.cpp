// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "app/cli/commands.h"
#include "app/cli/json_output.h"
#include "app/cli/options.h"
#include "app/services/recording/kept_digests.h"
#include "app/services/recording/trial_playback.h"
#include "assessment/attempt/attempt_measures.h"
#include "assessment/attempt/force_felt.h"
#include "assessment/attempt/foreign_measures.h"
#include "assessment/attempt/run_verdict.h"
#include "assessment/catalogue/quantity.h"
#include "sim/core/angle.h"
#include "sim/core/error.h"
#include "sim/core/foreign_recording.h"
#include "sim/record/sample_codec.h"
#include "sim/record/trial_file.h"
#include "sim/scene/hollow_validity.h"
#include "sim/scene/scene.h"
#include "sim/servo/pose_track.h"

namespace torsio::cli {

namespace {

using Json = nlohmann::ordered_json;

struct MetricsArguments {
  std::string trial;
  DatabaseOption database;
  OrganArguments organ;
  std::optional<double> tolerance_deg;
  std::optional<double> forceLimit_N;
  std::optional<double> torqueLimit_Nm;
  std::optional<double> shearLimit_Pa;
  bool scene = false;
  bool cards = false;
};

constexpr std::array kBetter{"lower", "higher", "neither"};

Json valuesJson(const MetricValues& values) {
  Json out = Json::object();
  for (const auto& [quantity, value] : values.all()) {
    Json entry{{"value", outcomeJson(value, [](double number) { return Json(number); })}};
    entry["unit"] = rowOf(quantity).unit;
    out[idOf(quantity)] = std::move(entry);
  }
  return out;
}

Json metricsJson(const Outcome<TrialMetrics>& outcome) {
  return outcomeJson(outcome, [](const TrialMetrics& metrics) { return valuesJson(metrics); });
}

/// The values of the attempt by stored id, in SI.
Json attemptJson(const QuantityValues& values) {
  Json out = Json::object();
  for (const auto& [quantity, value] : values) {
    out[idOf(quantity)] = value;
  }
  return out;
}

Json verdictJson(const RunVerdict& verdict) {
  Json out{{"outcome", storedText(verdict.outcome)},
           {"text", verdict.sentence().str()},
           {"cause", verdict.cause().str()},
           {"remedy", verdict.remedy().str()},
           {"checks", Json::array()}};
  for (const TargetCheck& check : verdict.checks) {
    out["checks"].push_back({{"text", check.text().str()}, {"passed", check.passed}});
  }
  return out;
}

/// An untwisting: its metrics, the initial angle, and the tissue's times.
Json detorsionJson(const MeasuredDetorsion& measured, const AttemptRules& rules) {
  return outcomeJson(measured.metrics, [&](const DetorsionMetrics& detorsion) {
    const double timeScale = rules.detorsion ? rules.detorsion->timeScale : 1.0;
    Json out{{"start_rad", detorsion.start_rad}, {"time_scale", timeScale}};
    out["done_s"] = detorsion.done_s ? Json(*detorsion.done_s) : Json();
    out["tissue_time_to_flow_s"] = outcomeJson(detorsion.at(Quantity::kTimeToFlow),
                                               [&](double time_s) { return Json(timeScale * time_s); });
    out["metrics"] = valuesJson(detorsion);
    return out;
  });
}

Json cardsJson() {
  Json out = Json::object();
  for (const QuantityRow& row : quantityRows()) {
    out[std::string(row.id)] = {{"name", row.name.english()},
                                {"meaning", row.meaning.english()},
                                {"formula", row.formula.english()},
                                {"unit", row.unit},
                                {"shown_unit", row.shown.unit},
                                {"decimals", row.shown.decimals},
                                {"window", row.window.english()},
                                {"better", wordOf(row.direction, kBetter)},
                                {"version", row.version}};
  }
  return out;
}

/// Reads a trial file and finds the rules of its pattern.
LoadedRun readRunFile(const std::filesystem::path& file) {
  LoadedRun run{readTrialFile(file), {}};
  const TrialHeader& header = run.trial.header;
  run.rules = recordedRules(ExerciseRules().ofPattern(header.sceneId, header.patternId), header);
  return run;
}

/// Loads a trial file if there is one with this name, otherwise a trial of the database with the rules of its
/// exercise. Options override the rules.
LoadedRun loadRun(const MetricsArguments& arguments) {
  LoadedRun run = std::filesystem::is_regular_file(arguments.trial)
                      ? readRunFile(arguments.trial)
                      : loadStoredRun(arguments.database.locator(), arguments.trial);
  if (arguments.tolerance_deg) {
    run.rules.tolerance_rad = radians(*arguments.tolerance_deg);
  }
  if (arguments.forceLimit_N) {
    run.rules.forceLimit_N = arguments.forceLimit_N;
  }
  if (arguments.torqueLimit_Nm) {
    run.rules.torqueLimit_Nm = arguments.torqueLimit_Nm;
  }
  return run;
}

/// What the metrics need to know of the scene, which must outlive the result.
OrganKnowledge organOf(const Scene& scene, const Trial& trial) {
  OrganKnowledge organ;
  organ.axisAt = [&scene](double arc_m) {
    const AxisFrame frame = scene.graspFrame(arc_m, {});
    return GraspAxis{frame.centre_m, frame.tangent};
  };
  const auto poses = std::make_shared<const PoseTrack>(scene, trial.header, trial.chunks);
  organ.peakShear_Pa = [&scene, poses](const Sample& sample) {
    const TwistResponse& response = sample.response;
    OrganState state{{response.graspArc_m, response.angle_rad}, poses->at(sample.device.time_us)};
    state.hollow = poses->hollowAt(sample.device.time_us);
    state.hollow.reading = sample.hollow;
    const bool atRest = scene.rod ? state.pose.count == 0 : response.angle_rad == 0.0;
    return atRest ? 0.0 : scene.peakShear_Pa(state);
  };
  return organ;
}

constexpr std::array kEndings{"let go", "recording ended", "device fault", "samples missing"};

Json twistJson(const MeasuredTwist& measured) {
  const RecordedTwist& twist = measured.twist;
  Json entry{{"start_s", measured.start_s}, {"samples", twist.end - twist.first}};
  entry["target_rad"] = twist.target_rad;
  entry["released_at_rad"] = twist.releasedAt_rad;
  entry["ending"] = wordOf(twist.ending, kEndings);
  entry["on_target"] = measured.onTarget;
  entry["metrics"] = metricsJson(measured.metrics);
  return entry;
}

/// Returns the scene in which the trial was recorded.
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
    refuse(Text::verbatim("this is not the organ on which the run was recorded"), "run " + header.trialId,
           Text::verbatim("Give the mesh file of the recording with --organ"));
  }
  return scene;
}

/// Adds whether the law of the wall was checked for all of a run, as its recording says.
void addValidity(Json& out, const RecordedValidity& recorded, const std::vector<Sample>& samples) {
  double farthest_rad = 0.0;
  for (const Sample& sample : samples) {
    farthest_rad = std::max(farthest_rad, std::abs(sample.response.angle_rad));
  }
  out["valid"] = farthest_rad <= recorded.validTo_rad;
  out["valid_to_rad"] = recorded.validTo_rad;
  if (farthest_rad > recorded.validTo_rad) {
    out["beyond"] = recorded.beyond;
  }
}

void runMetrics(const MetricsArguments& arguments) {
  const LoadedRun run = loadRun(arguments);
  const Trial& trial = run.trial;
  const std::vector<Sample> samples = decodeTrial(trial);
  std::optional<Scene> scene;
  if (arguments.scene || arguments.shearLimit_Pa) {
    scene = sceneOf(arguments, trial.header);
  }
  OrganKnowledge organ = scene ? organOf(*scene, trial) : OrganKnowledge{};
  organ.shearLimit_Pa = arguments.shearLimit_Pa;
  const MeasuredTrial measured = measureTwists(trial.header, samples, run.rules, organ);
  const bool foreign = isForeign(trial.header.sceneId);
  const AttemptMeasures measures =
      foreign ? measureAttempt(trial.header, samples, run.rules) : measureAttempt(measured);
  const Outcome<TrialMetrics> whole = measureWhole(trial.header, samples, run.rules, organ);
  Json out;
  out["trial"] = trial.header.trialId;
  out["kind"] = foreign ? "foreign" : "simulated";
  out["trainee"] = trial.header.traineeCode;
  out["scene"] = trial.header.sceneId;
  out["pattern"] = trial.header.patternId;
  out["phase"] = trial.header.phaseLabel;
  out["demonstration"] = trial.header.demonstration;
  out["device"] = trial.header.deviceModel;
  out["force_felt"] = !foreign && forceFelt(trial.header.drive);
  out["interrupted"] = trial.summary.outcome == TrialOutcome::kInterrupted;
  out["content_hash"] = trial.summary.contentHash;
  out["version"] = kMetricsVersion;
  out["samples"] = samples.size();
  out["refused_samples"] = trial.summary.refusedSamples;
  if (const std::optional<ServoHealth>& health = trial.summary.health) {
    out["servo"] = {{"real_time_priority", health->priority},
                    {"memory_locked", health->memory},
                    {"skipped_ticks", health->skippedTicks},
                    {"force_cuts", health->forceCuts}};
  }
  out["lost_samples"] =
      outcomeJson(whole, [](const TrialMetrics& metrics) { return Json(metrics.lostSamples); });
  if (foreign) {
    out["late_samples"] = trial.summary.lateTicks;
    out["told"] = Json::array();
    for (const Text& sentence : foreignSentences(measures.values)) {
      out["told"].push_back(sentence.str());
    }
  }
  out["clock"] = measured.deviceClock ? "device" : "ticks";
  out["duration_s"] = measured.duration_s();
  if (!foreign) {
    out["target_rad"] = trial.header.targetAngle_rad;
    out["tolerance_rad"] = run.rules.tolerance_rad;
    out["twists_completed"] = measures.twists.size();
    out["twists_on_target"] = measures.twistsOnTarget();
    out["twists_not_completed"] = measures.unfinished;
  }
  out["attempt"] = attemptJson(measures.values);
  out["verdict"] = verdictJson(verdictOn(trial.summary, measures, run.rules));
  out["whole"] = metricsJson(whole);
  if (measured.detorsion) {
    out["detorsion"] = detorsionJson(*measured.detorsion, run.rules);
    const std::string& parameters = scene ? scene->parametersJson : trial.header.parametersJson;
    if (const std::optional<RecordedValidity> recorded = recordedValidity(parameters)) {
      addValidity(out["detorsion"], *recorded, samples);
    }
  }
  out["twists"] = Json::array();
  for (const MeasuredTwist& twist : measured.twists) {
    out["twists"].push_back(twistJson(twist));
  }
  if (arguments.cards) {
    out["cards"] = cardsJson();
  }
  printJson(out);
}

}  // namespace

void addMetrics(CLI::App& program) {
  auto arguments = std::make_shared<MetricsArguments>();
  CLI::App* command = program.add_subcommand(
      "metrics", "Measured quantities of a recorded run and of each twist in it, or of its untwisting");
  command
      ->add_option("RUN", arguments->trial,
                   "Id of the run, or its first characters, or the file of a recording")
      ->required();
  addDatabaseOption(*command, arguments->database);
  command
      ->add_option("--tolerance", arguments->tolerance_deg,
                   "Tolerance about the target angle, degrees; default: the exercise's")
      ->check(CLI::Range(0.001, 360.0));
  command->add_option("--force-limit", arguments->forceLimit_N, "Limit above which violations are counted, N")
      ->check(CLI::PositiveNumber);
  command
      ->add_option("--torque-limit", arguments->torqueLimit_Nm,
                   "Limit above which violations are counted, N m")
      ->check(CLI::PositiveNumber);
  command
      ->add_option("--shear-limit", arguments->shearLimit_Pa,
                   "Limit above which time is counted, Pa; loads the scene")
      ->check(CLI::PositiveNumber);
  command->add_flag("--scene", arguments->scene, "Load the scene: adds the wander about the organ's axis");
  command->add_option("--organ", arguments->organ.organ, "The mesh file that the run was recorded on");
  addUnitOption(*command, arguments->organ.unit);
  command->add_flag("--cards", arguments->cards, "Add what each quantity means");
  command->callback([arguments] { runMetrics(*arguments); });
}

}  // namespace torsio::cli
