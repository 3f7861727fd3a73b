// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/repository/base/touched_rows.h"

#include <algorithm>
#include <map>
#include <optional>
#include <string_view>
#include <unordered_map>
#include <unordered_set>

#include "db/repository/base/insert_idempotent.h"
#include "db/repository/base/sealed_row.h"
#include "sim/core/contracts.h"
#include "sim/core/error.h"

namespace torsio {

namespace {

/// Reads whole rows of a table by key.
class RowByKey {
 public:
  RowByKey(Connection& connection, const SealRule& rule)
      : statement_(connection.prepare("SELECT * FROM " + std::string(rule.table) + conditionOf(rule.key))),
        rule_(rule),
        parts_(rulesOfParts(rule.table)) {}

  std::optional<std::vector<Value>> read(std::span<const Value> key) {
    statement_.execute(key);
    if (!statement_.step()) {
      return std::nullopt;
    }
    std::vector<Value> values = valuesOf(statement_);
    if (!shape_) {
      shape_.emplace(rule_, columnNamesOf(statement_));
    }
    TORSIO_EXPECTS(!statement_.step());
    return values;
  }
  [[nodiscard]] const std::vector<const SealRule*>& parts() const { return parts_; }
  /// Valid after a row was read.
  [[nodiscard]] const SealShape& shape() const { return *shape_; }

 private:
  static std::string conditionOf(std::string_view key) {
    std::string condition;
    for (const std::string& column : columnsOf(key)) {
      condition += (condition.empty() ? " WHERE " : " AND ") + column + " = ?";
    }
    return condition;
  }

  Statement statement_;
  const SealRule& rule_;
  std::vector<const SealRule*> parts_;
  std::optional<SealShape> shape_;
};

bool sameGiven(const Value& given, const Value& read) {
  const auto* number = std::get_if<std::int64_t>(&given.storage());
  const auto* real = std::get_if<double>(&read.storage());
  return (number != nullptr && real != nullptr) ? static_cast<double>(*number) == *real
                                                : sameStored(given, read);
}

[[noreturn]] void altered(const TouchedRow& touched, const std::string& column) {
  throw Error(ErrorCode::kVerifyFailed,
              Text::tr("the column %1 was altered on its way into the record; nothing was kept", column),
              std::string(touched.rule->table), Text::tr("Run torsio audit verify: a trigger may do this"));
}

/// Compares stored rows with the values given for them.
class GivenRows {
 public:
  void require(const TouchedRow& touched, const SealShape& shape, std::span<const Value> row) {
    static const Value kNull;
    static const Value kComputed;  // placeholder; its value is not compared
    expected_.assign(row.size(), touched.whole ? &kNull : &kComputed);
    for (const GivenValues& given : touched.given) {
      const std::vector<ChangedStatement::Column>& columns = given.plan->change.columns;
      const std::vector<std::size_t>& places = placesOf(*given.plan, shape);
      for (std::size_t i = 0; i < columns.size(); ++i) {
        if (places[i] < row.size()) {
          const int placeholder = columns[i].placeholder;
          expected_[places[i]] =
              placeholder < 0 ? &kComputed : &given.bound[static_cast<std::size_t>(placeholder)];
        }
      }
    }
    for (std::size_t i = 0; i < row.size(); ++i) {
      if (expected_[i] != &kComputed && !sameGiven(*expected_[i], row[i])) {
        altered(touched, shape.columns()[i]);
      }
    }
  }

 private:
  /// Positions of a statement's columns in a row; past the end: the statement leaves the stored value.
  const std::vector<std::size_t>& placesOf(const LedgerPlan& plan, const SealShape& shape) {
    const auto [found, first] = places_.try_emplace(&plan);
    if (first) {
      const bool replaces = plan.change.onConflict == ChangedStatement::OnConflict::kUpdate;
      for (const ChangedStatement::Column& column : plan.change.columns) {
        const auto& replaced = plan.change.replaced;
        const bool kept =
            replaces && std::find(replaced.begin(), replaced.end(), column.name) == replaced.end();
        const auto at = std::find(shape.columns().begin(), shape.columns().end(), column.name);
        found->second.push_back(
            static_cast<std::size_t>((kept ? shape.columns().end() : at) - shape.columns().begin()));
      }
    }
    return found->second;
  }

