// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/recording/kept_digests.h"

#include <algorithm>
#include <exception>
#include <iterator>
#include <optional>

#include <nlohmann/json.hpp>

#include "app/services/base/assets.h"
#include "assessment/catalogue/quantity.h"
#include "assessment/domain/ids.h"
#include "db/connection/connection.h"
#include "db/repository/study/curriculum_repository.h"
#include "db/repository/trial/digest_repository.h"
#include "db/repository/trial/trial_repository.h"
#include "sim/core/error.h"
#include "sim/core/foreign_recording.h"
#include "sim/core/time_units.h"
#include "sim/record/sample_codec.h"
#include "sim/scene/scene_file.h"

namespace torsio {

MasteryRule masteryRule(const MasteryCriterion& stored) {
  return {.quantity = quantityOf(stored.metric),
          .atMost = stored.comparison == "at_most",
          .threshold = stored.threshold,
          .consecutive = stored.consecutive};
}

AttemptRules rulesOf(const TrainingModule& module) {
  AttemptRules rules{.tolerance_rad = module.tolerance_rad,
                     .forceLimit_N = module.maxForce_N,
                     .torqueLimit_Nm = module.maxTorque_Nm,
                     .hold_s = static_cast<double>(module.hold_us) * 1e-6,
                     .leastTwists = module.leastTwists};
  std::transform(module.mastery.begin(), module.mastery.end(), std::back_inserter(rules.mastery),
                 masteryRule);
  return rules;
}

AttemptRules ExerciseRules::of(Connection& connection, const SceneId& sceneId, const PatternId& patternId,
                               const ModuleId& moduleId) {
  if (!moduleId.empty()) {
    if (const auto known = modules_.find(moduleId); known != modules_.end()) {
      return known->second;
    }
    if (const auto module = CurriculumRepository(connection).module(moduleId)) {
      return modules_.emplace(moduleId, rulesOf(*module)).first->second;
    }
  }
  return ofPattern(sceneId, patternId);
}

AttemptRules ExerciseRules::ofPattern(const SceneId& sceneId, const PatternId& patternId) {
  AttemptRules rules;
  rules.tolerance_rad = patternTolerance_rad(sceneId, patternId);
  return rules;
}

double ExerciseRules::patternTolerance_rad(const SceneId& sceneId, const PatternId& patternId) {
  const auto [known, isNew] = patterns_.try_emplace({sceneId, patternId}, kDefaultTolerance_rad);
  if (!isNew) {
    return known->second;
  }
  try {
    const std::filesystem::path folder = assets_.empty() ? assetsFolder() : assets_;
    for (const PatternDescription& description : readSceneFile(folder, sceneId).patterns) {
      if (description.pattern.id == patternId) {
        known->second = description.pattern.tolerance_rad;
      }
    }
  } catch (const Error&) {
    // A scene of another installation: use the default tolerance of two degrees.
  }
  return known->second;
}

std::string modelName(const std::string& parametersJson) {
  try {
    const std::optional<Formulation> formulation = sceneRequestFor(parametersJson).formulation;
    return formulation == Formulation::kPaper ? "paper" : "Saint-Venant";
  } catch (const Error&) {
    return "not known";  // parameters of a later version: the recording still counts
  }
}

AttemptMeasures measureRecording(const Trial& trial, const AttemptRules& rules) {
  return measureAttempt(trial.header, decodeTrial(trial), recordedRules(rules, trial.header));
}

TrialDigest keptDigest(const Trial& trial, const AttemptMeasures& measures, const AttemptRules& rules,
                       std::int64_t now_us) {
  TrialDigest kept;
  kept.trialId = trial.header.trialId;
  kept.formulaVersion = kMetricsVersion;
  kept.tolerance_rad = rules.tolerance_rad;
  kept.forceLimit_N = rules.forceLimit_N;
  kept.torqueLimit_Nm = rules.torqueLimit_Nm;
  kept.contentHash = trial.summary.contentHash;
  kept.model =
      isForeign(trial.header.sceneId) ? std::string(kForeignModel) : modelName(trial.header.parametersJson);
  kept.measures = measures;
  kept.computedUtc_us = now_us;
  return kept;
}

const TrialDigest* findDigest(std::span<const TrialDigest> kept, const std::string& contentHash,
                              const AttemptRules& rules) {
  const auto found = std::find_if(kept.begin(), kept.end(), [&](const TrialDigest& digest) {
    return digest.contentHash == contentHash && digest.tolerance_rad == rules.tolerance_rad &&
           digest.forceLimit_N == rules.forceLimit_N && digest.torqueLimit_Nm == rules.torqueLimit_Nm;
  });
  return found == kept.end() ? nullptr : &*found;
}

RunVerdict verdictOn(const TrialSummary& summary, const AttemptMeasures& measures,
                     const AttemptRules& rules) {
  return judgeRun(measures, rules, summary.outcome == TrialOutcome::kInterrupted);
}

TrialSummaryRow summaryRow(const TrialListing& listing, const TrialDigest& digest,
                           const AttemptRules& rules) {
  const TrialSummary& summary = listing.summary.value();
  const AttemptMeasures& measures = digest.measures;
  TrialSummaryRow row;
  row.trialId = listing.trialId;
  row.trainee = listing.traineeCode;
  row.phase = listing.phaseLabel;
  row.model = digest.model;
  row.minutes = static_cast<double>(measures.duration_us) / kMinute_us;
  row.samples = summary.samples;
  row.refusedSamples = summary.refusedSamples;
  row.lateTicks = summary.lateTicks;
  row.forceCuts = summary.health ? summary.health->forceCuts : 0;
  row.interrupted = summary.outcome == TrialOutcome::kInterrupted;
  row.outcome = verdictOn(summary, measures, rules).outcome;
  row.contentHash = summary.contentHash;
  row.device = listing.deviceModel;
  row.station = listing.station;
  row.twists = std::ssize(measures.twists);
  row.twistsOnTarget = measures.twistsOnTarget();
  row.unfinishedTwists = measures.unfinished;
  row.meanAbsoluteError_deg = measures.meanAbsoluteError_deg;
  if (!measures.twists.empty()) {
    row.peakTorque_Nm = valueIn(measures.values, Quantity::kPeakTorque);
    row.peakForce_N = valueIn(measures.values, Quantity::kPeakForce);
    row.peakDeviceForce_N = valueIn(measures.values, Quantity::kDeviceForce);
  }
  row.attempts = measures.twists;
  for (const auto& [quantity, value] : measures.values) {
    if (isOfUntwisting(quantity) || digest.model == kForeignModel) {  // there are no twists
      row.detorsion.emplace(idOf(quantity), value);
    }
  }
  return row;
}

TrialDigest digestOf(Connection& connection, const TrialListing& listing, ExerciseRules& exercises,
                     std::int64_t now_us) {
  const AttemptRules rules = exercises.of(connection, listing.sceneId, listing.patternId, listing.moduleId);
  const std::vector<TrialDigest> kept =
      DigestRepository(connection).ofTrial(listing.trialId, kMetricsVersion);
  if (const TrialDigest* known = findDigest(kept, listing.summary.value().contentHash, rules)) {
    return *known;
  }
  const Trial trial = TrialRepository(connection).load(listing.trialId);
  const AttemptMeasures measures = measureRecording(trial, rules);
  keepDigest(connection, trial, measures, rules, now_us);
  return keptDigest(trial, measures, rules, now_us);
}

void keepDigest(Connection& connection, const Trial& trial, const AttemptMeasures& measures,
                const AttemptRules& rules, std::int64_t now_us) {
  if (connection.readOnly() || trial.summary.contentHash.empty()) {
    return;
  }
  const TrialDigest kept = keptDigest(trial, measures, rules, now_us);
  DigestRepository(connection).add({&kept, 1});
}

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
