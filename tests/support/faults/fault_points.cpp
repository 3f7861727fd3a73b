// SPDX-License-Identifier: GPL-3.0-or-later
// Preloaded (LD_PRELOAD), it counts the calls by which a program changes a disk or talks to a server, and can
// end the program at one of them:
//   TORSIO_FAULT_COUNT=FILE   writes the number of instants to FILE
//   TORSIO_FAULT_KILL_AT=K    kills the program at the K-th instant
//   TORSIO_FAULT_STOP_EVERY=N stops it at every N-th instant (SIGSTOP), so that its state can be inspected
//   TORSIO_FAULT_FULL_AT=K    the disk is full from the K-th instant on
//   TORSIO_FAULT_CLOCK_S=N    the wall clock is N seconds ahead
// Each call has an instant right before it; one that transfers bytes has a second, when half of them are out.
#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <dlfcn.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <sys/types.h>
#include <sys/uio.h>
#include <unistd.h>

#define HOOKED(name) __asm__(name) __attribute__((visibility("default"), used))

namespace {

std::atomic<long> instants{0};

long numberOf(const char* variable) {
  const char* text = std::getenv(variable);
  return text == nullptr ? 0 : std::atol(text);
}

const long killAt = numberOf("TORSIO_FAULT_KILL_AT");
const long fullAt = numberOf("TORSIO_FAULT_FULL_AT");
const long stopEvery = numberOf("TORSIO_FAULT_STOP_EVERY");
const long clockAhead_s = numberOf("TORSIO_FAULT_CLOCK_S");

template <typename Function>
Function* real(const char* name) {
  return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
}

void dieAt(long instant) {
  if (instant == killAt) {
    kill(getpid(), SIGKILL);
  }
  if (stopEvery != 0 && instant % stopEvery == 0) {
    kill(getpid(), SIGSTOP);
  }
}

/// Counts the next instant. False: the disk is full.
bool passes() {
  const long instant = ++instants;
  dieAt(instant);
  return fullAt == 0 || instant < fullAt;
}

/// Returns whether writing to a descriptor counts: a file or a server, but no terminal or pipe.
bool counts(int descriptor) {
  struct stat found {};
  return descriptor > STDERR_FILENO && fstat(descriptor, &found) == 0 &&
         (S_ISREG(found.st_mode) || S_ISSOCK(found.st_mode));
}

bool isSocket(int descriptor) {
  struct stat found {};
  return fstat(descriptor, &found) == 0 && S_ISSOCK(found.st_mode);
}

/// Transfers `size` bytes with `hand`; half of them are out at the second instant.
template <typename Hand>
ssize_t handOver(int descriptor, size_t size, Hand&& hand) {
  if (!counts(descriptor)) {
    return hand(size);
  }
  if (!passes() && !isSocket(descriptor)) {
    errno = ENOSPC;
    return -1;
  }
  if (size > 1) {
    const long instant = ++instants;
    if (instant == killAt || (stopEvery != 0 && instant % stopEvery == 0)) {
      const ssize_t half = hand(size / 2);
      dieAt(instant);
      return half;
    }
  }
  return hand(size);
}

/// A call that creates something.
template <typename Call>
auto make(Call&& call) -> decltype(call()) {
  if (!passes()) {
    errno = ENOSPC;
    return -1;
  }
  return call();
}

/// A call that a full disk does not refuse.
template <typename Call>
auto change(Call&& call) -> decltype(call()) {
  (void)passes();
  return call();
}

bool makes(const char* path, int flags) {
  return (flags & O_CREAT) != 0 && access(path, F_OK) != 0;
}

__attribute__((destructor)) void writeCount() {
  const char* file = std::getenv("TORSIO_FAULT_COUNT");
  if (file == nullptr) {
    return;
  }
  const int out = real<int(const char*, int, ...)>("open")(file, O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC,
                                                           S_IRUSR | S_IWUSR);
  std::array<char, 32> text{};
  const int length = std::snprintf(text.data(), text.size(), "%ld\n", instants.load());
  (void)!real<ssize_t(int, const void*, size_t)>("write")(out, text.data(), static_cast<size_t>(length));
  close(out);
}

}  // namespace

