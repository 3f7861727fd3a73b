// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/migrations/record_exchange.h"

#include <system_error>

#ifdef __linux__
#include <cstdio>
#include <fcntl.h>
#endif

#include "db/migrations/file_in_the_making.h"
#include "sim/core/file_io.h"

namespace torsio {

namespace fs = std::filesystem;

namespace {

fs::path noteOf(const fs::path& record) {
  return withSuffix(record, ".restoring");
}

bool exchangedAtOnce(const fs::path& a, const fs::path& b) {
#ifdef __linux__
  return renameat2(AT_FDCWD, a.c_str(), AT_FDCWD, b.c_str(), RENAME_EXCHANGE) == 0;
#else
  return a == b;
#endif
}

}  // namespace

void exchangeRecord(const fs::path& ready, const fs::path& target, const fs::path& aside, ExchangeBy first) {
  std::error_code failed;
  if (first == ExchangeBy::kOneStep) {
    // Renamed before the exchange, so that the old record has its final name right after it.
    fs::rename(ready, aside);
    if (exchangedAtOnce(aside, target)) {
      return;
    }
    fs::rename(aside, ready);
  }
  if (first != ExchangeBy::kNote) {
    fs::create_hard_link(target, aside, failed);
    if (!failed) {
      fs::rename(ready, target, failed);
      if (failed) {
        std::error_code ignored;
        fs::remove(aside, ignored);
        throw fs::filesystem_error("rename", ready, target, failed);
      }
      return;
    }
  }
  writeFileAtomically(noteOf(target), aside.filename().string());
  fs::rename(target, aside);
  fs::rename(ready, target, failed);
  if (failed) {
    recoverRecord(target);
    throw fs::filesystem_error("rename", ready, target, failed);
  }
  fs::remove(noteOf(target), failed);
}

void recoverRecord(const fs::path& record) {
  const fs::path note = noteOf(record);
  std::error_code ignored;
  if (!fs::is_regular_file(note, ignored)) {
    return;
  }
  const fs::path aside = record.parent_path() / fs::path(readFile(note)).filename();
  if (!fs::exists(record, ignored) && fs::is_regular_file(aside, ignored)) {
    fs::rename(aside, record);
  }
  fs::remove(note, ignored);
}

}  // namespace torsio
