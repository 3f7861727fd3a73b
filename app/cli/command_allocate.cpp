// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <memory>
#include <optional>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>

#include "app/cli/commands.h"
#include "app/cli/json_output.h"
#include "assessment/study/allocation.h"
#include "sim/base/digest.h"
#include "sim/base/error.h"
#include "sim/base/file_io.h"
#include "sim/scene/json_fields.h"

namespace torsio::cli {

namespace {

using Json = nlohmann::ordered_json;
using Input = nlohmann::json;

struct AllocateArguments {
  std::string design;
  std::optional<std::uint64_t> seed;
  std::string salt;
  std::string replay;
  std::string head;
};

constexpr int kSaltDraws = 16;  // of 32 bits each: twice what the salt holds

const std::vector<std::string> kAllocationMethods = {"complete permutation", "permuted blocks",
                                                     "stratified blocks", "minimisation"};
const std::vector<std::string> kImbalances = {"range", "variance"};

Input parsed(const std::string& file) {
  try {
    return Input::parse(readFile(file));
  } catch (const Input::parse_error& error) {
    throw Error(ErrorCode::kBadData, "this is not JSON: " + std::string(error.what()), file,
                Text::verbatim("Correct the file"));
  }
}

/// A value of the wrong kind is the file's fault, not ours.
template <class T>
T as(JsonFields& fields, const std::string& name) {
  try {
    return fields.child(name).get<T>();
  } catch (const Input::exception&) {
    fields.refuse(name, Text::verbatim("has the wrong kind of value"),
                  Text::verbatim("See docs/cli.md, allocate"));
  }
}

/// Whole numbers of at least 0; nlohmann would turn -1 into a very large one.
std::uint64_t count(JsonFields& fields, const std::string& name) {
  const Input& value = fields.child(name);
  if (!value.is_number_unsigned()) {
    fields.refuse(name, Text::verbatim("is no whole number of at least 0"), Text::verbatim("Correct it"));
  }
  return value.get<std::uint64_t>();
}

std::vector<std::uint64_t> counts(JsonFields& fields, const std::string& name) {
  const Input& list = fields.child(name);
  const bool sound = list.is_array() && std::all_of(list.begin(), list.end(), [](const Input& value) {
                       return value.is_number_unsigned();
                     });
  if (!sound) {
    fields.refuse(name, Text::verbatim("is no list of whole numbers of at least 0"),
                  Text::verbatim("Correct it"));
  }
  return list.get<std::vector<std::uint64_t>>();
}

const Input& listAt(JsonFields& fields, const std::string& name) {
  const Input& list = fields.child(name);
  if (!list.is_array()) {
    fields.refuse(name, Text::verbatim("is no list"), Text::verbatim("Write it in square brackets"));
  }
  return list;
}

std::vector<AllocationFactor> factorsOf(const Input& list, const std::string& where) {
  std::vector<AllocationFactor> factors;
  for (std::size_t i = 0; i < list.size(); ++i) {
    JsonFields fields(list.at(i), where + ", factors[" + std::to_string(i) + "]");
    factors.push_back({fields.text("name"), as<std::vector<std::string>>(fields, "levels")});
    fields.finish();
  }
  return factors;
}

/// The fields of a design; the caller finishes, because a design file also lists persons.
AllocationDesign designOf(JsonFields& fields) {
  AllocationDesign design;
  design.studyId = fields.text("study");
  design.method = static_cast<AllocationMethod>(fields.choice("method", kAllocationMethods, 0));
  design.arms = as<std::vector<std::string>>(fields, "arms");
  if (fields.has("participants")) {
    design.participants = count(fields, "participants");
  }
  if (fields.has("block_sizes")) {
    for (const std::uint64_t size : counts(fields, "block_sizes")) {
      design.blockSizes.push_back(size);
    }
  }
  if (fields.has("factors")) {
    design.factors = factorsOf(listAt(fields, "factors"), fields.where());
  }
  if (fields.has("best_arm_probability")) {
    const double tenths = 10.0 * fields.number("best_arm_probability", 0.5, 0.9);
    design.bestArm_tenths = std::llround(tenths);
    constexpr double kRounding = 1e-9;
    if (std::abs(tenths - static_cast<double>(design.bestArm_tenths)) > kRounding) {
      fields.refuse("best_arm_probability", Text::verbatim("is no multiple of 0.1"),
                    Text::verbatim("Give 0.5, 0.6, 0.7, 0.8 or 0.9"));
    }
  }
  design.imbalance = static_cast<Imbalance>(fields.choice("imbalance", kImbalances, 0));
  if (fields.has("stratum_totals")) {
    JsonFields totals(fields.child("stratum_totals"), fields.where() + ", stratum_totals");
    for (const auto& [name, value] : fields.child("stratum_totals").items()) {
      design.stratumTotals[name] = count(totals, name);
    }
  }
  return design;
}

Json designJson(const AllocationDesign& design) {
  Json out;
  out["study"] = design.studyId;
  out["method"] = kAllocationMethods.at(static_cast<std::size_t>(design.method));
  out["arms"] = design.arms;
  out["participants"] = design.participants;
  out["block_sizes"] = design.blockSizes;
  out["factors"] = Json::array();
  for (const AllocationFactor& factor : design.factors) {
    out["factors"].push_back({{"name", factor.name}, {"levels", factor.levels}});
  }
  out["best_arm_probability"] = static_cast<double>(design.bestArm_tenths) / 10.0;
  out["imbalance"] = kImbalances.at(static_cast<std::size_t>(design.imbalance));
  out["stratum_totals"] = Json::object();
  for (const auto& [name, total] : design.stratumTotals) {
    out["stratum_totals"][name] = total;
  }
  return out;
}

/// Persons as codes, or as {"code", "levels": {factor: level}}.
std::vector<AllocationPerson> personsOf(const Input& list, const AllocationDesign& design,
                                        const std::string& where) {
  std::vector<AllocationPerson> persons;
  for (std::size_t i = 0; i < list.size(); ++i) {
    const Input& entry = list.at(i);
    const std::string here = where + ", persons[" + std::to_string(i) + "]";
    const Input object = entry.is_string() ? Input{{"code", entry}} : entry;
    JsonFields fields(object, here);
    AllocationPerson person{fields.text("code"), {}};
    static const Input kNone = Input::object();
    JsonFields levels(fields.has("levels") ? fields.child("levels") : kNone, here + ", levels");
    for (const AllocationFactor& factor : design.factors) {
      const std::string level = levels.text(factor.name);
      const auto found = std::find(factor.levels.begin(), factor.levels.end(), level);
      if (found == factor.levels.end()) {
        levels.refuse(factor.name, "\"" + level + "\" is none of its levels",
                      Text::verbatim("Give a level of the design"));
      }
      person.levels.push_back(static_cast<std::size_t>(found - factor.levels.begin()));
    }
    levels.finish();
    fields.finish();
    persons.push_back(std::move(person));
  }
  return persons;
}

Json recordJson(const AllocationRecord& record, const AllocationDesign& design) {
  Json out{{"position", record.position}, {"person", record.person}};
  out["levels"] = record.levels;
  out["stratum"] = record.stratum;
  out["draws_before"] = record.drawsBefore;
  out["draws_after"] = record.drawsAfter;
  out["counts_before"] = record.countsBefore;
  out["scores"] = record.scores;
  out["arm"] = design.arms.at(record.arm);
  out["utc_us"] = record.stamp.utc_us;
  out["enrolled_by"] = record.stamp.enrolledBy;
  out["allocated_by"] = record.stamp.allocatedBy;
  out["software"] = record.stamp.softwareVersion;
  out["previous_hash"] = record.previousHash;
  out["hash"] = record.hash;
  return out;
}

AllocationRecord recordOf(const Input& json, const AllocationDesign& design, const std::string& where) {
  JsonFields fields(json, where);
  AllocationRecord record;
  record.position = count(fields, "position");
  record.person = fields.text("person");
  for (const std::uint64_t level : counts(fields, "levels")) {
    record.levels.push_back(level);
  }
  for (std::size_t f = 0; f < record.levels.size(); ++f) {
    if (f >= design.factors.size() || record.levels[f] >= design.factors[f].levels.size()) {
      fields.refuse("levels", Text::verbatim("do not fit the factors of the design"),
                    Text::verbatim("Check the file against the original"));
    }
  }
  record.stratum = as<std::string>(fields, "stratum");
  record.drawsBefore = count(fields, "draws_before");
  record.drawsAfter = count(fields, "draws_after");
  record.countsBefore = as<std::vector<std::int64_t>>(fields, "counts_before");
  record.scores = as<std::vector<std::int64_t>>(fields, "scores");
  record.arm = fields.choice("arm", design.arms, 0);
  record.stamp.utc_us = as<std::int64_t>(fields, "utc_us");
  record.stamp.enrolledBy = as<std::string>(fields, "enrolled_by");
  record.stamp.allocatedBy = as<std::string>(fields, "allocated_by");
  record.stamp.softwareVersion = as<std::string>(fields, "software");
  record.previousHash = as<std::string>(fields, "previous_hash");
  record.hash = as<std::string>(fields, "hash");
  fields.finish();
  return record;
}

/// Says what is wrong with a seed; empty: it is a whole number of 64 bits, which CLI11 does not make sure of.
std::string seedProblem(const std::string& text) {
  std::uint64_t seed = 0;
  const char* end = text.data() + text.size();
  const auto [stopped, fault] = std::from_chars(text.data(), end, seed);
  return fault == std::errc{} && stopped == end
             ? std::string()
             : "a seed is a whole number from 0 to 18446744073709551615, not " + text;
}

std::string saltProblem(const std::string& text) {
  return isSalt(text) ? std::string() : "a salt is 64 hexadecimal digits in lower case, not " + text;
}

/// 256 bits of the machine's random numbers.
std::string drawnSalt() {
  std::random_device machine;
  Digest digest;
  for (int i = 0; i < kSaltDraws; ++i) {
    digest.update(static_cast<std::int64_t>(machine()));
  }
  return digest.hex();
}

/// How many persons each arm has, by its name.
Json armCounts(const Allocation& allocation) {
  Json counts = Json::object();
  for (const std::string& arm : allocation.design.arms) {
    counts[arm] = 0;
  }
  for (const AllocationRecord& record : allocation.records) {
    Json& count = counts[allocation.design.arms.at(record.arm)];
    count = count.get<int>() + 1;
  }
  return counts;
}

void runAllocation(const AllocateArguments& arguments) {
  const Input json = parsed(arguments.design);
  JsonFields fields(json, arguments.design);
  const AllocationDesign design = designOf(fields);
  const bool joint = !fields.has("joint_leftovers") || as<bool>(fields, "joint_leftovers");
  const std::vector<AllocationPerson> persons =
      personsOf(listAt(fields, "persons"), design, arguments.design);
  fields.finish();
  const Allocation allocation = allocate(design, arguments.seed.value_or(0), persons, joint,
                                         arguments.salt.empty() ? drawnSalt() : arguments.salt);
  Json out{{"version", kAllocationVersion}, {"generator", kAllocationGenerator}};
  out["design"] = designJson(allocation.design);
  out["seed"] = allocation.seed;
  out["salt"] = allocation.salt;
  out["commitment"] = allocation.commitment;
  out["head"] = allocation.head;
  out["counts"] = armCounts(allocation);
  out["records"] = Json::array();
  for (const AllocationRecord& record : allocation.records) {
    out["records"].push_back(recordJson(record, allocation.design));
  }
  printJson(out);
}

void runReplay(const std::string& file, const std::string& keptHead) {
  const Input json = parsed(file);
  JsonFields fields(json, file);
  const std::string version = fields.text("version");
  if (version != kAllocationVersion) {
    throw Error(ErrorCode::kBadData, "allocations of version \"" + version + "\" cannot be repeated", file,
                "This program repeats " + std::string(kAllocationVersion));
  }
  JsonFields designFields(fields.child("design"), file + ", design");
  Allocation allocation;
  allocation.design = designOf(designFields);
  designFields.finish();
  allocation.seed = count(fields, "seed");
  if (fields.has("salt")) {
    allocation.salt = fields.text("salt");
  }
  if (fields.has("head")) {
    allocation.head = fields.text("head");
  }
  allocation.commitment = fields.text("commitment");
  const Input& records = listAt(fields, "records");
  for (std::size_t i = 0; i < records.size(); ++i) {
    allocation.records.push_back(
        recordOf(records.at(i), allocation.design, file + ", records[" + std::to_string(i) + "]"));
  }
  ReplayFinding finding = replayAllocation(allocation, keptHead);
  if (finding.sound && fields.has("counts") && Input(armCounts(allocation)) != fields.child("counts")) {
    finding = {false, std::nullopt, "the counts are not those of the records"};
  }
  Json out{{"sound", finding.sound}, {"records", allocation.records.size()}};
  out["commitment"] = allocation.commitment;
  out["head"] = allocationHead(allocation);
  if (finding.firstWrongPosition) {
    out["first_wrong_position"] = *finding.firstWrongPosition;
  }
  if (!finding.sound) {
    out["reason"] = finding.reason;
  }
  printJson(out);
  if (!finding.sound) {
    throw Error(ErrorCode::kVerifyFailed, "the allocation cannot be repeated: " + finding.reason, file,
                Text::verbatim("Compare the file with the one that was kept"));
  }
}

void run(const AllocateArguments& arguments) {
  if (!arguments.replay.empty()) {
    if (!arguments.design.empty() || arguments.seed || !arguments.salt.empty()) {
      throw Error(ErrorCode::kUsage, Text::verbatim("--replay stands alone: design and seed are in the file"),
                  arguments.replay, Text::verbatim("Leave out --design, --seed and --salt"));
    }
    runReplay(arguments.replay, arguments.head);
    return;
  }
  if (arguments.design.empty() || !arguments.seed) {
    throw Error(ErrorCode::kUsage, Text::verbatim("an allocation needs --design and --seed, or --replay"),
                Text::verbatim("allocate"),
                Text::verbatim("Give the design and draw a seed at random: it is never chosen for you"));
  }
  runAllocation(arguments);
}

}  // namespace

void addAllocate(CLI::App& program) {
  auto arguments = std::make_shared<AllocateArguments>();
  CLI::App* command = program.add_subcommand("allocate", "Random allocation to groups that can be repeated");
  command->add_option("--design", arguments->design, "Design and persons, JSON: docs/cli.md");
  command->add_option("--seed", arguments->seed, "Decides everything; keep it sealed until the end")
      ->check(CLI::Validator(seedProblem, "UINT64"));
  command->add_option("--salt", arguments->salt, "256 bits in hexadecimal; without it they are drawn")
      ->check(CLI::Validator(saltProblem, "HEX"));
  command->add_option("--head", arguments->head,
                      "With --replay: the head that was kept elsewhere, in quotes");
  command->add_option("--replay", arguments->replay, "Repeat an allocation and compare: exit code 13");
  command->callback([arguments] { run(*arguments); });
}

}  // namespace torsio::cli