  std::vector<const Value*> expected_;
  std::unordered_map<const LedgerPlan*, std::vector<std::size_t>> places_;
};

/// Seals the rows touched by one transaction.
class Sealer {
 public:
  explicit Sealer(Connection& connection) : connection_(connection) {}

  /// Compares a row with the values given. A row sealed with its parent adds that parent.
  void take(const TouchedRow& touched) {
    RowByKey& reader = readerOf(*touched.rule);
    const std::optional<std::vector<Value>> row = reader.read(touched.key);
    if (touched.gone != !row.has_value()) {
      altered(touched, std::string(touched.rule->key));
    }
    if (row) {
      given_.require(touched, reader.shape(), *row);
    }
    if (touched.rule->sealing != Sealing::kWithParent) {
      add(*touched.rule, touched.key, row);
      if (!touched.before.empty()) {
        seals_.back().before = touched.before;
      }
      return;
    }
    const SealRule* parent = sealRuleOf(touched.rule->parent);
    TORSIO_EXPECTS(parent != nullptr);
    const std::span<const Value> key(touched.key.data(), 1);
    add(*parent, key, readerOf(*parent).read(key));
  }
  [[nodiscard]] std::vector<RowSeal> seals() && { return std::move(seals_); }

 private:
  RowByKey& readerOf(const SealRule& rule) {
    auto found = readers_.find(&rule);
    if (found == readers_.end()) {
      found = readers_.try_emplace(&rule, connection_, rule).first;
    }
    return found->second;
  }

  void add(const SealRule& rule, std::span<const Value> key, const std::optional<std::vector<Value>>& row) {
    std::string text = keyText(key);
    // A row with parts may be named by each of them; seal it once.
    if (!readerOf(rule).parts().empty() && !sealed_[&rule].insert(text).second) {
      return;
    }
    if (!row) {
      seals_.push_back({.table = std::string(rule.table), .key = std::move(text), .removed = true});
      return;
    }
    seals_.push_back(sealedRow(readerOf(rule).shape(), *row,
                               sealOf(readerOf(rule).shape().kept(*row), partsOfRow(rule, key))));
  }

  std::vector<Digest::Value> partsOfRow(const SealRule& rule, std::span<const Value> key) {
    std::vector<Digest::Value> parts;
    for (const SealRule* part : readerOf(rule).parts()) {
      auto found = partStatements_.find(part);
      if (found == partStatements_.end()) {
        const std::string column = columnsOf(part->key).front();
        found = partStatements_
                    .emplace(part, connection_.prepare("SELECT * FROM " + std::string(part->table) +
                                                       " WHERE " + column + " = ?"))
                    .first;
      }
      Statement& row = found->second;
      row.execute(key);
      while (row.step()) {
        auto shape = shapes_.find(part);
        if (shape == shapes_.end()) {
          shape = shapes_.emplace(part, SealShape(*part, columnNamesOf(row))).first;
        }
        parts.push_back(shape->second.kept(valuesOf(row)));
      }
    }
    return parts;
  }

  Connection& connection_;
  GivenRows given_;
  std::map<const SealRule*, RowByKey> readers_;
  std::map<const SealRule*, Statement> partStatements_;
  std::map<const SealRule*, SealShape> shapes_;
  std::map<const SealRule*, std::unordered_set<std::string>> sealed_;
  std::vector<RowSeal> seals_;
};

}  // namespace

LedgerPlan::LedgerPlan(ChangedStatement statement, const SealRule* rule)
    : change(std::move(statement)), sealRule(rule) {
  if (sealRule == nullptr) {
    return;
  }
  for (const std::string& column : columnsOf(sealRule->key)) {
    keys.push_back(change.kind == ChangedStatement::Kind::kInsert ? change.placeholderOf(column) : -1);
  }
  if (std::find(keys.begin(), keys.end(), -1) != keys.end()) {
    keyColumns = sealRule->key;
  }
}

std::vector<RowSeal> sealsOf(Connection& connection, std::span<const TouchedRow> touched) {
  Sealer sealer(connection);
  for (const TouchedRow& row : touched) {
    sealer.take(row);
  }
  return std::move(sealer).seals();
}

}  // namespace torsio
