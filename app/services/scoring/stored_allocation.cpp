// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/scoring/stored_allocation.h"

#include <algorithm>
#include <charconv>
#include <map>
#include <optional>

#include <nlohmann/json.hpp>

#include "db/repository/study/study_repository.h"
#include "sim/core/error.h"

namespace torsio {

namespace {

using nlohmann::json;

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
  const std::optional<BalanceFactor> known = fromStoredText<BalanceFactor>(factor);
  if (known == BalanceFactor::kSex) {
    return trainee.person.sex;
  }
  if (known == BalanceFactor::kLevel) {
    return trainee.person.level;
  }
  if (known == BalanceFactor::kExperience) {
    return trainee.person.experience;
  }
  if (known == BalanceFactor::kHandedness) {
    return trainee.handedness;
  }
  refuseParameter(Text::tr("people cannot be balanced by \"%1\"", factor), Text::tr("allocation"),
                  Text::tr("Choose sex, level, experience or handedness"));
}

std::string designJson(const AllocationDesign& design) {
  json factors = json::array();
  for (const AllocationFactor& factor : design.factors) {
    factors.push_back({{"name", factor.name}, {"levels", factor.levels}});
  }
  return json{{"format", "torsio allocation design 2"},
              {"study", design.studyId},
              {"method", storedText(design.method)},
              {"arms", design.arms},
              {"participants", design.participants},
              {"block_sizes", design.blockSizes},
              {"factors", factors},
              {"best_arm_tenths", design.bestArm_tenths},
              {"imbalance", storedText(design.imbalance)},
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
    const std::optional<AllocationMethod> known = fromStoredText<AllocationMethod>(method);
    if (!known) {
      refuse(Text::tr("the method \"%1\" is not known", method), stored.id, "");
    }
    design.method = *known;
    design.studyId = source.at("study").get<std::string>();
    design.arms = source.at("arms").get<std::vector<std::string>>();
    design.participants = source.at("participants").get<std::size_t>();
    design.blockSizes = source.at("block_sizes").get<std::vector<std::size_t>>();
    for (const json& factor : source.at("factors")) {
      design.factors.push_back(
          {factor.at("name").get<std::string>(), factor.at("levels").get<std::vector<std::string>>()});
    }
    design.bestArm_tenths = source.at("best_arm_tenths").get<std::int64_t>();
    design.imbalance =
        fromStoredText<Imbalance>(source.at("imbalance").get<std::string>()).value_or(Imbalance::kRange);
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

std::vector<AllocationEntry> drawnOf(const std::vector<AllocationEntry>& records) {
  std::vector<AllocationEntry> drawn;
  for (const AllocationEntry& record : records) {
    if (record.overrideReason.empty()) {
      drawn.push_back(record);
    }
  }
  return drawn;
}

std::uint64_t seedFrom(const std::string& text, const DesignId& designId) {
  std::uint64_t seed = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), seed);
  if (error != std::errc() || end != text.data() + text.size() || text.empty()) {
    refuse(Text::tr("the sealed seed cannot be read"), designId, Text::tr("Verify the database"));
  }
  return seed;
}

std::map<std::string, std::string> codesOf(StudyRepository& study, const CohortId& cohortId) {
  std::map<std::string, std::string> codes;
  for (const Enrolment& enrolment : study.enrolments(cohortId)) {
    codes[enrolment.id] = enrolment.traineeCode;
  }
  return codes;
}

AllocationCheck repeatedDraw(StudyRepository& study, const LockedDesign& stored, const std::string& seedText,
                             const std::string& salt) {
  AllocationCheck check;
  const auto wrong = [&](const Text& finding) {
    check.sound = false;
    check.finding = finding;
    return check;
  };
  std::vector<std::string> groupCodes;
  std::map<std::string, GroupId> groupIds;
  for (const StudyGroup& group : study.groups(stored.cohortId)) {
    groupCodes.push_back(group.code);
    groupIds[group.code] = group.id;
  }
  const std::vector<AllocationEntry> records = study.allocations(stored.id);
  const std::vector<AllocationEntry> drawn = drawnOf(records);
  check.records = records.size();
  check.overrides = records.size() - drawn.size();
  if (const auto broken = study.firstBrokenAllocation(stored.id)) {
    return wrong(Text::tr("record %1 does not fit into the chain", *broken));
  }
  const AllocationDesign design = designFromStored(stored, groupCodes, drawn.size());
  const std::uint64_t seed = seedFrom(seedText, stored.id);
  if (seedCommitment(design, seed, salt) != stored.seedCommitment) {
    return wrong(Text::tr("seed and design do not match the published commitment"));
  }
  if (drawn.empty()) {
    return check;
  }
  const std::map<std::string, std::string> codes = codesOf(study, stored.cohortId);
  Allocator allocator(design, seed);
  for (const AllocationEntry& record : drawn) {
    const AllocationRecord again =
        allocator.assign(personFromRecord(design, codes.at(record.enrolmentId), record.covariatesJson));
    if (groupIds[design.arms.at(again.arm)] != record.groupId ||
        static_cast<std::int64_t>(again.drawsAfter) != record.drawAfter) {
      return wrong(Text::tr("record %1 does not follow from the seed", record.sequence));
    }
  }
  std::map<std::string, std::string> lastGroup;
  for (const AllocationEntry& record : records) {
    lastGroup[record.enrolmentId] = record.groupId;
  }
  for (const Enrolment& enrolment : study.enrolments(stored.cohortId)) {
    const auto last = lastGroup.find(enrolment.id);
    if (last != lastGroup.end() && last->second != enrolment.groupId) {
      return wrong(Text::tr("%1 is in a group that no allocation record explains", enrolment.traineeCode));
    }
  }
  return check;
}

}  // namespace torsio
