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

/// Threads that call services, each with a connection of its own: a connection belongs to the thread that
/// opened it. Any thread may hand them work.
class DeskWorkers {
 public:
  using Work = std::function<void(SessionContext&)>;

  /// Opens `count` connections to the record. Throws Error, DbError when it cannot be opened.
  DeskWorkers(const std::string& locator, std::size_t count, PasswordCost passwordCost);
  /// Finishes what is being done and drops what waits.
  ~DeskWorkers();
  DeskWorkers(const DeskWorkers&) = delete;
  DeskWorkers& operator=(const DeskWorkers&) = delete;

  /// False: too much waits already. `work` throws nothing; nobody is signed in when it begins.
  [[nodiscard]] bool take(Work work);
  /// Nothing is done and nothing waits.
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
