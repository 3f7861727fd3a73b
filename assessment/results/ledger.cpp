// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/results/ledger.h"

#include <utility>

#include "sim/core/contracts.h"
#include "sim/core/csv_cell.h"

namespace torsio {

namespace {

constexpr std::array<std::string_view, 12> kSectionNames = {
    "evaluation", "training",   "scoring_sheet", "criterion", "agreement",    "comparison",
    "trial",      "competence", "deviation",     "record",    "participants", "practice"};

std::string groupCell(const ResultKey& key) {
  if (key.group.empty()) {
    return key.raterClass;
  }
  return key.against.empty() ? key.group : key.group + " - " + key.against;
}

}  // namespace

std::string_view sectionName(ResultSection section) noexcept {
  return kSectionNames[static_cast<std::size_t>(section)];
}

std::size_t ResultKeyHash::operator()(const ResultKey& key) const noexcept {
  std::size_t hash = static_cast<std::size_t>(key.section);
  const auto mix = [&hash](std::size_t part) {
    hash ^= part + 0x9e3779b97f4a7c15ULL + (hash << 6U) + (hash >> 2U);
  };
  for (const std::string* part : {&key.statistic, &key.of, &key.group, &key.against, &key.raterClass,
                                  &key.model, &key.index, &key.occasion, &key.when, &key.record}) {
    mix(std::hash<std::string>{}(*part));
  }
  mix(static_cast<std::size_t>(key.number));
  return hash;
}

bool matches(const ResultPattern& pattern, const ResultKey& key) noexcept {
  static const ResultKey kAny;
  const auto agrees = [&](auto ResultKey::*field) {
    return pattern.*field == kAny.*field || pattern.*field == key.*field;
  };
  return pattern.section == key.section && pattern.statistic == key.statistic &&
         (pattern.of == kEach ? !key.of.empty() : pattern.of == key.of) && agrees(&ResultKey::group) &&
         agrees(&ResultKey::against) && agrees(&ResultKey::raterClass) && agrees(&ResultKey::model) &&
         agrees(&ResultKey::index) && agrees(&ResultKey::number) && agrees(&ResultKey::occasion) &&
         agrees(&ResultKey::when) && agrees(&ResultKey::record);
}

ResultParts partsOf(std::vector<ResultPart> parts) {
  return std::make_shared<const std::vector<ResultPart>>(std::move(parts));
}

std::optional<double> numberIn(const ResultValue& value) noexcept {
  if (const auto* number = std::get_if<double>(&value)) {
    return *number;
  }
  if (const auto* count = std::get_if<std::int64_t>(&value)) {
    return static_cast<double>(*count);
  }
  if (const auto* yes = std::get_if<bool>(&value)) {
    return *yes ? 1.0 : 0.0;
  }
  return std::nullopt;
}

std::array<std::string, 7> keyCells(const ResultKey& key) {
  return {std::string(sectionName(key.section)),
          key.of.empty() ? "all" : key.of,
          groupCell(key),
          key.model,
          key.number > 0 ? std::to_string(key.number) : key.index,
          key.occasion.empty() ? key.when : key.occasion,
          key.statistic};
}

std::string keyAddress(const ResultKey& key) {
  std::string address;
  for (const std::string& cell : keyCells(key)) {
    address += (address.empty() ? "" : ",") + csvCell(cell);
  }
  return address;
}

std::string Ledger::occasion(std::size_t index) const {
  return index < names_.occasions.size() ? names_.occasions[index] : std::string();
}

void Ledger::add(Result result) {
  TORSIO_EXPECTS(result.madeOf && !result.madeOf->empty());
  const bool added = byKey_.try_emplace(result.key, results_.size()).second;
  TORSIO_EXPECTS(added);
  byPerson_[result.key.of].push_back(results_.size());
  results_.push_back(std::move(result));
}

const Result* Ledger::find(const ResultKey& key) const {
  const auto found = byKey_.find(key);
  return found == byKey_.end() ? nullptr : &results_[found->second];
}

std::vector<const Result*> Ledger::select(const ResultPattern& pattern) const {
  std::vector<const Result*> found;
  if (pattern.of == kEach) {
    for (const Result& result : results_) {
      if (matches(pattern, result.key)) {
        found.push_back(&result);
      }
    }
  } else if (const auto own = byPerson_.find(pattern.of); own != byPerson_.end()) {
    for (const std::size_t at : own->second) {
      if (matches(pattern, results_[at].key)) {
        found.push_back(&results_[at]);
      }
    }
  }
  return found;
}

void Ledger::eachLine(const std::function<void(const Result&)>& visit) const {
  for (const Result& result : results_) {
    const auto* interval = std::get_if<Interval>(&result.value);
    if (interval == nullptr) {
      visit(result);
      continue;
    }
    const std::string& name = result.key.statistic;
    const std::size_t level = name.ends_with("_95") || name.ends_with("_90") ? name.size() - 3 : name.size();
    Result line = result;
    for (const bool upper : {false, true}) {
      line.key.statistic = name;
      line.key.statistic.insert(level, upper ? "_upper" : "_lower");
      line.value = upper ? interval->upper : interval->lower;
      visit(line);
    }
  }
}

Ledger Ledger::filtered(const std::function<bool(const Result&)>& shown) const {
  Ledger kept(names_);
  for (const Result& result : results_) {
    if (shown(result)) {
      kept.add(result);
    } else {
      kept.hidden_.insert(result.key);
    }
  }
  return kept;
}

}  // namespace torsio
