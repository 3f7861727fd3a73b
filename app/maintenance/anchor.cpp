// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/maintenance/anchor.h"

#include <array>
#include <fstream>
#include <map>
#include <optional>
#include <sstream>
#include <system_error>

#include <sodium.h>

#include "db/connection/connection.h"
#include "db/migrations/migrations.h"
#include "db/repository/base/audit_repository.h"
#include "sim/base/contracts.h"
#include "sim/base/digest.h"
#include "sim/base/error.h"
#include "sim/base/file_io.h"
#include "sim/base/private_files.h"

namespace torsio {

namespace fs = std::filesystem;

namespace {

constexpr const char* kHeadWord = "torsio-head";
constexpr const char* kKeyWord = "torsio-anchor-key";
constexpr const char* kNone = "-";

using PublicKey = std::array<std::uint8_t, crypto_sign_PUBLICKEYBYTES>;
using SecretKey = std::array<std::uint8_t, crypto_sign_SECRETKEYBYTES>;
using Signature = std::array<std::uint8_t, crypto_sign_BYTES>;

struct Head {
  std::int64_t length = 0;
  std::string hash{};
  std::int64_t utc_us = 0;
  std::string publicKey = kNone;
  std::string signature = kNone;

  [[nodiscard]] std::string signedText() const {
    return std::string(kHeadWord) + " 1 " + std::to_string(length) + " " + hash + " " +
           std::to_string(utc_us);
  }
  [[nodiscard]] std::string line() const { return signedText() + " " + publicKey + " " + signature; }
};

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

SecretKey readKey(const fs::path& file) {
  TORSIO_EXPECTS(sodium_init() >= 0);
  std::istringstream words(readFile(file));
  std::string word;
  std::string version;
  std::string hex;
  words >> word >> version >> hex;
  const std::optional<SecretKey> key = bytesOf<SecretKey>(hex);
  if (word != kKeyWord || version != "1" || !key) {
    throw Error(ErrorCode::kBadData, Text::tr("is no key of Torsio"), file.string(),
                Text::tr("Make one with torsio audit key FILE"));
  }
  if (makePrivate(file)) {
    throw Error(ErrorCode::kPermission,
                Text::tr("other accounts of this computer could read this key until now"), file.string(),
                Text::tr("Make a new key, and keep this one only to check older heads"));
  }
  return *key;
}

std::string publicOf(const SecretKey& key) {
  PublicKey open{};
  crypto_sign_ed25519_sk_to_pk(open.data(), key.data());
  return toHex(open);
}

Head headOf(const std::string& line) {
  std::istringstream words(line);
  std::string word;
  std::string version;
  Head head;
  words >> word >> version >> head.length >> head.hash >> head.utc_us >> head.publicKey >> head.signature;
  if (!words || word != kHeadWord || version != "1") {
    throw Error(ErrorCode::kBadData, Text::tr("is no head of an audit trail"), line.substr(0, 80),
                Text::tr("Give a line that torsio audit head printed"));
  }
  return head;
}

/// Empty: signed by that key.
std::string flawOfSignature(const Head& head, const std::string& publicKey) {
  if (publicKey.empty()) {
    return {};
  }
  const auto key = bytesOf<PublicKey>(publicKey);
  const auto signature = bytesOf<Signature>(head.signature);
  const std::string text = head.signedText();
  if (head.publicKey != publicKey) {
    return "the head is not signed by this key";
  }
  const bool genuine =
      key && signature &&
      crypto_sign_verify_detached(signature->data(), bytesOfText(text), text.size(), key->data()) == 0;
  return genuine ? std::string() : "the signature of the head is not genuine";
}

}  // namespace

std::string makeAnchorKey(const fs::path& file) {
  TORSIO_EXPECTS(sodium_init() >= 0);
  std::error_code ignored;
  if (fs::exists(fs::symlink_status(file, ignored))) {
    throw Error(ErrorCode::kFileUnwritable, Text::tr("exists already"), file.string(),
                Text::tr("Name a new file: an older key is needed to check older heads"));
  }
  PublicKey open{};
  SecretKey secret{};
  crypto_sign_keypair(open.data(), secret.data());
  writeFileAtomically(file, std::string(kKeyWord) + " 1 " + toHex(secret) + "\n");
  makePrivate(file);
  return toHex(open);
}

std::string publicAnchorKey(const fs::path& file) {
  return publicOf(readKey(file));
}

std::string anchoredHead(const std::string& locator, const fs::path& key, std::int64_t now_us) {
  Connection connection = openRecord(locator, OpenMode::kReadOnly);
  return anchoredHead(connection, key, now_us);
}

std::string anchoredHead(Connection& connection, const fs::path& key, std::int64_t now_us) {
  const TrailHead newest = AuditRepository(connection).head();
  Head head{.length = newest.length, .hash = newest.length == 0 ? kNone : newest.hash, .utc_us = now_us};
  if (!key.empty()) {
    const SecretKey secret = readKey(key);
    const std::string text = head.signedText();
    Signature signature{};
    crypto_sign_detached(signature.data(), nullptr, bytesOfText(text), text.size(), secret.data());
    head.publicKey = publicOf(secret);
    head.signature = toHex(signature);
  }
  return head.line();
}

void appendToWitness(const fs::path& witness, const std::string& head) {
  requireNoDatabase(witness);
  std::ofstream out(witness, std::ios::binary | std::ios::app);
  out << head << '\n';
  out.close();
  if (!out) {
    throw Error(ErrorCode::kFileUnwritable, Text::tr("cannot be written"), witness.string(),
                Text::tr("Choose a folder in which you may write"));
  }
}

std::vector<AuditFinding> compareWithHeads(const std::string& locator, const std::vector<std::string>& heads,
                                           const std::string& publicKey) {
  TORSIO_EXPECTS(sodium_init() >= 0);
  std::vector<Head> kept;
  std::map<std::int64_t, std::string> hashes;  // of the entries that a head names; empty: not there
  std::string key = publicKey;
  for (const std::string& line : heads) {
    kept.push_back(headOf(line));
    hashes[kept.back().length];
    if (key.empty() && kept.back().publicKey != kNone) {
      key = kept.back().publicKey;
    }
  }
  Connection connection = openRecord(locator, OpenMode::kReadOnly);
  AuditRepository(connection).forEach([&hashes](const AuditEntry& entry) {
    if (const auto wanted = hashes.find(entry.sequence); wanted != hashes.end()) {
      wanted->second = entry.entryHash;
    }
  });
  std::vector<AuditFinding> findings;
  for (const Head& head : kept) {
    const auto report = [&](const std::string& what) {
      findings.push_back({head.length, "head", head.hash.substr(0, 16), what});
    };
    if (const std::string flaw = flawOfSignature(head, key); !flaw.empty()) {
      report(flaw);
      continue;
    }
    const std::string& present = hashes.at(head.length);
    if (head.length > 0 && present.empty()) {
      report(
          "the audit trail had this entry, and has it no more: it was cut off, or an older file lies here");
    } else if (head.length > 0 && present != head.hash) {
      report("the audit trail was rewritten at this entry or before it");
    }
  }
  return findings;
}

std::vector<std::string> headsOf(const fs::path& witness) {
  std::istringstream in(readFile(witness));
  std::vector<std::string> heads;
  for (std::string line; std::getline(in, line);) {
    if (!line.empty()) {
      heads.push_back(line);
    }
  }
  if (heads.empty()) {
    throw Error(ErrorCode::kBadData, Text::tr("holds no head of an audit trail"), witness.string(),
                Text::tr("Choose the file that torsio audit head --witness wrote"));
  }
  return heads;
}

}  // namespace torsio
