// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/web/desk_workers.h"

#include <exception>
#include <utility>

namespace torsio::web {

namespace {

constexpr std::size_t kMaxWaiting = 1000;  // a second or two of work for all threads

}  // namespace

DeskWorkers::DeskWorkers(const std::string& locator, std::size_t count, PasswordCost passwordCost) {
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

bool DeskWorkers::take(Work work) {
  {
    const std::lock_guard lock(mutex_);
    if (ending_ || waiting_.size() >= kMaxWaiting) {
      return false;
    }
    waiting_.push_back(std::move(work));
  }
  changed_.notify_all();
  return true;
}

bool DeskWorkers::isIdle() {
  const std::lock_guard lock(mutex_);
  return waiting_.empty() && busy_ == 0;
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
      const Work work = std::move(waiting_.front());
      waiting_.pop_front();
      ++busy_;
      lock.unlock();
      work(session);
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
