// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/centres/site_intake.h"

#include <algorithm>
#include <set>
#include <utility>

#include "db/connection/row_reader.h"
#include "db/repository/base/changed_statement.h"
#include "sim/core/error.h"
#include "sim/core/plain_text.h"

namespace torsio {

namespace {

std::string textOf(const Value& value) {
  const auto* text = std::get_if<std::string>(&value.storage());
  return text == nullptr ? std::string() : *text;
}

}  // namespace

SiteIntake::SiteIntake(Connection& connection, const SiteManifest& manifest, Site site,
                       SiteDeliveryId delivery)
    : connection_(connection), manifest_(manifest), site_(std::move(site)), delivery_(std::move(delivery)) {
  for (SchemaTable& table : tablesInReferenceOrder(connection)) {
    if (siteTableOf(table.name) != nullptr) {
      tables_.emplace(table.name, std::move(table));
    }
  }
  known_ = SiteRepository(connection).rows();
  for (const auto& [key, row] : known_) {
    if (row.centreId == site_.centreId && key.starts_with("trial_end/")) {
      wholeTrials_.insert(key.substr(key.find('/') + 1));
    }
  }
}

void SiteIntake::take(const SitePackageRow& row) {
  const SiteTable* table = siteTableOf(row.table);
  if (table == nullptr || row.values.size() != row.columns.size()) {
    breaksRules();
  }
  if (table_ != table) {
    beginTable(*table, row.columns);
  }
  if (table->sameBy.empty() &&
      isSimulated(row.columns, row.values).value_or(manifest_.simulated) != manifest_.simulated) {
    refuse(Text::tr("holds simulated and real people"), site_.code,
           Text::tr("Ask the centre to give a cohort of one kind only; nothing was taken from it"));
  }
  for (Value& value : row.values) {
    adopt(value);
  }
  const std::string key = sealer_.keyOf(row.table, row.columns, row.values);
  if (!leadsHere(row, key)) {
    return;
  }
  if (table->sameBy.empty()) {
    takeRow(row, key);
  } else {
    takePlan(row);
  }
}

/// Stores which rows came with this delivery, and seals what is new.
void SiteIntake::finish() {
  Statement insert = connection_.prepare(
      "INSERT INTO site_row (delivery_id, table_name, row_key, site_seal) VALUES (?, ?, ?, ?)");
  for (const auto& [table, key, seal] : brought_) {
    insert.execute({delivery_, table, key, seal});
  }
}

void SiteIntake::breaksRules() const {
  refuse(Text::tr("rows of this package do not fit together"), site_.code,
         Text::tr("Ask the centre to export it again with torsio study export; nothing was taken from it"));
}

/// Replaces the id of a plan row by the one that it has here.
void SiteIntake::adopt(Value& value) const {
  const auto* text = std::get_if<std::string>(&value.storage());
  if (text == nullptr || ids_.empty()) {
    return;
  }
  if (const auto found = ids_.find(*text); found != ids_.end()) {
    value = found->second;
  }
}

void SiteIntake::beginTable(const SiteTable& table, const std::vector<std::string>& columns) {
  const std::string name(table.table);
  if (std::set<std::string>(columns.begin(), columns.end()).size() != columns.size()) {
    breaksRules();
  }
  const SchemaTable& schema = tables_.at(name);
  table_ = &table;
  beginReferences(schema, columns);
  boolean_.assign(columns.size(), 0);
  std::string marks;
  std::string list;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const auto found = std::find_if(schema.columns.begin(), schema.columns.end(),
                                    [&](const TableColumn& one) { return one.name == columns[i]; });
    if (found == schema.columns.end() || columns[i].starts_with("site_")) {
      throw Error(ErrorCode::kNewerSchema,
                  Text::tr("holds a column that this version does not know: %1 of the table %2",
                           plainLine(columns[i], 40), name),
                  site_.code, Text::tr("Update Torsio here first"));
    }
    boolean_[i] = found->boolean ? 1 : 0;
    list += (i == 0 ? "" : ", ") + columns[i];
    marks += i == 0 ? "?" : ", ?";
  }
  if (name == "person") {
    list += ", site_id, site_code";
    marks += ", ?, ?";
  }
  insert_.emplace(connection_.prepare("INSERT INTO " + name + " (" + list + ") VALUES (" + marks + ")"));
  find_.reset();
  place_.clear();
  if (!table.sameBy.empty()) {
    std::string condition;
    for (const std::string& column : columnsOf(table.sameBy)) {
      place_.push_back(positionOf(columns, column));
      condition += (condition.empty() ? "" : " AND ") + column + " = ?";
    }
    const bool hasId = std::find(columns.begin(), columns.end(), "id") != columns.end();
    find_.emplace(connection_.prepare("SELECT " + std::string(hasId ? "id" : "'1'") + " FROM " + name +
                                      " WHERE " + condition));
  } else if (name == "trial_chunk") {
    place_ = {positionOf(columns, "trial_id"), positionOf(columns, "chunk_index")};
    find_.emplace(
        connection_.prepare("SELECT digest FROM trial_chunk WHERE trial_id = ? AND chunk_index = ?"));
  }
}

