// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/repository/base/row_seal.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>
#include <string_view>

#include <sodium.h>

#include "db/connection/row_reader.h"
#include "db/repository/base/audit_repository.h"
#include "db/repository/base/changed_statement.h"
#include "db/repository/base/field_digest.h"
#include "sim/core/contracts.h"
#include "sim/core/error.h"

namespace torsio {

namespace {

constexpr const char* kSealColumns =
    "entry_sequence, position, table_name, row_key, removed, row_hash, personal_hash, simulated, before_hash";
constexpr std::string_view kEntries = R"({"entries":)";

std::string newSalt() {
  TORSIO_EXPECTS(sodium_init() >= 0);
  std::array<std::uint8_t, 16> bytes{};
  randombytes_buf(bytes.data(), bytes.size());
  return toHex(bytes);
}

}  // namespace

void forEachSeal(Connection& connection,
                 const std::function<void(std::int64_t, std::int64_t, const RowSeal&)>& hear) {
  forEachSelected(connection,
                  std::string("SELECT ") + kSealColumns + " FROM row_seal ORDER BY entry_sequence, position",
                  [&](const Statement& statement) {
                    RowReader row(statement);
                    const std::int64_t sequence = row.int64();
                    const std::int64_t position = row.int64();
                    RowSeal seal{.table = row.text(), .key = row.text()};
                    seal.removed = row.boolean();
                    seal.rowHash = row.text();
                    seal.personalHash = row.text();
                    seal.simulated = row.boolean();
                    seal.before = row.text();
                    hear(sequence, position, seal);
                  });
}

RowSeal sealedRow(const SealShape& shape, std::span<const Value> row, const std::string& seal) {
  RowSeal made{.table = std::string(shape.rule().table),
               .key = shape.keyOf(row),
               .rowHash = seal,
               .simulated = shape.simulated(row)};
  if (shape.hasPersonal(row)) {
    made.salt = newSalt();
    made.personalHash = shape.personal(row, made.salt);
  }
  return made;
}

void writeSeals(Connection& connection, const std::vector<RowSeal>& seals, const SealAuthor& author) {
  SealDigest digest;
  std::int64_t position = 0;
  for (const RowSeal& seal : seals) {
    digest.add(++position, seal);
  }
  const std::int64_t sequence = AuditRepository(connection)
                                    .append({.atUtc_us = author.atUtc_us,
                                             .actor = author.actor,
                                             .station = author.station,
                                             .action = AuditAction::kRecordSeal,
                                             .objectKind = AuditObject::kRowSeal,
                                             .newJson = sealedJson(author.entries, seals.size()),
                                             .reason = author.reason,
                                             .objectHash = digest.hex()});
  Statement insert = connection.prepare(insertInto("row_seal", kSealColumns));
  std::optional<Statement> salt;  // few tables hold personal data
  std::optional<Statement> forget;
  position = 0;
  for (const RowSeal& seal : seals) {
    insert.execute({sequence, ++position, seal.table, seal.key, seal.removed, seal.rowHash, seal.personalHash,
                    seal.simulated, seal.before});
    if (!seal.salt.empty()) {
      if (!salt) {
        salt = connection.prepare(insertInto("seal_salt", "table_name, row_key, salt") +
                                  " ON CONFLICT (table_name, row_key) DO UPDATE SET salt = excluded.salt");
      }
      salt->execute({seal.table, seal.key, seal.salt});
    } else if (!sealRuleOf(seal.table)->personal.empty()) {
      if (!forget) {
        forget = connection.prepare("DELETE FROM seal_salt WHERE table_name = ? AND row_key = ?");
      }
      forget->execute({seal.table, seal.key});
    }
  }
}

std::string sealedJson(std::int64_t entries, std::size_t rows) {
  return std::string(kEntries) + std::to_string(entries) + R"(,"rows":)" + std::to_string(rows) + "}";
}

std::int64_t entriesOf(const std::string& sealedJson) {
  std::int64_t entries = 0;
  if (sealedJson.starts_with(kEntries)) {
    std::from_chars(sealedJson.data() + kEntries.size(), sealedJson.data() + sealedJson.size(), entries);
  }
  return entries;
}

namespace {

bool listed(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

bool isNull(const Value& value) {
  return std::holds_alternative<std::monostate>(value.storage());
}

void addText(Digest& digest, std::string_view text) {
  digest.update(static_cast<std::int64_t>(text.size()));
  digest.update(text);
}

void addNamed(Digest& digest, const std::string& name, const Value& value) {
  addText(digest, name);
  // SQLite stores booleans as integers.
  const auto* flag = std::get_if<bool>(&value.storage());
  addValue(digest, flag != nullptr ? Value(std::int64_t{*flag ? 1 : 0}) : value, false);
}

std::string textOf(const Value& value) {
  if (const auto* text = std::get_if<std::string>(&value.storage())) {
    return *text;
  }
  if (const auto* number = std::get_if<std::int64_t>(&value.storage())) {
    return std::to_string(*number);
  }
  if (const auto* flag = std::get_if<bool>(&value.storage())) {
    return *flag ? "1" : "0";
  }
  if (const auto* number = std::get_if<double>(&value.storage())) {
    std::array<char, 32> digits{};
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), *number).ptr;
    return {digits.data(), end};
  }
  return {};
}

}  // namespace

