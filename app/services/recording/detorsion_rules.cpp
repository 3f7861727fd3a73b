// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/recording/detorsion_rules.h"

#include <exception>

#include <nlohmann/json.hpp>

namespace torsio {

std::optional<DetorsionRules> detorsionRulesOf(const std::string& parametersJson) {
  try {
    const auto json = nlohmann::json::parse(parametersJson);
    if (!json.contains("detorsion")) {
      return std::nullopt;
    }
    const nlohmann::json& detorsion = json.at("detorsion");
    const nlohmann::json& limits = detorsion.at("limits");
    DetorsionRules rules;
    rules.residual_rad = limits.at("residual_rad").get<double>();
    rules.patency = limits.at("patency").get<double>();
    rules.flow = limits.at("flow").get<double>();
    rules.handsOff_s = limits.at("hands_off_s").get<double>();
    rules.enoughFlow = detorsion.at("pedicle").at("enough_flow").get<double>();
    rules.relapseFrom_rad = detorsion.at("base").at("relapse_from_rad").get<double>();
    rules.jaw_Pa = limits.at("jaw_force_n").get<double>() / limits.at("jaw_area_m2").get<double>();
    rules.bruise_Pa = limits.at("bruise_pa").get<double>();
    rules.tear_Pa = limits.at("tear_pa").get<double>();
    rules.pull_N = limits.at("pull_n").get<double>();
    rules.timeScale = detorsion.at("time_scale").get<double>();
    if (detorsion.contains("stages")) {
      const nlohmann::json& stages = detorsion.at("stages");
      rules.stages = {stages.at("turn_rad").get<double>(), stages.at("rest_s").get<double>()};
    }
    rules.vent = detorsion.contains("wall") && detorsion.at("wall").at("vent").get<bool>();
    return rules;
  } catch (const std::exception&) {
    return std::nullopt;  // parameters of a later version: their metrics stay undefined
  }
}

AttemptRules recordedRules(AttemptRules exercise, const TrialHeader& header) {
  exercise.detorsion = detorsionRulesOf(header.parametersJson);
  return exercise;
}

}  // namespace torsio
