// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <exception>
#include <functional>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "app/services/access/session_context.h"
#include "app/web/record_state.h"
#include "assessment/domain/people/account.h"

namespace torsio::web {

/// Threads that call services, each with its own connection, because connections are confined to their
/// thread. A connection that was lost is reopened before the next work. Thread-safe.
class DeskWorkers {
 public:
  /// Null: the record cannot be reached.
  using Work = std::function<void(SessionContext*)>;

  /// Which of several works of one rank is next.
  enum class Next {
    kOldest,
    kOldestAndNewest,  ///< by turns: somebody new waits for two works at most, and nobody waits for ever
  };
  /// Opens `count` connections to the record. `record` outlives the threads. Throws Error, DbError.
  DeskWorkers(const std::string& locator, std::size_t count, PasswordCost passwordCost, RecordState& record,
              Next next = Next::kOldest);
  /// Finishes running work and drops queued work.
  ~DeskWorkers();
  DeskWorkers(const DeskWorkers&) = delete;
  DeskWorkers& operator=(const DeskWorkers&) = delete;

  /// Queues work, behind other work of the same or a lower `rank`; false: the queue is full of such work. Of
  /// a full queue, the last work of a higher rank is given up instead: its `givenUp` is called. Neither may
  /// throw. `work` starts with nobody signed in.
  [[nodiscard]] bool take(Work work, int rank = 0, std::function<void()> givenUp = {});
  /// Returns how many works of this rank are queued.
  [[nodiscard]] std::size_t waiting(int rank);
  /// Of all ranks.
  [[nodiscard]] std::size_t waiting();
  /// True if nothing is running or queued.
  [[nodiscard]] bool isIdle();

 private:
  void serve(const std::string& locator, PasswordCost passwordCost);
  [[nodiscard]] bool reach(SessionContext& session);

  RecordState& record_;
  std::mutex mutex_;
  std::condition_variable changed_;
  struct Waiting {
    Work work;
    int rank;
    std::function<void()> givenUp;
  };
  /// Takes the work that is next out of the queue. Call with the mutex held, and not for an empty queue.
  [[nodiscard]] Work popNext();
  std::deque<Waiting> waiting_;  // by rank, then by arrival
  Next next_;
  bool newest_ = true;  // the next work is the newest of its rank
  std::size_t open_ = 0;
  std::size_t busy_ = 0;
  std::exception_ptr failure_;
  bool ending_ = false;
  std::vector<std::thread> threads_;
};

}  // namespace torsio::web
