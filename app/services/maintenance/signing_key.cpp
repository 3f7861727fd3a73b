// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/maintenance/signing_key.h"

#include <algorithm>
#include <sstream>
#include <system_error>
#include <utility>

#include <sodium.h>

#include "sim/core/contracts.h"
#include "sim/core/digest.h"
#include "sim/core/error.h"
#include "sim/core/file_io.h"

namespace torsio {

namespace fs = std::filesystem;

namespace {

constexpr const char* kKeyWord = "torsio-anchor-key";

using PublicKey = std::array<std::uint8_t, crypto_sign_PUBLICKEYBYTES>;
using SignatureBytes = std::array<std::uint8_t, crypto_sign_BYTES>;
static_assert(sizeof(SecretKey) == crypto_sign_SECRETKEYBYTES);

template <typename Bytes>
std::optional<Bytes> bytesOf(const std::string& hex) {
  Bytes bytes{};
  std::size_t length = 0;
  const bool sound =
      hex.size() == 2 * bytes.size() &&
      sodium_hex2bin(bytes.data(), bytes.size(), hex.data(), hex.size(), nullptr, &length, nullptr) == 0 &&
      length == bytes.size();
  return sound ? std::optional(bytes) : std::nullopt;
}

const std::uint8_t* bytesOfText(const std::string& text) {
  return reinterpret_cast<const std::uint8_t*>(text.data());
}

const KeyReplacement* replacementFrom(const std::vector<KeyReplacement>& replacements,
                                      std::string KeyReplacement::*side, const std::string& key) {
  const auto found = std::find_if(replacements.begin(), replacements.end(),
                                  [&](const KeyReplacement& one) { return one.*side == key; });
  return found == replacements.end() ? nullptr : &*found;
}

}  // namespace

SecretKey drawKey() {
  TORSIO_EXPECTS(sodium_init() >= 0);
  PublicKey open{};
  SecretKey secret{};
  crypto_sign_keypair(open.data(), secret.data());
  return secret;
}

SecretKey readKey(const fs::path& file) {
  TORSIO_EXPECTS(sodium_init() >= 0);
  std::istringstream words(readKept(file));
  std::string word;
  std::string version;
  std::string hex;
  words >> word >> version >> hex;
  const std::optional<SecretKey> key = bytesOf<SecretKey>(hex);
  if (word != kKeyWord || version != "1" || !key) {
    refuse(Text::tr("is not a key of Torsio"), file.string(),
           Text::tr("Make one with torsio audit key FILE"));
  }
  if (makePrivate(file)) {
    throw Error(ErrorCode::kPermission,
                Text::tr("other accounts of this computer could read this key until now"), file.string(),
                Text::tr("Make a new key, and keep this one only to check older checkpoints"));
  }
  return *key;
}

void writeKey(const fs::path& file, const SecretKey& secret, const std::string& replacement) {
  writeFileAtomically(file, std::string(kKeyWord) + " 1 " + toHex(secret) + "\n" +
                                (replacement.empty() ? "" : replacement + "\n"));
  makePrivate(file);
}

void requireNewKeyFile(const fs::path& file) {
  std::error_code ignored;
  if (fs::exists(fs::symlink_status(file, ignored))) {
    throw Error(ErrorCode::kFileUnwritable, Text::tr("exists already"), file.string(),
                Text::tr("Name a new file: an older key is needed to check older checkpoints"));
  }
}

std::string publicOf(const SecretKey& key) {
  PublicKey open{};
  crypto_sign_ed25519_sk_to_pk(open.data(), key.data());
  return toHex(open);
}

bool isPublicKey(const std::string& hex) {
  return bytesOf<PublicKey>(hex).has_value();
}

std::string signedWith(const SecretKey& key, const std::string& text) {
  SignatureBytes signature{};
  crypto_sign_detached(signature.data(), nullptr, bytesOfText(text), text.size(), key.data());
  return toHex(signature);
}

bool isSignature(const std::string& hex) {
  return bytesOf<SignatureBytes>(hex).has_value();
}

bool genuine(const std::string& text, const std::string& signature, const std::string& publicKey) {
  TORSIO_EXPECTS(sodium_init() >= 0);
  const auto key = bytesOf<PublicKey>(publicKey);
  const auto bytes = bytesOf<SignatureBytes>(signature);
  return key && bytes &&
         crypto_sign_verify_detached(bytes->data(), bytesOfText(text), text.size(), key->data()) == 0;
}

std::string KeyReplacement::signedText() const {
  return std::string(kReplacedWord) + " 1 " + old + " " + fresh + " " + std::to_string(length) + " " +
         std::to_string(utc_us);
}

std::string KeyReplacement::line() const {
  return signedText() + " " + signatureOfOld + " " + signatureOfFresh;
}

bool KeyReplacement::isGenuine() const {
  return genuine(signedText(), signatureOfOld, old) && genuine(signedText(), signatureOfFresh, fresh);
}

bool isReplacementLine(const std::string& line) {
  return line.starts_with(std::string(kReplacedWord) + " ");
}

std::optional<KeyReplacement> replacementOf(const std::string& line) {
  std::istringstream words(line);
  std::string word;
  std::string version;
  KeyReplacement made;
  words >> word >> version >> made.old >> made.fresh >> made.length >> made.utc_us >> made.signatureOfOld >>
      made.signatureOfFresh;
  const bool sound = words && word == kReplacedWord && version == "1";
  return sound ? std::optional(std::move(made)) : std::nullopt;
}

std::string readKept(const fs::path& file) {
  constexpr std::uintmax_t kLargest_bytes = 64UL * 1024UL * 1024UL;  // two centuries of heads
  std::error_code ignored;
  const fs::file_status there = fs::status(file, ignored);
  const auto refuseFile = [&file](const Text& what) {
    throw Error(ErrorCode::kFileUnreadable, what, file.string(),
                Text::tr("Choose the file that torsio audit wrote"));
  };
  if (fs::exists(there) && !fs::is_regular_file(there)) {
    refuseFile(Text::tr("is a pipe, a device or a folder: keys and checkpoints are kept in files"));
  }
  if (fs::exists(there) && fs::file_size(file, ignored) > kLargest_bytes) {
    refuseFile(Text::tr("is too large for a file of keys or checkpoints"));
  }
  return readFile(file);
}

std::vector<KeyReplacement> replacementsIn(const fs::path& file) {
  std::istringstream in(readKept(file));
  std::vector<KeyReplacement> found;
  for (std::string line; std::getline(in, line);) {
    std::optional<KeyReplacement> made = replacementOf(line);
    if (made && made->isGenuine()) {
      found.push_back(*std::move(made));
    }
  }
  return found;
}

TrustedKeys::TrustedKeys(const std::string& publicKey, const std::vector<KeyReplacement>& replacements,
                         std::int64_t KeyReplacement::*measure) {
  if (publicKey.empty()) {
    return;
  }
  const std::optional<PublicKey> bytes = bytesOf<PublicKey>(publicKey);
  const std::string root = bytes ? toHex(*bytes) : publicKey;  // accepts upper-case digits
  times_[root] = {};
  for (std::string later = root;
       const KeyReplacement* next = replacementFrom(replacements, &KeyReplacement::old, later);) {
    times_[later].last = next->*measure;
    later = next->fresh;
    if (!times_.try_emplace(later, Time{.first = next->*measure}).second) {
      break;
    }
  }
  for (std::string older = root;
       const KeyReplacement* next = replacementFrom(replacements, &KeyReplacement::fresh, older);) {
    older = next->old;
    if (!times_.try_emplace(older, Time{.last = next->*measure}).second) {
      break;
    }
  }
}

std::string TrustedKeys::flawOf(const std::string& text, const std::string& signature,
                                const std::string& publicKey, std::int64_t at) const {
  const auto found = times_.find(publicKey);
  if (found == times_.end()) {
    return "the checkpoint is not signed by this key";
  }
  if (!genuine(text, signature, publicKey)) {
    return "the signature of the checkpoint is not genuine";
  }
  const bool inTime = at >= found->second.first && at <= found->second.last;
  return inTime ? std::string() : "the checkpoint is signed by a key that was not in use at its time";
}

}  // namespace torsio
