// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/repository/base/row_ledger.h"

#include <algorithm>
#include <functional>
#include <map>
#include <optional>
#include <unordered_map>
#include <unordered_set>

#include "db/connection/change_watch.h"
#include "db/repository/base/changed_statement.h"
#include "db/repository/base/row_seal.h"
#include "db/repository/base/rows_before.h"
#include "db/repository/base/sealed_row.h"
#include "db/repository/base/touched_rows.h"
#include "sim/core/clock.h"

namespace torsio {

namespace {

constexpr std::string_view kTrail = "audit_entry";
constexpr std::size_t kKnownPlans = 1'000;

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
    writeSeals(connection, sealsOf(connection, touched_),
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
