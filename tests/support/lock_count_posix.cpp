// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdlib>
#include <dlfcn.h>
#include <pthread.h>

#include "tests/support/lock_count.h"

namespace {

thread_local std::int64_t locks = 0;

#if defined(__SANITIZE_THREAD__) || defined(__SANITIZE_ADDRESS__)
constexpr bool kCounts = false;
#else
constexpr bool kCounts = true;

/// Returns the C library's function hidden by ours.
template <typename Function>
Function* hidden(const char* name) noexcept {
  void* const found = dlsym(RTLD_NEXT, name);
  if (found == nullptr) {
    std::abort();
  }
  return reinterpret_cast<Function*>(found);
}
#endif

}  // namespace

namespace torsio::testing {

std::int64_t lockCount() noexcept {
  return locks;
}

bool lockCountWorks() noexcept {
  return kCounts;
}

}  // namespace torsio::testing

#if !defined(__SANITIZE_THREAD__) && !defined(__SANITIZE_ADDRESS__)
// No local static with a guard, because a guard may lock.
extern "C" int pthread_mutex_lock(pthread_mutex_t* mutex) noexcept {
  ++locks;
  return hidden<int(pthread_mutex_t*)>("pthread_mutex_lock")(mutex);
}
extern "C" int pthread_mutex_trylock(pthread_mutex_t* mutex) noexcept {
  ++locks;
  return hidden<int(pthread_mutex_t*)>("pthread_mutex_trylock")(mutex);
}
extern "C" int pthread_rwlock_rdlock(pthread_rwlock_t* lock) noexcept {
  ++locks;
  return hidden<int(pthread_rwlock_t*)>("pthread_rwlock_rdlock")(lock);
}
extern "C" int pthread_rwlock_wrlock(pthread_rwlock_t* lock) noexcept {
  ++locks;
  return hidden<int(pthread_rwlock_t*)>("pthread_rwlock_wrlock")(lock);
}
#endif
