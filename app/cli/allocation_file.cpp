// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/allocation_file.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <sstream>
#include <system_error>
#include <utility>
#include <vector>

#include "app/services/base/identifiers.h"
#include "app/services/maintenance/signing_key.h"
#include "app/services/maintenance/station_anchor.h"
#include "sim/core/error.h"
#include "sim/scene/json_fields.h"

namespace torsio::cli {

namespace {

using Json = nlohmann::ordered_json;
using Input = nlohmann::json;

template <class Value>
Value choice(JsonFields& fields, const char* name) {
  std::vector<std::string> words;
  for (const Term<Value>& term : termsOf(Value{})) {
    words.emplace_back(term.stored);
  }
  return static_cast<Value>(fields.choice(name, words, 0));
}

Input parsed(const std::string& file) {
  return Input::parse(jsonTextIn(file));
}

/// A value of the wrong type is an error in the file, not a bug.
template <class T>
T as(JsonFields& fields, const std::string& name) {
  try {
    return fields.child(name).get<T>();
  } catch (const Input::exception&) {
    fields.refuse(name, Text::verbatim("has a value of the wrong type"),
                  Text::verbatim("See docs/cli.md, allocate"));
  }
}

/// Reads a nonnegative integer; nlohmann would turn -1 into a very large one.
std::uint64_t count(JsonFields& fields, const std::string& name) {
  const Input& value = fields.child(name);
  if (!value.is_number_unsigned()) {
    fields.refuse(name, Text::verbatim("is not a whole number of at least 0"), Text::verbatim("Correct it"));
  }
  return value.get<std::uint64_t>();
}

std::vector<std::uint64_t> counts(JsonFields& fields, const std::string& name) {
  const Input& list = fields.child(name);
  const bool sound = list.is_array() && std::all_of(list.begin(), list.end(), [](const Input& value) {
                       return value.is_number_unsigned();
                     });
  if (!sound) {
    fields.refuse(name, Text::verbatim("is not a list of whole numbers of at least 0"),
                  Text::verbatim("Correct it"));
  }
  return list.get<std::vector<std::uint64_t>>();
}

const Input& listAt(JsonFields& fields, const std::string& name) {
  const Input& list = fields.child(name);
  if (!list.is_array()) {
    fields.refuse(name, Text::verbatim("is not a list"), Text::verbatim("Write it in square brackets"));
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

/// Reads the fields of a design; the caller finishes, because a design file also lists persons.
AllocationDesign designOf(JsonFields& fields) {
  AllocationDesign design;
  design.studyId = fields.text("study");
  design.method = choice<AllocationMethod>(fields, "method");
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
      fields.refuse("best_arm_probability", Text::verbatim("is not a multiple of 0.1"),
                    Text::verbatim("Give 0.5, 0.6, 0.7, 0.8 or 0.9"));
    }
  }
  design.imbalance = choice<Imbalance>(fields, "imbalance");
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
  out["method"] = storedText(design.method);
  out["arms"] = design.arms;
  out["participants"] = design.participants;
  out["block_sizes"] = design.blockSizes;
  out["factors"] = Json::array();
  for (const AllocationFactor& factor : design.factors) {
    out["factors"].push_back({{"name", factor.name}, {"levels", factor.levels}});
  }
  out["best_arm_probability"] = static_cast<double>(design.bestArm_tenths) / 10.0;
  out["imbalance"] = storedText(design.imbalance);
  out["stratum_totals"] = Json::object();
  for (const auto& [name, total] : design.stratumTotals) {
    out["stratum_totals"][name] = total;
  }
  return out;
}

/// Reads persons given as codes, or as {"code", "levels": {factor: level}}.
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
        levels.refuse(factor.name, "\"" + level + "\" is not one of its levels",
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

/// Number of persons in each arm, by its name.
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

/// Throws if two of the names look alike, naming both places.
void requireDistinct(const std::vector<std::string>& names, const char* kind, const std::string& where) {
  Identifiers identifiers(kind);
  for (std::size_t i = 0; i < names.size(); ++i) {
    identifiers.take(names[i], where + "[" + std::to_string(i) + "]");
  }
}

/// Throws if names that a person typed look alike. An allocation that was kept is read as it is.
void checkNames(const AllocationOrder& order, const std::string& file) {
  requireDistinct(order.design.arms, "arm", file + ", arms");
  std::vector<std::string> factors;
  for (std::size_t i = 0; i < order.design.factors.size(); ++i) {
    const AllocationFactor& factor = order.design.factors[i];
    factors.push_back(factor.name);
    requireDistinct(factor.levels, "level", file + ", factors[" + std::to_string(i) + "], levels");
  }
  requireDistinct(factors, "factor", file + ", factors");
  std::vector<std::string> persons;
  for (const AllocationPerson& person : order.persons) {
    persons.push_back(person.code);
  }
  requireDistinct(persons, "person", file + ", persons");
}

}  // namespace

AllocationOrder readAllocationOrder(const std::string& file) {
  const Input json = parsed(file);
  JsonFields fields(json, file);
  AllocationOrder order;
  order.design = designOf(fields);
  order.jointLeftovers = !fields.has("joint_leftovers") || as<bool>(fields, "joint_leftovers");
  order.persons = personsOf(listAt(fields, "persons"), order.design, file);
  fields.finish();
  checkNames(order, file);
  return order;
}

Json allocationJson(const Allocation& allocation) {
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
  return out;
}

KeptAllocation readAllocation(const std::string& file) {
  const Input json = parsed(file);
  JsonFields fields(json, file);
  const std::string version = fields.text("version");
  if (version != kAllocationVersion) {
    refuse("allocations of version \"" + version + "\" cannot be repeated", file,
           "This program repeats " + std::string(kAllocationVersion));
  }
  JsonFields designFields(fields.child("design"), file + ", design");
  KeptAllocation kept;
  Allocation& allocation = kept.allocation;
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
  if (fields.has("counts")) {
    kept.countsFit = Input(armCounts(allocation)) == fields.child("counts");
  }
  return kept;
}

namespace {

using Json = nlohmann::ordered_json;

/// A parsed head.
struct HeadLine {
  std::string words{};  ///< format, version, records, hash
  std::int64_t utc_us = 0;
  std::string publicKey{};
  std::string signature{};
  bool isSigned = false;  ///< there are more than four words, complete or not

