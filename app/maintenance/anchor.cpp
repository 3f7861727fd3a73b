// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/maintenance/anchor.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <limits>
#include <map>
#include <optional>
#include <sstream>
#include <string_view>
#include <system_error>

#include <sodium.h>

#include "app/access/audit_service.h"
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
constexpr const char* kReplacedWord = "torsio-key";
constexpr const char* kNone = "-";

using PublicKey = std::array<std::uint8_t, crypto_sign_PUBLICKEYBYTES>;
using SecretKey = std::array<std::uint8_t, crypto_sign_SECRETKEYBYTES>;
using Signature = std::array<std::uint8_t, crypto_sign_BYTES>;

using Head = AnchoredHead;

std::string signedText(const Head& head) {
  return headWords(head.length, head.hash, head.utc_us);
}

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

[[noreturn]] void notReadable(const std::string& line) {
  throw Error(ErrorCode::kBadData, Text::tr("is no head of an audit trail"), line.substr(0, 80),
              Text::tr("Give a line that torsio audit head printed"));
}

/// One key in the place of another, from some length of the trail on.
struct Replacement {
  std::string old{};
  std::string fresh{};
  std::int64_t length = 0;
  std::int64_t utc_us = 0;
  std::string signatureOfOld{};
  std::string signatureOfFresh{};

  [[nodiscard]] std::string signedText() const {
    return std::string(kReplacedWord) + " 1 " + old + " " + fresh + " " + std::to_string(length) + " " +
           std::to_string(utc_us);
  }
  [[nodiscard]] std::string line() const {
    return signedText() + " " + signatureOfOld + " " + signatureOfFresh;
  }
};

Replacement replacementOf(const std::string& line) {
  std::istringstream words(line);
  std::string word;
  std::string version;
  Replacement made;
  words >> word >> version >> made.old >> made.fresh >> made.length >> made.utc_us >> made.signatureOfOld >>
      made.signatureOfFresh;
  if (!words || version != "1") {
    notReadable(line);
  }
  return made;
}

std::string signedWith(const SecretKey& key, const std::string& text) {
  Signature signature{};
  crypto_sign_detached(signature.data(), nullptr, bytesOfText(text), text.size(), key.data());
  return toHex(signature);
}

bool genuine(const std::string& text, const std::string& signedBy, const std::string& publicKey) {
  const auto key = bytesOf<PublicKey>(publicKey);
  const auto signature = bytesOf<Signature>(signedBy);
  return key && signature &&
         crypto_sign_verify_detached(signature->data(), bytesOfText(text), text.size(), key->data()) == 0;
}

void requireNewKeyFile(const fs::path& file) {
  std::error_code ignored;
  if (fs::exists(fs::symlink_status(file, ignored))) {
    throw Error(ErrorCode::kFileUnwritable, Text::tr("exists already"), file.string(),
                Text::tr("Name a new file: an older key is needed to check older heads"));
  }
}

SecretKey drawKey() {
  TORSIO_EXPECTS(sodium_init() >= 0);
  PublicKey open{};
  SecretKey secret{};
  crypto_sign_keypair(open.data(), secret.data());
  return secret;
}

/// A key, and the line by which it takes the place of another, if it does.
void writeKey(const fs::path& file, const SecretKey& secret, const std::string& replacement) {
  writeFileAtomically(file, std::string(kKeyWord) + " 1 " + toHex(secret) + "\n" +
                                (replacement.empty() ? "" : replacement + "\n"));
  makePrivate(file);
}

/// The replacement of `old` that an earlier call wrote with the key in `file`. None: the file is not there,
/// or something else.
std::optional<Replacement> replacementIn(const fs::path& file, const std::string& old) {
  std::error_code ignored;
  if (!fs::is_regular_file(file, ignored)) {
    return std::nullopt;
  }
  std::istringstream in(readFile(file));
  std::string line;
  while (std::getline(in, line) && !line.starts_with(std::string(kReplacedWord) + " ")) {
  }
  if (!in) {
    return std::nullopt;
  }
  Replacement made = replacementOf(line);
  const bool sound = made.old == old && made.fresh == publicOf(readKey(file)) &&
                     genuine(made.signedText(), made.signatureOfOld, made.old) &&
                     genuine(made.signedText(), made.signatureOfFresh, made.fresh);
  return sound ? std::optional(std::move(made)) : std::nullopt;
}

/// Whether nothing of a line that can be kept was cut off.
bool isWhole(const std::string& line) {
  const auto hex = [](const std::string& word, std::size_t bytes) { return word.size() == 2 * bytes; };
  try {
    if (line.starts_with(std::string(kReplacedWord) + " ")) {
      return hex(replacementOf(line).signatureOfFresh, crypto_sign_BYTES);
    }
    const Head head = readHead(line);
    return !head.isSigned() || hex(head.signature, crypto_sign_BYTES);
  } catch (const Error&) {
    return false;
  }
}

