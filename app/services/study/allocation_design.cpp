// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/study/allocation_design.h"

#include <algorithm>
#include <array>
#include <utility>

#include <nlohmann/json.hpp>

#include "sim/core/error.h"

namespace torsio {

namespace {

using nlohmann::json;

constexpr std::array<std::pair<AllocationMethod, const char*>, 4> kMethods{
    {{AllocationMethod::kCompletePermutation, "complete permutation"},
     {AllocationMethod::kPermutedBlocks, "permuted blocks"},
     {AllocationMethod::kStratifiedBlocks, "stratified blocks"},
     {AllocationMethod::kMinimisation, "minimisation"}}};

std::size_t levelOf(const AllocationFactor& factor, const std::string& level, const std::string& code) {
  const auto found = std::find(factor.levels.begin(), factor.levels.end(), level);
  if (found == factor.levels.end()) {
    refuse(level.empty()
               ? Text::tr("the %1 is not recorded", Text(factor.name))
               : Text::tr("the %1 \"%2\" was not known when the design was locked", factor.name, level),
           code, Text::tr("Correct the person's record, or lock a new design with a reason"));
  }
  return static_cast<std::size_t>(found - factor.levels.begin());
}

}  // namespace

std::string factorValue(const Trainee& trainee, const std::string& factor) {
  if (factor == "sex") {
    return trainee.person.sex;
  }
  if (factor == "level") {
    return trainee.person.level;
  }
  if (factor == "experience") {
    return trainee.person.experience;
  }
  if (factor == "handedness") {
    return trainee.handedness;
  }
  throw Error(ErrorCode::kBadParameter, Text::tr("people cannot be balanced by \"%1\"", factor),
              Text::tr("allocation"), Text::tr("Choose sex, level, experience or handedness"));
}

std::string allocationMethodName(AllocationMethod method) {
  for (const auto& [known, name] : kMethods) {
    if (known == method) {
      return name;
    }
  }
  return "";
}

std::string designJson(const AllocationDesign& design) {
  json factors = json::array();
  for (const AllocationFactor& factor : design.factors) {
    factors.push_back({{"name", factor.name}, {"levels", factor.levels}});
  }
  return json{{"format", "torsio allocation design 2"},
              {"study", design.studyId},
              {"method", allocationMethodName(design.method)},
              {"arms", design.arms},
              {"participants", design.participants},
              {"block_sizes", design.blockSizes},
              {"factors", factors},
              {"best_arm_tenths", design.bestArm_tenths},
              {"imbalance", design.imbalance == Imbalance::kRange ? "range" : "variance"},
              {"stratum_totals", design.stratumTotals}}
      .dump();
}

AllocationDesign designFromStored(const LockedDesign& stored, const std::vector<std::string>& groups,
                                  std::size_t drawn) {
  AllocationDesign design;
  design.studyId = stored.cohortId;
  try {
    const json source = json::parse(stored.parametersJson);
    if (!source.contains("format")) {
      design.arms = groups;
      design.participants = drawn;
      return design;
    }
    const std::string method = source.at("method").get<std::string>();
    const auto known = std::find_if(kMethods.begin(), kMethods.end(),
                                    [&](const auto& entry) { return method == entry.second; });
    if (known == kMethods.end()) {
      refuse(Text::tr("the method \"%1\" is not known", method), stored.id, "");
    }
    design.method = known->first;
    design.studyId = source.at("study").get<std::string>();
    design.arms = source.at("arms").get<std::vector<std::string>>();
    design.participants = source.at("participants").get<std::size_t>();
    design.blockSizes = source.at("block_sizes").get<std::vector<std::size_t>>();
    for (const json& factor : source.at("factors")) {
      design.factors.push_back(
          {factor.at("name").get<std::string>(), factor.at("levels").get<std::vector<std::string>>()});
    }
    design.bestArm_tenths = source.at("best_arm_tenths").get<std::int64_t>();
    design.imbalance = source.at("imbalance") == "variance" ? Imbalance::kVariance : Imbalance::kRange;
    design.stratumTotals = source.at("stratum_totals").get<std::map<std::string, std::size_t>>();
  } catch (const json::exception& problem) {
    refuse(Text::tr("the stored design cannot be read: %1", problem.what()), stored.id,
           Text::tr("Verify the database"));
  }
  return design;
}

std::string covariatesJson(const AllocationDesign& design, const AllocationPerson& person) {
  json levels = json::object();
  for (std::size_t f = 0; f < design.factors.size(); ++f) {
    levels[design.factors[f].name] = design.factors[f].levels.at(person.levels.at(f));
  }
  return levels.dump();
}

AllocationPerson personFromRecord(const AllocationDesign& design, const std::string& code,
                                  const std::string& covariates) {
  AllocationPerson person{code, {}};
  try {
    const json levels = json::parse(covariates);
    for (const AllocationFactor& factor : design.factors) {
      person.levels.push_back(levelOf(factor, levels.at(factor.name).get<std::string>(), code));
    }
  } catch (const json::exception& problem) {
    refuse(Text::tr("the recorded strata cannot be read: %1", problem.what()), code,
           Text::tr("Verify the database"));
  }
  return person;
}

AllocationPerson personForDraw(const AllocationDesign& design, const Trainee& trainee) {
  AllocationPerson person{trainee.person.code, {}};
  for (const AllocationFactor& factor : design.factors) {
    person.levels.push_back(levelOf(factor, factorValue(trainee, factor.name), trainee.person.code));
  }
  return person;
}

std::string numbersJson(const std::vector<std::string>& names, const std::vector<std::int64_t>& numbers) {
  json out = json::object();
  for (std::size_t i = 0; i < names.size() && i < numbers.size(); ++i) {
    out[names[i]] = numbers[i];
  }
  return out.dump();
}

}  // namespace torsio