void SiteIntake::beginReferences(const SchemaTable& schema, const std::vector<std::string>& columns) {
  references_.clear();
  for (const TableReference& reference : schema.references) {
    const SiteTable* parent = siteTableOf(reference.parent);
    const bool seed =
        std::find(kGrowingSeeds.begin(), kGrowingSeeds.end(), reference.parent) != kGrowingSeeds.end();
    if (seed || (parent != nullptr && !parent->sameBy.empty()) || reference.columns.front() == "site_id") {
      continue;  // the plan belongs to all
    }
    Reference to{reference.parent, {}, parent != nullptr};
    const SealRule* rule = sealRuleOf(reference.parent);
    const std::vector<std::string> keys =
        to.delivered && rule != nullptr ? columnsOf(rule->key) : reference.parentColumns;
    for (const std::string& key : keys) {
      const auto place = std::find(reference.parentColumns.begin(), reference.parentColumns.end(), key);
      if (place == reference.parentColumns.end()) {
        breaksRules();
      }
      const std::string& column =
          reference.columns[static_cast<std::size_t>(place - reference.parentColumns.begin())];
      if (std::find(columns.begin(), columns.end(), column) != columns.end()) {
        to.places.push_back(positionOf(columns, column));
      }
    }
    if (to.places.size() == keys.size()) {  // a column that is left out is null
      references_.push_back(std::move(to));
    }
  }
}

/// Throws unless every row that this one refers to is the centre's own. Returns false for a decision of
/// somebody who was never delivered: it says nothing here.
bool SiteIntake::leadsHere(const SitePackageRow& row, const std::string& key) const {
  for (const Reference& reference : references_) {
    std::string parent;
    for (const std::size_t place : reference.places) {
      parent += (parent.empty() ? "" : "/") + textOf(row.values[place]);
    }
    if (parent.empty()) {
      continue;
    }
    const std::string target = reference.parent + "/" + parent;
    if (!reference.delivered) {
      breaksRules();
    }
    if (newParents_.contains(target)) {
      continue;
    }
    const auto known = known_.find(target);
    if (known == known_.end()) {
      if (row.table == "consent") {
        return false;
      }
      breaksRules();
    }
    if (known->second.centreId != site_.centreId) {
      differs(row.table, key, Text::tr("refers to a row of another centre"));
    }
  }
  return true;
}

std::size_t SiteIntake::positionOf(const std::vector<std::string>& columns, std::string_view column) const {
  const auto found = std::find(columns.begin(), columns.end(), column);
  if (found == columns.end()) {
    breaksRules();
  }
  return static_cast<std::size_t>(found - columns.begin());
}

std::optional<std::string> SiteIntake::found(const SitePackageRow& row) {
  std::vector<Value> values;
  for (const std::size_t place : place_) {
    values.push_back(row.values[place]);
  }
  find_->execute(values);
  std::optional<std::string> id;
  if (find_->step()) {
    id = find_->text(0);
  }
  while (id && find_->step()) {
  }
  return id;
}

void SiteIntake::insert(const SitePackageRow& row) {
  std::vector<Value> values = row.values;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const auto* number = std::get_if<std::int64_t>(&values[i].storage());
    if (boolean_[i] == 1 && number != nullptr) {
      values[i] = *number != 0;
    }
  }
  if (row.table == "person") {
    const std::size_t code = positionOf(row.columns, "code");
    const std::string own = textOf(values[code]);
    values[code] = qualifiedCode(site_.code, own);
    values.emplace_back(site_.centreId);
    values.emplace_back(own);
  } else if (row.table == "enrolment") {
    const std::size_t group = positionOf(row.columns, "group_id");
    const std::size_t number = positionOf(row.columns, "number_in_group");
    if (!textOf(values[group]).empty()) {
      values[number] = nextInGroup(textOf(values[group]));
    }
  }
  insert_->execute(values);
}

