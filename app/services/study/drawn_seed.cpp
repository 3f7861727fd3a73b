// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/study/drawn_seed.h"

#include "db/repository/base/id_source.h"
#include "sim/core/digest.h"

namespace torsio {

std::uint64_t drawSeed(IdSource& ids) {
  // 122 random bits of a UUID, spread over 64 by the hash.
  Digest digest;
  digest.update(ids.newUuid());
  const Digest::Value value = digest.value();
  std::uint64_t seed = 0;
  for (std::size_t i = 0; i < sizeof(seed); ++i) {
    seed = seed << 8U | value[i];
  }
  return seed;
}

std::string drawSalt(IdSource& ids) {
  // Three UUIDs hold 366 random bits.
  Digest digest;
  for (int i = 0; i < 3; ++i) {
    digest.update(ids.newUuid());
  }
  return digest.hex();
}

}  // namespace torsio
