// SPDX-License-Identifier: GPL-3.0-or-later
#include <utility>

#include "assessment/attempt/trial_listing.h"
#include "db/connection/connection.h"
#include "db/connection/db_error.h"
#include "db/connection/locator.h"
#include "db/repository/base/row_ledger.h"
#include "db/repository/trial/trial_repository.h"
#include "sim/core/contracts.h"

namespace torsio {

namespace {

// The recorder's ring holds eight seconds, so a hanging server must be given up before it is full: two
// seconds to connect, three to detect a pulled cable, four per statement.
constexpr int kPatience_ms = 2000;
constexpr const char* kStatementLimit = "SET statement_timeout = 4000";

}  // namespace

struct OwnConnectionTrialSink::Open {
  Open(const std::string& locator, const TrialContext& context)
      : connection(
            openDatabase(locator, OpenMode::kReadWrite,
                         parseLocator(locator).engine == Engine::kSqlite ? kBusyTimeout_ms : kPatience_ms)),
        repository(connection, context) {
    sealChanges(connection);
    if (connection.engine() == Engine::kPostgresql) {
      connection.executeVerbatim(kStatementLimit);
    }
  }
  Connection connection;
  TrialRepository repository;
};

OwnConnectionTrialSink::OwnConnectionTrialSink(std::string locator, TrialContext context)
    : locator_(std::move(locator)), context_(std::move(context)) {}

OwnConnectionTrialSink::~OwnConnectionTrialSink() = default;

void OwnConnectionTrialSink::open() {
  open_ = std::make_unique<Open>(locator_, context_);
  if (!trialId_.empty()) {
    open_->repository.resume(trialId_);
  }
}

void OwnConnectionTrialSink::store(const std::function<void(TrialRepository&)>& act) {
  const bool connected = open_ != nullptr;
  for (bool last = !connected;; last = true) {
    if (!open_) {
      open();
    }
    try {
      act(open_->repository);
      return;
    } catch (const DbError& error) {
      if (error.fault() != DbFault::kUnreachable) {
        throw;
      }
      open_.reset();
      if (last) {
        throw;
      }
    }
  }
}

void OwnConnectionTrialSink::begin(const TrialHeader& header) {
  TORSIO_EXPECTS(trialId_.empty());
  store([&](TrialRepository& trials) { trials.begin(header); });
  trialId_ = header.trialId;
}

void OwnConnectionTrialSink::append(const TrialChunk& chunk) {
  TORSIO_EXPECTS(!trialId_.empty());
  store([&](TrialRepository& trials) { trials.append(chunk); });
}

void OwnConnectionTrialSink::finish(const TrialSummary& summary) {
  TORSIO_EXPECTS(!trialId_.empty());
  store([&](TrialRepository& trials) { trials.finish(summary); });
  trialId_ = {};
  open_.reset();
}

}  // namespace torsio
