// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <chrono>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "app/cli/commands.h"
#include "app/cli/json_output.h"
#include "app/services/base/assets.h"
#include "assessment/results/number_format.h"
#include "assessment/statistics/descriptive.h"
#include "sim/baseline/grasped_organ.h"
#include "sim/scene/scene.h"
#include "sim/tissue/rod/rod_bench.h"
#include "sim/tissue/twist/twist_bench.h"

namespace torsio::cli {

namespace {

constexpr double kRodTickTarget_us = 60.0;  // docs/model.md R.6

constexpr int kGraspFrames = 40;
constexpr double kGraspTurn_rad = 1.0;

/// Times one frame of every model of a grasped organ: the arm, turned at the grasp of its pattern.
void addGraspedModels(std::vector<TissueBenchRow>& rows) {
  using Clock = std::chrono::steady_clock;
  SceneRequest request;
  request.assets = assetsFolder();
  const Scene scene = loadScene(request);
  for (const TissueModel model : kTissueModels) {
    const auto organ = graspedOrgan(model, {&scene.mesh, &scene.lattice(), &scene.model, scene.grasp_m()});
    std::vector<double> times_us;
    for (int frame = 1; frame <= kGraspFrames; ++frame) {
      const auto begun = Clock::now();
      organ->turnTo(kGraspTurn_rad * frame / kGraspFrames);
      times_us.push_back(std::chrono::duration<double, std::micro>(Clock::now() - begun).count());
    }
    const std::string id(tissueModelId(model));
    rows.push_back({.name = id + "_frame_median", .value = medianOf(times_us), .unit = "us"});
    rows.push_back({.name = id + "_torque", .value = organ->torque_Nm(), .unit = "N m"});
  }
}

void runBench(bool json) {
  TissueBenchResult result = runTissueBench();
  const RodBenchResult rod = runRodBench();
  result.rows.push_back({.name = "rod_tick_median", .value = rod.median_us, .unit = "us"});
  result.rows.push_back({.name = "rod_tick_999",
                         .value = rod.p999_us,
                         .unit = "us",
                         .target = kRodTickTarget_us,
                         .atLeast = false});
  result.rows.push_back({.name = "rod_landmark_turn", .value = rod.turn_rad, .unit = "rad"});
  addGraspedModels(result.rows);
  if (!json) {
    std::cout << "instruction set " << result.isa << ", load average " << formatFixed(result.loadAverage, 2)
              << "\n";
    for (const TissueBenchRow& row : result.rows) {
      std::cout << row.name << " = " << formatFixed(row.value, 3) << " " << (row.unit == "1" ? "" : row.unit);
      if (row.target != 0.0) {
        std::cout << "  (wanted " << (row.atLeast ? "at least " : "at most ") << formatFixed(row.target, 2)
                  << (row.met() ? ", met)" : ", NOT met)");
      }
      std::cout << "\n";
    }
    return;
  }
  nlohmann::ordered_json out;
  out["isa"] = result.isa;
  out["core"] = result.core;
  out["load_average"] = result.loadAverage;
  out["rows"] = nlohmann::ordered_json::array();
  for (const TissueBenchRow& row : result.rows) {
    nlohmann::ordered_json entry{{"name", row.name}, {"value", row.value}, {"unit", row.unit}};
    if (row.target != 0.0) {
      entry["target"] = row.target;
      entry["wanted"] = row.atLeast ? "at least" : "at most";
      entry["met"] = row.met();
    }
    out["rows"].push_back(entry);
  }
  std::cout << jsonText(out) << '\n';
}

}  // namespace

void addBench(CLI::App& program) {
  auto json = std::make_shared<bool>(false);
  CLI::App* command = program.add_subcommand(
      "bench", "Speed of the twist model, as ratios to what the memory of this machine can do");
  command->add_flag("--json", *json, "Print JSON");
  command->callback([json] { runBench(*json); });
}

}  // namespace torsio::cli