SealShape::SealShape(const SealRule& rule, std::vector<std::string> columns)
    : rule_(&rule), columns_(std::move(columns)) {
  const std::vector<std::string> personal = columnsOf(rule.personal);
  const std::vector<std::string> unsealed = columnsOf(rule.unsealed);
  for (const std::string& column : columns_) {
    parts_.push_back(listed(personal, column)   ? Part::kPersonal
                     : listed(unsealed, column) ? Part::kUnsealed
                                                : Part::kKept);
    if (column == "demonstration") {
      flag_ = static_cast<int>(parts_.size()) - 1;
    }
  }
  for (const std::string& column : columnsOf(rule.key)) {
    const auto found = std::find(columns_.begin(), columns_.end(), column);
    if (found == columns_.end()) {
      throw Error(ErrorCode::kVerifyFailed, Text::tr("has no column %1 any more", column),
                  std::string(rule.table), Text::tr("Restore a backup"));
    }
    key_.push_back(static_cast<std::size_t>(found - columns_.begin()));
  }
}

std::string SealShape::keyOf(std::span<const Value> row) const {
  std::string key;
  for (const std::size_t position : key_) {
    key += (key.empty() ? "" : "/") + textOf(row[position]);
  }
  return key;
}

std::vector<Value> SealShape::keyValuesOf(std::span<const Value> row) const {
  std::vector<Value> key;
  for (const std::size_t position : key_) {
    key.push_back(row[position]);
  }
  return key;
}

std::string SealShape::parentKeyOf(std::span<const Value> row) const {
  return textOf(row[key_.front()]);
}

Digest::Value SealShape::kept(std::span<const Value> row) const {
  Digest digest;
  addText(digest, "torsio row 1");
  addText(digest, rule_->table);
  for (std::size_t i = 0; i < row.size(); ++i) {
    if (parts_[i] == Part::kKept && !isNull(row[i])) {
      addNamed(digest, columns_[i], row[i]);
    }
  }
  return digest.value();
}

std::string SealShape::personal(std::span<const Value> row, std::string_view salt) const {
  if (!hasPersonal(row)) {
    return {};
  }
  Digest digest;
  addText(digest, "torsio person 1");
  addText(digest, salt);
  for (std::size_t i = 0; i < row.size(); ++i) {
    if (parts_[i] == Part::kPersonal && !isNull(row[i])) {
      addNamed(digest, columns_[i], row[i]);
    }
  }
  return digest.hex();
}

bool SealShape::hasPersonal(std::span<const Value> row) const {
  for (std::size_t i = 0; i < row.size(); ++i) {
    if (parts_[i] == Part::kPersonal && !isNull(row[i])) {
      return true;
    }
  }
  return false;
}