  [[nodiscard]] std::string signedText() const { return words + " " + std::to_string(utc_us); }
};

HeadLine headLineOf(const std::string& line) {
  constexpr int kUnsignedWords = 4;
  std::istringstream in(line);
  HeadLine head;
  std::string word;
  for (int i = 0; i < kUnsignedWords && in >> word; ++i) {
    head.words += (i > 0 ? " " : "") + word;
  }
  head.isSigned = !(in >> std::ws).eof();
  std::string more;
  in >> head.utc_us >> head.publicKey >> head.signature;
  if (in >> more) {
    head.signature.clear();  // something was appended
  }
  return head;
}

/// The expected signing key, and the keys before and after it.
struct Expected {
  std::string root{};  ///< public part; empty: none
  bool named = false;  ///< given by the command, not taken from the station
  std::vector<KeyReplacement> replacements{};
};

Expected expectedOf(const HeadKeys& keys) {
  Expected expected;
  const StationAnchor station = stationAnchor();
  expected.named = !keys.key.empty() || !keys.publicKey.empty();
  const std::filesystem::path file = expected.named ? std::filesystem::path(keys.key) : station.key;
  const auto add = [&expected](const std::filesystem::path& from) {
    for (KeyReplacement& made : replacementsIn(from)) {
      expected.replacements.push_back(std::move(made));
    }
  };
  expected.root = file.empty() ? keys.publicKey : publicOf(readKey(file));
  if (!file.empty()) {
    add(file);
  }
  std::error_code ignored;
  if (!keys.witness.empty()) {
    add(keys.witness);
  } else if (std::filesystem::is_regular_file(station.witness, ignored)) {
    add(station.witness);
  }
  return expected;
}

constexpr const char* kUnsigned =
    "this head is not signed: anybody who has the file has seed and salt, and can write another one that "
    "repeats";
constexpr const char* kUnknownKey =
    "the signature is genuine, but no key was given and this station has none: anybody who rewrites the file "
    "can sign it with their own key; give --public-key as published by its owner";
constexpr const char* kGenuine = "nobody without this key can have rewritten the file";

}  // namespace

std::string signedAllocationHead(const std::string& head, const std::string& key, std::int64_t now_us) {
  if (key.empty()) {
    return head;
  }
  const SecretKey secret = readKey(key);
  HeadLine line;
  line.words = head;
  line.utc_us = now_us;
  return line.signedText() + " " + publicOf(secret) + " " + signedWith(secret, line.signedText());
}

std::string unsignedAllocationHead(const std::string& line) {
  return headLineOf(line).words;
}

SignatureFinding checkSignatures(const std::string& fileHead, const std::string& keptHead,
                                 const HeadKeys& keys) {
  const Expected expected = expectedOf(keys);
  const TrustedKeys trusted(expected.root, expected.replacements, &KeyReplacement::utc_us);
  SignatureFinding finding;
  std::optional<HeadLine> shown;
  for (const std::string& text : {fileHead, keptHead}) {
    const HeadLine head = headLineOf(text);
    if (!head.isSigned || !finding.flaw.empty()) {
      continue;
    }
    shown = head;
    if (trusted.asksForSignatures()) {
      finding.flaw = trusted.flawOf(head.signedText(), head.signature, head.publicKey, head.utc_us);
    } else if (!genuine(head.signedText(), head.signature, head.publicKey)) {
      finding.flaw = "the signature of the head is not genuine";
    }
  }
  finding.isSigned = shown.has_value();
  if (!shown && expected.named) {
    finding.flaw = "the head is not signed, although a signing key was given";
  }
  const bool known = trusted.asksForSignatures();
  const std::string good = known ? kGenuine : kUnknownKey;
  const std::string said = shown ? good : kUnsigned;
  const std::string state = known ? "genuine" : "genuine, key not known";
  const std::string sound = shown ? state : "none";
  finding.json["state"] = finding.flaw.empty() ? sound : "wrong";
  finding.json["key"] = shown ? Json(shown->publicKey) : Json();
  finding.json["signed_utc_us"] = shown ? Json(shown->utc_us) : Json();
  finding.json["compared_with"] = expected.root.empty() ? Json() : Json(expected.root);
  finding.json["means"] = finding.flaw.empty() ? said : finding.flaw;
  return finding;
}

}  // namespace torsio::cli
