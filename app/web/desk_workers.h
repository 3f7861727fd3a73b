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
#include "assessment/domain/people/account.h"

namespace torsio::web {

/// Threads that call services, each with its own connection, because connections are confined to their
/// thread. Thread-safe.
class DeskWorkers {
 public:
  using Work = std::function<void(SessionContext&)>;

  /// Opens `count` connections to the record. Throws Error, DbError.
  DeskWorkers(const std::string& locator, std::size_t count, PasswordCost passwordCost);
  /// Finishes running work and drops queued work.
  ~DeskWorkers();
  DeskWorkers(const DeskWorkers&) = delete;
  DeskWorkers& operator=(const DeskWorkers&) = delete;

  /// Queues work; false: the queue is full. `work` must not throw; it starts with nobody signed in.
  [[nodiscard]] bool take(Work work);
  /// True if nothing is running or queued.
  [[nodiscard]] bool isIdle();

 private:
  void serve(const std::string& locator, PasswordCost passwordCost);

  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<Work> waiting_;
  std::size_t open_ = 0;
  std::size_t busy_ = 0;
  std::exception_ptr failure_;
  bool ending_ = false;
  std::vector<std::thread> threads_;
};

}  // namespace torsio::web