bool SealShape::simulated(std::span<const Value> row) const {
  return flag_ >= 0 && textOf(row[static_cast<std::size_t>(flag_)]) == "1";
}

std::string sealOf(const Digest::Value& kept, std::vector<Digest::Value> parts) {
  if (parts.empty()) {
    return toHex(kept);
  }
  std::sort(parts.begin(), parts.end());
  Digest digest;
  addText(digest, "torsio row with parts 1");
  digest.update(std::as_bytes(std::span(kept)));
  for (const Digest::Value& part : parts) {
    digest.update(std::as_bytes(std::span(part)));
  }
  return digest.hex();
}

std::string keyText(std::span<const Value> key) {
  std::string text;
  for (const Value& value : key) {
    text += (text.empty() ? "" : "/") + textOf(value);
  }
  return text;
}

std::vector<Value> valuesOf(const Statement& row) {
  std::vector<Value> values;
  const int columns = row.columnCount();
  values.reserve(static_cast<std::size_t>(columns));
  for (int column = 0; column < columns; ++column) {
    values.push_back(row.value(column));
  }
  return values;
}

std::vector<std::string> columnNamesOf(const Statement& row) {
  std::vector<std::string> names;
  const int columns = row.columnCount();
  for (int column = 0; column < columns; ++column) {
    names.push_back(row.columnName(column));
  }
  return names;
}

std::vector<const SealRule*> rulesOfParts(std::string_view parent) {
  std::vector<const SealRule*> rules;
  for (const SealRule& rule : kSealRules) {
    if (rule.sealing == Sealing::kWithParent && rule.parent == parent) {
      rules.push_back(&rule);
    }
  }
  return rules;
}

void forEachSelected(Connection& connection, const std::string& select,
                     const std::function<void(const Statement&)>& take) {
  TORSIO_EXPECTS(connection.inTransaction());
  if (connection.engine() == Engine::kSqlite) {
    Statement row = connection.prepare(select);
    row.execute();
    while (row.step()) {
      take(row);
    }
    return;
  }
  // Without a cursor the driver would fetch the whole table at once.
  connection.executeVerbatim("DECLARE torsio_rows NO SCROLL CURSOR FOR " + select);
  for (bool more = true; more;) {
    Statement row = connection.selectVerbatim("FETCH 200 FROM torsio_rows");
    more = false;
    while (row.step()) {
      take(row);
      more = true;
    }
  }
  connection.executeVerbatim("CLOSE torsio_rows");
}

SealedParts partsOf(Connection& connection, std::string_view parent) {
  SealedParts parts;
  for (const SealRule* rule : rulesOfParts(parent)) {
    std::optional<SealShape> shape;
    forEachSelected(connection, "SELECT * FROM " + std::string(rule->table), [&](const Statement& row) {
      if (!shape) {
        shape.emplace(*rule, columnNamesOf(row));
      }
      const std::vector<Value> values = valuesOf(row);
      parts[shape->parentKeyOf(values)].push_back(shape->kept(values));
    });
  }
  return parts;
}

void forEachSealable(Connection& connection, const SealRule& rule, const TakeSealable& take,
                     const std::function<void(const std::string& key)>& orphan) {
  TORSIO_EXPECTS(rule.sealing == Sealing::kOnce || rule.sealing == Sealing::kEachChange);
  SealedParts parts = partsOf(connection, rule.table);
  std::optional<SealShape> shape;
  forEachSelected(connection, "SELECT * FROM " + std::string(rule.table), [&](const Statement& row) {
    if (!shape) {
      shape.emplace(rule, columnNamesOf(row));
    }
    const std::vector<Value> values = valuesOf(row);
    std::vector<Digest::Value> own;
    if (const auto found = parts.find(shape->keyOf(values)); found != parts.end()) {
      own = std::move(found->second);
      parts.erase(found);
    }
    take(*shape, values, sealOf(shape->kept(values), std::move(own)));
  });
  if (orphan) {
    for (const auto& [key, hashes] : parts) {
      orphan(key);
    }
  }
}

}  // namespace torsio