extern "C" {

ssize_t hookedWrite(int fd, const void* bytes, size_t size) HOOKED("write");
ssize_t hookedWrite(int fd, const void* bytes, size_t size) {
  static auto* const call = real<ssize_t(int, const void*, size_t)>("write");
  return handOver(fd, size, [&](size_t some) { return call(fd, bytes, some); });
}

ssize_t hookedWritev(int fd, const iovec* parts, int count) HOOKED("writev");
ssize_t hookedWritev(int fd, const iovec* parts, int count) {
  static auto* const call = real<ssize_t(int, const iovec*, int)>("writev");
  return handOver(fd, 1, [&](size_t) { return call(fd, parts, count); });
}

ssize_t hookedPwrite(int fd, const void* bytes, size_t size, off_t at) HOOKED("pwrite");
ssize_t hookedPwrite(int fd, const void* bytes, size_t size, off_t at) {
  static auto* const call = real<ssize_t(int, const void*, size_t, off_t)>("pwrite");
  return handOver(fd, size, [&](size_t some) { return call(fd, bytes, some, at); });
}

ssize_t hookedPwrite64(int fd, const void* bytes, size_t size, off64_t at) HOOKED("pwrite64");
ssize_t hookedPwrite64(int fd, const void* bytes, size_t size, off64_t at) {
  static auto* const call = real<ssize_t(int, const void*, size_t, off64_t)>("pwrite64");
  return handOver(fd, size, [&](size_t some) { return call(fd, bytes, some, at); });
}

ssize_t hookedSend(int fd, const void* bytes, size_t size, int flags) HOOKED("send");
ssize_t hookedSend(int fd, const void* bytes, size_t size, int flags) {
  static auto* const call = real<ssize_t(int, const void*, size_t, int)>("send");
  return handOver(fd, size, [&](size_t some) { return call(fd, bytes, some, flags); });
}

ssize_t hookedSendfile(int to, int from, off_t* at, size_t size) HOOKED("sendfile");
ssize_t hookedSendfile(int to, int from, off_t* at, size_t size) {
  static auto* const call = real<ssize_t(int, int, off_t*, size_t)>("sendfile");
  return handOver(to, size, [&](size_t some) { return call(to, from, at, some); });
}

ssize_t hookedCopyRange(int from, off64_t* fromAt, int to, off64_t* toAt, size_t size, unsigned flags)
    HOOKED("copy_file_range");
ssize_t hookedCopyRange(int from, off64_t* fromAt, int to, off64_t* toAt, size_t size, unsigned flags) {
  static auto* const call = real<ssize_t(int, off64_t*, int, off64_t*, size_t, unsigned)>("copy_file_range");
  return handOver(to, size, [&](size_t some) { return call(from, fromAt, to, toAt, some, flags); });
}

int hookedFsync(int fd) HOOKED("fsync");
int hookedFsync(int fd) {
  static auto* const call = real<int(int)>("fsync");
  return change([&] { return call(fd); });
}

int hookedFdatasync(int fd) HOOKED("fdatasync");
int hookedFdatasync(int fd) {
  static auto* const call = real<int(int)>("fdatasync");
  return change([&] { return call(fd); });
}

int hookedFtruncate(int fd, off_t size) HOOKED("ftruncate");
int hookedFtruncate(int fd, off_t size) {
  static auto* const call = real<int(int, off_t)>("ftruncate");
  return change([&] { return call(fd, size); });
}

int hookedFtruncate64(int fd, off64_t size) HOOKED("ftruncate64");
int hookedFtruncate64(int fd, off64_t size) {
  static auto* const call = real<int(int, off64_t)>("ftruncate64");
  return change([&] { return call(fd, size); });
}

int hookedRename(const char* from, const char* to) HOOKED("rename");
int hookedRename(const char* from, const char* to) {
  static auto* const call = real<int(const char*, const char*)>("rename");
  return change([&] { return call(from, to); });
}

int hookedRenameat2(int a, const char* from, int b, const char* to, unsigned flags) HOOKED("renameat2");
int hookedRenameat2(int a, const char* from, int b, const char* to, unsigned flags) {
  static auto* const call = real<int(int, const char*, int, const char*, unsigned)>("renameat2");
  return change([&] { return call(a, from, b, to, flags); });
}

int hookedLink(const char* from, const char* to) HOOKED("link");
int hookedLink(const char* from, const char* to) {
  static auto* const call = real<int(const char*, const char*)>("link");
  return make([&] { return call(from, to); });
}

int hookedUnlink(const char* path) HOOKED("unlink");
int hookedUnlink(const char* path) {
  static auto* const call = real<int(const char*)>("unlink");
  return change([&] { return call(path); });
}

int hookedRemove(const char* path) HOOKED("remove");
int hookedRemove(const char* path) {
  static auto* const call = real<int(const char*)>("remove");
  return change([&] { return call(path); });
}

int hookedUnlinkat(int folder, const char* path, int flags) HOOKED("unlinkat");
int hookedUnlinkat(int folder, const char* path, int flags) {
  static auto* const call = real<int(int, const char*, int)>("unlinkat");
  return change([&] { return call(folder, path, flags); });
}

int hookedRmdir(const char* path) HOOKED("rmdir");
int hookedRmdir(const char* path) {
  static auto* const call = real<int(const char*)>("rmdir");
  return change([&] { return call(path); });
}

int hookedMkdir(const char* path, mode_t mode) HOOKED("mkdir");
int hookedMkdir(const char* path, mode_t mode) {
  static auto* const call = real<int(const char*, mode_t)>("mkdir");
  return make([&] { return call(path, mode); });
}

int hookedFchmodat(int folder, const char* path, mode_t mode, int flags) HOOKED("fchmodat");
int hookedFchmodat(int folder, const char* path, mode_t mode, int flags) {
  static auto* const call = real<int(int, const char*, mode_t, int)>("fchmodat");
  return change([&] { return call(folder, path, mode, flags); });
}

int hookedOpen(const char* path, int flags, ...) HOOKED("open");
int hookedOpen(const char* path, int flags, ...) {
  static auto* const call = real<int(const char*, int, ...)>("open");
  va_list rest;
  va_start(rest, flags);
  const unsigned mode = (flags & (O_CREAT | O_TMPFILE)) != 0 ? va_arg(rest, unsigned) : 0;
  va_end(rest);
  const auto opened = [&] { return call(path, flags, mode); };
  return makes(path, flags) ? make(opened) : opened();
}

int hookedOpen64(const char* path, int flags, ...) HOOKED("open64");
int hookedOpen64(const char* path, int flags, ...) {
  static auto* const call = real<int(const char*, int, ...)>("open64");
  va_list rest;
  va_start(rest, flags);
  const unsigned mode = (flags & (O_CREAT | O_TMPFILE)) != 0 ? va_arg(rest, unsigned) : 0;
  va_end(rest);
  const auto opened = [&] { return call(path, flags, mode); };
  return makes(path, flags) ? make(opened) : opened();
}

FILE* hookedFopen64(const char* path, const char* mode) HOOKED("fopen64");
FILE* hookedFopen64(const char* path, const char* mode) {
  static auto* const call = real<FILE*(const char*, const char*)>("fopen64");
  const bool creates = std::strchr(mode, 'r') == nullptr && access(path, F_OK) != 0;
  if (creates && !passes()) {
    errno = ENOSPC;
    return nullptr;
  }
  return call(path, mode);
}

int hookedClock(clockid_t clock, timespec* now) HOOKED("clock_gettime");
int hookedClock(clockid_t clock, timespec* now) {
  static auto* const call = real<int(clockid_t, timespec*)>("clock_gettime");
  const int failed = call(clock, now);
  if (failed == 0 && clock == CLOCK_REALTIME) {
    now->tv_sec += clockAhead_s;
  }
  return failed;
}

}  // extern "C"
