// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/core/private_files.h"

#include <system_error>

#ifndef _WIN32
#include <sys/resource.h>
#ifdef __linux__
#include <sys/prctl.h>
#endif
#include <sys/stat.h>
#endif

namespace torsio {

namespace fs = std::filesystem;

namespace {

bool closeToOthers(const fs::path& file) noexcept {
#ifdef _WIN32
  return file.empty() && false;
#else
  constexpr auto kOthers = fs::perms::group_all | fs::perms::others_all;
  std::error_code failed;
  const fs::file_status status = fs::symlink_status(file, failed);
  const bool ours = fs::is_regular_file(status) || fs::is_directory(status);
  if (failed || !ours || (status.permissions() & kOthers) == fs::perms::none) {
    return false;
  }
  fs::permissions(file, kOthers, fs::perm_options::remove, failed);
  return !failed;
#endif
}

}  // namespace

void keepFilesPrivate() noexcept {
#ifndef _WIN32
  umask(S_IRWXG | S_IRWXO);
#endif
  disableCoreDumps();
}

void disableCoreDumps() noexcept {
#ifndef _WIN32
  const rlimit none{.rlim_cur = 0, .rlim_max = 0};
  setrlimit(RLIMIT_CORE, &none);
#endif
#ifdef __linux__
  prctl(PR_SET_DUMPABLE, 0, 0, 0, 0);  // where dumps go to a program (apport), the limit counts for nothing
#endif
}

bool makePrivate(const fs::path& file) noexcept {
  bool changed = closeToOthers(file);
  std::error_code unreadable;
  if (fs::is_directory(fs::symlink_status(file, unreadable))) {
    for (fs::recursive_directory_iterator entry(file, unreadable), end; !unreadable && entry != end;
         entry.increment(unreadable)) {
      changed = closeToOthers(entry->path()) || changed;
    }
  }
  return changed;
}

}  // namespace torsio