/// What a program that was killed, or a disk that was full, left of a line behind the last whole one.
std::string cutOffEnd(const std::string& kept) {
  const std::size_t last = kept.rfind('\n');
  std::string end = last == std::string::npos ? kept : kept.substr(last + 1);
  const auto begins = [&end](std::string_view word) {
    return end.starts_with(word) || word.starts_with(end);
  };
  const bool ours = begins(kHeadWord) || begins(kReplacedWord);  // whatever else lies there stays
  return !ours || isWhole(end) ? std::string() : end;
}

/// Whether the witness file has the line.
bool keeps(const fs::path& witness, const std::string& line) {
  std::error_code ignored;
  if (!fs::is_regular_file(witness, ignored)) {
    return false;
  }
  return readFile(witness).find(line + "\n") != std::string::npos;
}

/// Keys whose heads count, each for the lengths of the trail in its time.
class TrustedKeys {
 public:
  /// `root` empty: no signature is asked for.
  TrustedKeys(const std::string& root, const std::vector<Replacement>& replacements) {
    if (root.empty()) {
      return;
    }
    times_[root] = {};
    for (std::string later = root; const Replacement* next = from(replacements, &Replacement::old, later);) {
      times_[later].last = next->length;
      later = next->fresh;
      if (!times_.try_emplace(later, Time{.first = next->length}).second) {
        break;
      }
    }
    for (std::string older = root;
         const Replacement* next = from(replacements, &Replacement::fresh, older);) {
      older = next->old;
      if (!times_.try_emplace(older, Time{.last = next->length}).second) {
        break;
      }
    }
  }
  [[nodiscard]] bool asksForSignatures() const { return !times_.empty(); }
  /// Empty: signed by a key of its time.
  [[nodiscard]] std::string flawOf(const Head& head) const {
    const auto found = times_.find(head.publicKey);
    if (found == times_.end()) {
      return "the head is not signed by this key";
    }
    if (!genuine(signedText(head), head.signature, head.publicKey)) {
      return "the signature of the head is not genuine";
    }
    const bool inTime = head.length >= found->second.first && head.length <= found->second.last;
    return inTime ? std::string() : "the head is signed by a key that was not in use at its time";
  }

 private:
  struct Time {
    std::int64_t first = 0;
    std::int64_t last = std::numeric_limits<std::int64_t>::max();
  };

  static const Replacement* from(const std::vector<Replacement>& replacements, std::string Replacement::*side,
                                 const std::string& key) {
    const auto found = std::find_if(replacements.begin(), replacements.end(),
                                    [&](const Replacement& one) { return one.*side == key; });
    return found == replacements.end() ? nullptr : &*found;
  }

  std::map<std::string, Time> times_;
};

/// What was kept elsewhere, sorted.
struct KeptLines {
  std::vector<Head> heads;
  std::vector<Replacement> replacements;  ///< both signatures genuine
  std::vector<Replacement> forged;
  std::string firstKey;  ///< that signed a head
};

KeptLines sorted(const std::vector<std::string>& lines) {
  KeptLines kept;
  for (const std::string& line : lines) {
    if (line.starts_with(std::string(kReplacedWord) + " ")) {
      Replacement made = replacementOf(line);
      const bool sound = genuine(made.signedText(), made.signatureOfOld, made.old) &&
                         genuine(made.signedText(), made.signatureOfFresh, made.fresh);
      (sound ? kept.replacements : kept.forged).push_back(std::move(made));
      continue;
    }
    kept.heads.push_back(readHead(line));
    if (kept.firstKey.empty() && kept.heads.back().publicKey != kNone) {
      kept.firstKey = kept.heads.back().publicKey;
    }
  }
  return kept;
}

/// Empty: the trail has the head's entry as it was.
std::string flawOfTrail(const Head& head, const std::map<std::int64_t, std::string>& hashes) {
  if (head.length == 0) {
    return {};
  }
  const std::string& present = hashes.at(head.length);
  if (present.empty()) {
    return "the audit trail had this entry, and has it no more: it was cut off, or an older file lies here";
  }
  return present == head.hash ? std::string() : "the audit trail was rewritten at this entry or before it";
}

}  // namespace

std::string makeAnchorKey(const fs::path& file) {
  requireNewKeyFile(file);
  const SecretKey secret = drawKey();
  writeKey(file, secret, {});
  return publicOf(secret);
}

ReplacedKey replaceAnchorKey(const std::string& locator, const fs::path& old, const fs::path& file,
                             const fs::path& witness, std::int64_t now_us) {
  Connection connection = openRecord(locator, OpenMode::kReadOnly);
  return replaceAnchorKey(connection, old, file, witness, now_us);
}

