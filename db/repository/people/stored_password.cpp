// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/repository/people/stored_password.h"

#include <array>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include <sodium.h>

#include "db/connection/connection.h"
#include "db/connection/row_reader.h"
#include "sim/core/contracts.h"
#include "sim/core/digest.h"
#include "sim/core/error.h"

namespace torsio {

namespace {

constexpr std::string_view kHidden = "server1$";
constexpr std::string_view kArgon = "$argon2id$";

struct Limits {
  unsigned long long operations;
  std::size_t memory;
};

Limits limitsOf(PasswordCost cost) {
  constexpr unsigned long long kPasses = 3;
  constexpr std::size_t kMemory_bytes = 64U << 20U;
  return cost == PasswordCost::kTest ? Limits{crypto_pwhash_OPSLIMIT_MIN, crypto_pwhash_MEMLIMIT_MIN}
                                     : Limits{kPasses, kMemory_bytes};
}

[[noreturn]] void refuseWithoutMemory() {
  throw Error(ErrorCode::kInternal, Text::tr("not enough memory to protect the password"), "",
              Text::tr("Close other programs and try again"));
}

/// "$argon2id$v=19$m=65536,t=2,p=1$SALT" of a stored password; empty: it has another form.
std::string recipeOf(const std::string& stored) {
  const std::size_t from = stored.find(kArgon);
  if (from == std::string::npos) {
    return {};
  }
  return isHiddenPassword(stored) ? stored.substr(from) : stored.substr(from, stored.rfind('$') - from);
}

/// The number behind `name` in a recipe; 0 if there is none.
unsigned long long numberIn(const std::string& recipe, std::string_view name) {
  const std::size_t at = recipe.find(name);
  unsigned long long number = 0;
  if (at != std::string::npos) {
    std::from_chars(recipe.data() + at + name.size(), recipe.data() + recipe.size(), number);
  }
  return number;
}

std::string sha256(const std::string& text) {
  std::array<unsigned char, crypto_hash_sha256_BYTES> hash{};
  crypto_hash_sha256(hash.data(), reinterpret_cast<const unsigned char*>(text.data()), text.size());
  return toHex(hash);
}

}  // namespace

std::string hashPassword(const std::string& password, PasswordCost cost) {
  TORSIO_EXPECTS(sodium_init() >= 0);
  std::array<char, crypto_pwhash_STRBYTES> hash{};
  const Limits limits = limitsOf(cost);
  if (crypto_pwhash_str(hash.data(), password.data(), password.size(), limits.operations, limits.memory) !=
      0) {
    refuseWithoutMemory();
  }
  return hash.data();
}

std::string hashLike(const std::string& stored, const std::string& password) {
  TORSIO_EXPECTS(sodium_init() >= 0);
  constexpr std::size_t kKiB = 1024;
  const std::string recipe = recipeOf(stored);
  const std::string salt64 = recipe.substr(recipe.rfind('$') + 1);
  std::array<unsigned char, crypto_pwhash_SALTBYTES> salt{};
  std::size_t length = 0;
  if (recipe.empty() ||
      sodium_base642bin(salt.data(), salt.size(), salt64.data(), salt64.size(), nullptr, &length, nullptr,
                        sodium_base64_VARIANT_ORIGINAL_NO_PADDING) != 0 ||
      length != salt.size()) {
    return {};
  }
  std::array<unsigned char, 32> key{};  // as long as in crypto_pwhash_str()
  if (crypto_pwhash(key.data(), key.size(), password.data(), password.size(), salt.data(),
                    numberIn(recipe, "t="), numberIn(recipe, "m=") * kKiB,
                    crypto_pwhash_ALG_ARGON2ID13) != 0) {
    refuseWithoutMemory();
  }
  std::array<char, sodium_base64_ENCODED_LEN(32, sodium_base64_VARIANT_ORIGINAL_NO_PADDING)> text{};
  sodium_bin2base64(text.data(), text.size(), key.data(), key.size(),
                    sodium_base64_VARIANT_ORIGINAL_NO_PADDING);
  return recipe + "$" + text.data();
}

std::string keptOfProof(const std::string& proof) {
  return std::string(kKeptProof) + sha256(proof);  // kept_of_proof() of a server
}

bool isHiddenPassword(const std::string& stored) {
  return stored.starts_with(kHidden);
}

bool passwordMatches(Connection& connection, const std::string& stored, const std::string& password) {
  TORSIO_EXPECTS(sodium_init() >= 0);
  if (!isHiddenPassword(stored)) {
    return crypto_pwhash_str_verify(stored.c_str(), password.data(), password.size()) == 0;
  }
  // peppered() of a server, see server_functions.cpp.
  const std::string pepper =
      selectFirst(connection, "SELECT pepper FROM password_pepper", {}, readText).value_or("");
  const std::size_t nonce = kHidden.size();
  const std::size_t code = stored.find('$', nonce) + 1;
  const std::string hash = hashLike(stored, password);
  const std::string fits = sha256(pepper + sha256(pepper + stored.substr(nonce, code - 1 - nonce) + hash));
  return !hash.empty() && !pepper.empty() && stored.compare(code, fits.size() + 1, fits + "$") == 0;
}

bool isPrepared(Connection& connection) {
  return connection.engine() == Engine::kPostgresql &&
         selectFirst(connection,
                     "SELECT count(*) FROM pg_proc WHERE pronamespace = current_schema()::text::regnamespace"
                     " AND proname = 'open_session'",
                     {}, readInt64)
                 .value_or(0) > 0;
}

std::string hiddenPassword(Connection& connection, const std::string& hash) {
  if (!hash.starts_with(kArgon) || !isPrepared(connection)) {
    return hash;
  }
  return selectFirst(connection, "SELECT sealed_secret(?)", {hash}, readText).value_or(hash);
}

}  // namespace torsio