std::int64_t SiteIntake::nextInGroup(const std::string& group) {
  const auto [last, first] = lastInGroup_.try_emplace(group, 0);
  if (first) {
    last->second = selectFirst(connection_, "SELECT max(number_in_group) FROM enrolment WHERE group_id = ?",
                               {group}, readInt64)
                       .value_or(0);
  }
  return ++last->second;
}

void SiteIntake::takePlan(const SitePackageRow& row) {
  const auto id = std::find(row.columns.begin(), row.columns.end(), "id");
  if (const std::optional<std::string> here = found(row)) {
    if (id != row.columns.end()) {
      ids_[textOf(row.values[static_cast<std::size_t>(id - row.columns.begin())])] = *here;
    }
    return;
  }
  insert(row);
  ++added_;
}

void SiteIntake::takeRow(const SitePackageRow& row, const std::string& key) {
  if (row.table == "trial_chunk") {
    takeChunk(row, key);
    return;
  }
  const SealRule* rule = sealRuleOf(row.table);
  if (rule == nullptr) {
    breaksRules();
  }
  if (rule->sealing == Sealing::kWithParent) {
    if (newParents_.contains(std::string(rule->parent) + "/" + key.substr(0, key.find('/')))) {
      insert(row);
      ++added_;
    }
    return;
  }
  const std::string place = row.table + "/" + key;
  const auto known = known_.find(place);
  if (known == known_.end()) {
    insert(row);
    ++added_;
    newParents_.insert(place);
    brought_.push_back({row.table, key, row.seal});
    return;
  }
  if (known->second.centreId != site_.centreId) {
    differs(row.table, key, Text::tr("belongs to another centre"));
  }
  if (known->second.seal == row.seal) {
    return;
  }
  if (rule->sealing == Sealing::kOnce) {
    differs(row.table, key, Text::tr("is not what the centre delivered before under this id"));
  }
  change(row, *rule, key);
}

void SiteIntake::differs(const std::string& table, const std::string& key, const Phrase& how) const {
  throw Error(
      ErrorCode::kVerifyFailed,
      Text::tr("centre %1: the row %2 of the table %3 %4", site_.code, plainLine(key, 80), table, how),
      manifest_.centreName, Text::tr("Ask the centre; nothing was taken from the package"));
}

/// A chunk has its own digest; verification decodes all of them against the hash of their recording.
void SiteIntake::takeChunk(const SitePackageRow& row, const std::string& key) {
  if (wholeTrials_.contains(textOf(row.values[place_.front()]))) {
    return;
  }
  const std::optional<std::string> here = found(row);
  if (!here) {
    insert(row);
    ++added_;
  } else if (*here != textOf(row.values[positionOf(row.columns, "digest")])) {
    differs(row.table, key, Text::tr("is not what the centre delivered before under this id"));
  }
}

/// A state that went on: a person who left, an enrolment that ended.
void SiteIntake::change(const SitePackageRow& row, const SealRule& rule, const std::string& key) {
  const std::vector<std::string> keys = columnsOf(rule.key);
  std::string set;
  std::vector<Value> values;
  std::vector<Value> keyValues;
  for (std::size_t i = 0; i < row.columns.size(); ++i) {
    const std::string& column = row.columns[i];
    if (std::find(keys.begin(), keys.end(), column) != keys.end()) {
      keyValues.push_back(row.values[i]);
    } else if (column == "state" || column == "group_id" || column == "cancelled" || column == "class_code" ||
               column == "handedness" || column == "sex" || column == "level") {
      set += (set.empty() ? "" : ", ") + column + " = ?";
      values.push_back(row.values[i]);
    }
  }
  std::string where;
  for (const std::string& column : keys) {
    where += (where.empty() ? "" : " AND ") + column + " = ?";
  }
  if (!set.empty()) {
    values.insert(values.end(), keyValues.begin(), keyValues.end());
    connection_.prepare("UPDATE " + row.table + " SET " + set + " WHERE " + where).execute(values);
  }
  Statement after = connection_.prepare("SELECT * FROM " + row.table + " WHERE " + where);
  after.execute(keyValues);
  if (!after.step()) {
    breaksRules();
  }
  const std::vector<Value> stored = valuesOf(after);
  const SealShape shape(rule, columnNamesOf(after));
  changedSeals_.push_back(sealedRow(shape, stored, sealOf(shape.kept(stored), {})));
  ++changed_;
  brought_.push_back({row.table, key, row.seal});
}

}  // namespace torsio
