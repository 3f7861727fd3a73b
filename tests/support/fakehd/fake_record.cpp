// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/fakehd/fake_record.h"

#include <cstdio>

namespace fakehd {

std::int64_t waited_ns(std::int64_t process, std::int64_t thread) {
  char path[64];
  std::snprintf(path, sizeof path, "/proc/%lld/task/%lld/schedstat", static_cast<long long>(process),
                static_cast<long long>(thread));
  std::FILE* const file = std::fopen(path, "r");
  if (file == nullptr) {
    return 0;
  }
  long long ran_ns = 0;
  long long waited = 0;
  const int found = std::fscanf(file, "%lld %lld", &ran_ns, &waited);
  std::fclose(file);
  return found == 2 ? waited : 0;
}

}  // namespace fakehd
