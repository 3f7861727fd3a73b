// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/repository/base/row_ledger.h"

#include <algorithm>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <unordered_map>
#include <unordered_set>

#include "db/connection/connection.h"
#include "db/repository/base/changed_statement.h"
#include "db/repository/base/insert_idempotent.h"
#include "db/repository/base/row_seal.h"
#include "db/repository/base/seal_rules.h"
#include "sim/core/clock.h"
#include "sim/core/contracts.h"
#include "sim/core/error.h"

namespace torsio {

namespace {

constexpr std::string_view kTrail = "audit_entry";
constexpr std::size_t kKnownPlans = 1'000;

/// A statement that changes rows of one table.
class LedgerPlan : public ChangeWatch::Plan {
 public:
  /// `rule`: null for an entry of the audit trail.
  LedgerPlan(ChangedStatement statement, const SealRule* rule)
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

  [[nodiscard]] std::string returning() const override { return keyColumns; }

  ChangedStatement change;
  const SealRule* sealRule;  ///< null: an entry of the audit trail
  std::vector<int> keys;     ///< indices of the key's placeholders
  std::string keyColumns;    ///< empty: the statement gives the key
};

/// Values that one statement gave for a row.
struct GivenValues {
  std::shared_ptr<const LedgerPlan> plan;
  std::vector<Value> bound;
};

struct TouchedRow {
  const SealRule* rule = nullptr;
  std::vector<Value> key;
  std::vector<GivenValues> given{};  ///< in order of execution
  bool whole = false;                ///< inserted: columns not given are null
  bool gone = false;
  std::string before{};  ///< RowSeal::before
};

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

class RowLedger : public ChangeWatch {
 public:
  std::shared_ptr<const Plan> planOf(std::string_view sql) override {
    if (const auto known = plans_.find(sql); known != plans_.end()) {
      return known->second;
    }
    if (plans_.size() >= kKnownPlans) {
      plans_.clear();
    }
    return plans_.try_emplace(std::string(sql), newPlan(sql)).first->second;
  }

  void changing(Connection& connection, const Plan& plan, std::span<const Value> bound) override {
    const auto& ledger = dynamic_cast<const LedgerPlan&>(plan);  // planOf() makes no other type
    if (ledger.sealRule == nullptr) {
      return;
    }
    for (RowBefore& row : rowsBefore(connection, *ledger.sealRule, ledger.change, bound)) {
      const std::size_t known = touched_.size();
      TouchedRow& touched = touchedRow(*ledger.sealRule, std::move(row.key));
      if (touched_.size() > known) {
        touched.before = std::move(row.hash);
      }
    }
  }

  void changed(const std::shared_ptr<const Plan>& plan, std::span<const Value> bound, const Rows& returned,
               std::int64_t rows) override {
    const auto known = std::static_pointer_cast<const LedgerPlan>(plan);  // planOf() makes no other type
    const LedgerPlan& ledger = *known;
    if (ledger.sealRule == nullptr) {
      noteEntry(ledger.change, bound);
      return;
    }
    if (ledger.keyColumns.empty()) {
      if (rows > 0) {
        std::vector<Value> key;
        for (const int placeholder : ledger.keys) {
          key.push_back(bound[static_cast<std::size_t>(placeholder)]);
        }
        touch(known, std::move(key), bound);
      }
      return;
    }
    for (const std::vector<Value>& key : returned) {
      touch(known, key, bound);
    }
  }

  void changedElsewhere(std::string_view table, std::vector<Value> key, bool removed) override {
    if (const SealRule* rule = sealRuleOf(table)) {
      TouchedRow& row = touchedRow(*rule, std::move(key));
      row.given.clear();
      row.whole = false;
      row.gone = removed;
    }
  }

  void beforeCommit(Connection& connection) override {
    if (touched_.empty()) {
      return;
    }
    Sealer sealer(connection);
    for (const TouchedRow& row : touched_) {
      sealer.take(row);
    }
    writeSeals(connection, std::move(sealer).seals(),
               {.atUtc_us = entries_ > 0 ? last_.atUtc_us : utcNow_us(),
                .actor = entries_ > 0 ? last_.actor : "torsio",
                .station = last_.station,
                .entries = entries_});
  }

  void forget() noexcept override {
    touched_.clear();
    places_.clear();
    entries_ = 0;
    last_ = {};
  }

