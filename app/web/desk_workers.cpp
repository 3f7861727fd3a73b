// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/web/desk_workers.h"

#include <algorithm>
#include <chrono>
#include <exception>
#include <iterator>
#include <utility>

#include "app/services/access/database_away.h"
#include "app/services/access/station_name.h"
#include "db/connection/probe.h"
#include "sim/core/error.h"

namespace torsio::web {

namespace {

constexpr std::size_t kMaxWaiting = 1000;  // a second or two of work for all threads

}  // namespace

DeskWorkers::DeskWorkers(const std::string& locator, std::size_t count, PasswordCost passwordCost,
                         RecordState& record, Next next)
    : record_(record), next_(next) {
  for (std::size_t i = 0; i < count; ++i) {
    threads_.emplace_back([this, locator, passwordCost] { serve(locator, passwordCost); });
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this, i] { return open_ > i || failure_ != nullptr; });
    if (failure_ != nullptr) {
      ending_ = true;
      break;
    }
  }
  if (failure_ == nullptr) {
    return;
  }
  changed_.notify_all();
  for (std::thread& thread : threads_) {
    thread.join();
  }
  std::rethrow_exception(failure_);
}

DeskWorkers::~DeskWorkers() {
  {
    const std::lock_guard lock(mutex_);
    ending_ = true;
    waiting_.clear();
  }
  changed_.notify_all();
  for (std::thread& thread : threads_) {
    thread.join();
  }
}

bool DeskWorkers::take(Work work, int rank, std::function<void()> givenUp) {
  std::function<void()> last;
  {
    const std::lock_guard lock(mutex_);
    if (ending_) {
      return false;
    }
    if (waiting_.size() >= kMaxWaiting) {
      if (waiting_.back().rank <= rank || !waiting_.back().givenUp) {
        return false;
      }
      last = std::move(waiting_.back().givenUp);
      waiting_.pop_back();
    }
    const auto behind = std::find_if(waiting_.begin(), waiting_.end(),
                                     [rank](const Waiting& one) { return one.rank > rank; });
    waiting_.insert(behind, {std::move(work), rank, std::move(givenUp)});
  }
  changed_.notify_all();
  if (last) {
    last();
  }
  return true;
}

DeskWorkers::Work DeskWorkers::popNext() {
  auto at = waiting_.begin();
  if (next_ == Next::kOldestAndNewest) {
    if (newest_) {
      const auto behind = std::find_if(waiting_.begin(), waiting_.end(), [this](const Waiting& one) {
        return one.rank > waiting_.front().rank;
      });
      at = std::prev(behind);
    }
    newest_ = !newest_;
  }
  Work work = std::move(at->work);
  waiting_.erase(at);
  return work;
}

std::size_t DeskWorkers::waiting(int rank) {
  const std::lock_guard lock(mutex_);
  return static_cast<std::size_t>(std::count_if(waiting_.begin(), waiting_.end(),
                                                [rank](const Waiting& one) { return one.rank == rank; }));
}

std::size_t DeskWorkers::waiting() {
  const std::lock_guard lock(mutex_);
  return waiting_.size();
}

bool DeskWorkers::isIdle() {
  const std::lock_guard lock(mutex_);
  return waiting_.empty() && busy_ == 0;
}

/// Returns whether the session's connection answers, reopened if it was lost.
bool DeskWorkers::reach(SessionContext& session) {
  try {
    probe(session.connectionWithoutRight());
    return true;
  } catch (...) {
    if (!saysDatabaseAway(std::current_exception())) {
      return true;  // the work meets the error and reports it
    }
  }
  using Clock = std::chrono::steady_clock;
  if (!record_.mayTry(Clock::now())) {
    return false;
  }
  try {
    session.reconnect();
    record_.reached(Clock::now());
    return true;
  } catch (const Error& error) {
    record_.failed(error.happened(), Clock::now());
    return false;
  }
}

void DeskWorkers::serve(const std::string& locator, PasswordCost passwordCost) {
  try {
    SessionContext session({locator, stationName(), {}});
    session.setPasswordCost(passwordCost);
    std::unique_lock lock(mutex_);
    ++open_;
    changed_.notify_all();
    while (true) {
      changed_.wait(lock, [this] { return ending_ || !waiting_.empty(); });
      if (ending_) {
        return;
      }
      const Work work = popNext();
      ++busy_;
      lock.unlock();
      work(reach(session) ? &session : nullptr);
      session.setActor({});
      lock.lock();
      --busy_;
    }
  } catch (...) {
    const std::lock_guard lock(mutex_);
    failure_ = std::current_exception();
    changed_.notify_all();
  }
}

}  // namespace torsio::web