ReplacedKey replaceAnchorKey(Connection& connection, const fs::path& old, const fs::path& file,
                             const fs::path& witness, std::int64_t now_us) {
  const SecretKey before = readKey(old);
  const std::optional<Replacement> begun = replacementIn(file, publicOf(before));
  if (!begun) {
    requireNewKeyFile(file);
  }
  if (begun && keeps(witness, begun->line())) {
    return {.publicKey = begun->fresh, .line = begun->line()};
  }
  const SecretKey secret = begun ? readKey(file) : drawKey();
  Replacement made{.old = publicOf(before),
                   .fresh = publicOf(secret),
                   .length = AuditRepository(connection).head().length,
                   .utc_us = now_us};
  made.signatureOfOld = signedWith(before, made.signedText());
  made.signatureOfFresh = signedWith(secret, made.signedText());
  writeKey(file, secret, made.line());  // first: a call that ends here is taken up again by the next
  if (!witness.empty()) {
    appendToWitness(witness, made.line());
  }
  return {.publicKey = made.fresh, .line = made.line()};
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
    head.publicKey = publicOf(secret);
    head.signature = signedWith(secret, signedText(head));
  }
  return signedText(head) + " " + head.publicKey + " " + head.signature;
}

AnchoredHead readHead(const std::string& line) {
  std::istringstream words(line);
  std::string word;
  std::string version;
  Head head;
  words >> word >> version >> head.length >> head.hash >> head.utc_us >> head.publicKey >> head.signature;
  if (!words || word != kHeadWord || version != "1") {
    notReadable(line);
  }
  return head;
}

void appendToWitness(const fs::path& witness, const std::string& head) {
  requireNoDatabase(witness);
  std::error_code ignored;
  if (const fs::file_status there = fs::status(witness, ignored);
      fs::exists(there) && !fs::is_regular_file(there)) {
    refuseUnwritable(witness);  // a pipe would wait for somebody who reads
  }
  const std::string kept = fs::exists(witness, ignored) ? readFile(witness) : std::string();
  const std::uintmax_t before = kept.size() - cutOffEnd(kept).size();
  if (before < kept.size()) {
    fs::resize_file(witness, before, ignored);
  }
  std::string line = head + "\n";
  if (before > 0 && kept[before - 1] != '\n') {
    line.insert(0, 1, '\n');  // somebody took the last end of a line away
  }
  std::ofstream out(witness, std::ios::binary | std::ios::app);
  out << line;
  out.close();
  if (!out) {
    if (fs::is_regular_file(witness, ignored)) {
      fs::resize_file(witness, before, ignored);  // a full disk takes the first half of a line
    }
    refuseUnwritable(witness);
  }
}

std::vector<AuditFinding> compareWithHeads(const std::string& locator, const std::vector<std::string>& lines,
                                           const std::string& publicKey) {
  Connection connection = openRecord(locator, OpenMode::kReadOnly);
  return compareWithHeads(connection, lines, publicKey);
}

std::vector<AuditFinding> compareWithHeads(Connection& connection, const std::vector<std::string>& lines,
                                           const std::string& publicKey) {
  TORSIO_EXPECTS(sodium_init() >= 0);
  const KeptLines kept = sorted(lines);
  const TrustedKeys keys(publicKey.empty() ? kept.firstKey : publicKey, kept.replacements);
  std::map<std::int64_t, std::string> hashes;  // of the entries that a head names; empty: not there
  for (const Head& head : kept.heads) {
    hashes[head.length];
  }
  AuditRepository(connection).forEach([&hashes](const AuditEntry& entry) {
    if (const auto wanted = hashes.find(entry.sequence); wanted != hashes.end()) {
      wanted->second = entry.entryHash;
    }
  });
  std::int64_t vouchedFor = -1;  // the longest trail that a signed head fits
  for (const Head& head : kept.heads) {
    if (keys.asksForSignatures() && keys.flawOf(head).empty() && flawOfTrail(head, hashes).empty()) {
      vouchedFor = std::max(vouchedFor, head.length);
    }
  }
  std::vector<AuditFinding> findings;
  for (const Head& head : kept.heads) {
    const bool vouched = head.publicKey == kNone && head.length <= vouchedFor;
    std::string flaw = keys.asksForSignatures() && !vouched ? keys.flawOf(head) : std::string();
    if (flaw.empty()) {
      flaw = flawOfTrail(head, hashes);
    }
    if (!flaw.empty()) {
      findings.push_back({head.length, "head", head.hash.substr(0, 16), flaw});
    }
  }
  for (const Replacement& forged : kept.forged) {
    findings.push_back({forged.length, "head", forged.fresh.substr(0, 16),
                        "the line that puts this key in the place of another is not genuine"});
  }
  return findings;
}

std::vector<std::string> headsOf(const fs::path& witness) {
  std::string kept = readFile(witness);
  kept.resize(kept.size() - cutOffEnd(kept).size());
  std::istringstream in(kept);
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