 private:
  static std::shared_ptr<const Plan> newPlan(std::string_view sql) {
    std::optional<ChangedStatement> change = changedBy(sql);
    if (!change) {
      return nullptr;
    }
    if (change->table == kTrail && change->kind == ChangedStatement::Kind::kInsert) {
      return std::make_shared<LedgerPlan>(std::move(*change), nullptr);
    }
    const SealRule* rule = sealRuleOf(change->table);
    if (rule == nullptr ||
        (change->kind == ChangedStatement::Kind::kUpdate && onlyUnsealed(*change, *rule))) {
      return nullptr;
    }
    return std::make_shared<LedgerPlan>(std::move(*change), rule);
  }

  static bool onlyUnsealed(const ChangedStatement& change, const SealRule& rule) {
    const std::vector<std::string> unsealed = columnsOf(rule.unsealed);
    return std::all_of(change.columns.begin(), change.columns.end(),
                       [&](const ChangedStatement::Column& column) {
                         return std::find(unsealed.begin(), unsealed.end(), column.name) != unsealed.end();
                       });
  }

  void noteEntry(const ChangedStatement& change, std::span<const Value> bound) {
    ++entries_;
    const auto given = [&](const char* column) {
      const int placeholder = change.placeholderOf(column);
      return placeholder < 0 ? Value() : bound[static_cast<std::size_t>(placeholder)];
    };
    const auto text = [](const Value& value) {
      const auto* stored = std::get_if<std::string>(&value.storage());
      return stored == nullptr ? std::string() : *stored;
    };
    const Value time = given("at_utc_us");
    const auto* at = std::get_if<std::int64_t>(&time.storage());
    last_ = {.atUtc_us = at == nullptr ? 0 : *at,
             .actor = text(given("actor")),
             .station = text(given("station"))};
  }

  TouchedRow& touchedRow(const SealRule& rule, std::vector<Value> key) {
    std::string place(rule.table);
    place.append("/").append(keyText(key));
    const auto [found, first] = places_.try_emplace(std::move(place), touched_.size());
    if (first) {
      touched_.push_back({.rule = &rule, .key = std::move(key)});
    }
    return touched_[found->second];
  }

  void touch(const std::shared_ptr<const LedgerPlan>& plan, std::vector<Value> key,
             std::span<const Value> bound) {
    TouchedRow& row = touchedRow(*plan->sealRule, std::move(key));
    using Kind = ChangedStatement::Kind;
    if (plan->change.kind == Kind::kDelete) {
      row.given.clear();
      row.whole = false;
      row.gone = true;
      return;
    }
    if (plan->change.kind == Kind::kInsert) {
      row.whole = plan->change.onConflict != ChangedStatement::OnConflict::kUpdate;
      row.gone = false;
    }
    row.given.push_back({plan, {bound.begin(), bound.end()}});
  }

  struct Author {
    std::int64_t atUtc_us = 0;
    std::string actor{};
    std::string station{};
  };

  std::map<std::string, std::shared_ptr<const Plan>, std::less<>> plans_;  // of statements seen before
  std::vector<TouchedRow> touched_;
  std::unordered_map<std::string, std::size_t> places_;
  std::int64_t entries_ = 0;  // audit entries of this transaction
  Author last_;
};

}  // namespace

void sealChanges(Connection& connection) {
  (void)connection.watchChanges(std::make_shared<RowLedger>());
}

UnsealedCopy::UnsealedCopy(Connection& connection)
    : connection_(connection), watch_(connection.watchChanges(nullptr)) {}

UnsealedCopy::~UnsealedCopy() {
  (void)connection_.watchChanges(std::move(watch_));
}

std::int64_t sealUnsealed(Connection& connection, const std::string& reason, std::int64_t utc_us) {
  Transaction transaction(connection);
  std::unordered_set<std::string> sealed;
  forEachSelected(connection, "SELECT table_name, row_key FROM row_seal",
                  [&](const Statement& row) { sealed.insert(row.text(0) + "/" + row.text(1)); });
  std::vector<RowSeal> seals;
  for (const SealRule& rule : kSealRules) {
    if (rule.sealing != Sealing::kOnce && rule.sealing != Sealing::kEachChange) {
      continue;
    }
    forEachSealable(connection, rule,
                    [&](const SealShape& shape, std::span<const Value> row, const std::string& seal) {
                      if (!sealed.contains(std::string(rule.table) + "/" + shape.keyOf(row))) {
                        seals.push_back(sealedRow(shape, row, seal));
                      }
                    });
  }
  if (!seals.empty()) {
    writeSeals(connection, seals, {.atUtc_us = utc_us, .actor = "torsio", .reason = reason});
  }
  transaction.commit();
  return static_cast<std::int64_t>(seals.size());
}

}  // namespace torsio
