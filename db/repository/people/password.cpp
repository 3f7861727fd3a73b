// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/repository/people/password.h"

#include <array>
#include <cstddef>

#include <sodium.h>

#include "sim/core/contracts.h"
#include "sim/core/error.h"

namespace torsio {

namespace {

struct Limits {
  unsigned long long operations;
  std::size_t memory;
};

Limits limitsOf(PasswordCost cost) {
  switch (cost) {
    case PasswordCost::kTest:
      return {crypto_pwhash_OPSLIMIT_MIN, crypto_pwhash_MEMLIMIT_MIN};
    case PasswordCost::kInteractive:
      return {crypto_pwhash_OPSLIMIT_INTERACTIVE, crypto_pwhash_MEMLIMIT_INTERACTIVE};
    case PasswordCost::kModerate:
      break;
  }
  return {crypto_pwhash_OPSLIMIT_MODERATE, crypto_pwhash_MEMLIMIT_MODERATE};
}

}  // namespace

std::string hashPassword(const std::string& password, PasswordCost cost) {
  TORSIO_EXPECTS(sodium_init() >= 0);
  std::array<char, crypto_pwhash_STRBYTES> hash{};
  const Limits limits = limitsOf(cost);
  if (crypto_pwhash_str(hash.data(), password.data(), password.size(), limits.operations, limits.memory) !=
      0) {
    throw Error(ErrorCode::kInternal, Text::tr("not enough memory to protect the password"), "",
                Text::tr("Close other programs and try again"));
  }
  return hash.data();
}

bool passwordMatches(const std::string& hash, const std::string& password) {
  TORSIO_EXPECTS(sodium_init() >= 0);
  return crypto_pwhash_str_verify(hash.c_str(), password.data(), password.size()) == 0;
}

}  // namespace torsio
