// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/maintenance/anchor.h"

#include <algorithm>
#include <fstream>
#include <map>
#include <optional>
#include <sstream>
#include <string_view>
#include <system_error>

#include "app/services/access/audit_service.h"
#include "app/services/maintenance/signing_key.h"
#include "app/services/maintenance/stamped_heads.h"
#include "db/connection/connection.h"
#include "db/migrations/migrations.h"
#include "db/repository/base/audit_repository.h"
#include "sim/core/error.h"
#include "sim/core/file_io.h"
#include "sim/core/plain_text.h"

namespace torsio {

namespace fs = std::filesystem;

namespace {

constexpr const char* kNone = "-";

using Head = AnchoredHead;

std::string signedText(const Head& head) {
  return headWords(head.length, head.hash, head.utc_us);
}

[[noreturn]] void notReadable(const std::string& line) {
  refuse(Text::tr("is not the checkpoint of an audit trail"), plainLine(line, 80),
         Text::tr("Give a line that torsio audit head printed"));
}

/// Returns whether a line is complete.
bool isWhole(const std::string& line) {
  if (isReplacementLine(line)) {
    const auto made = replacementOf(line);
    return made && isSignature(made->signatureOfFresh);
  }
  if (isStampLine(line)) {
    return isWholeStamp(line);
  }
  try {
    const Head head = readHead(line);
    return !head.isSigned() || isSignature(head.signature);
  } catch (const Error&) {
    return false;
  }
}

/// Returns what follows the last complete line, left by a killed program or a full disk.
std::string cutOffEnd(const std::string& kept) {
  const std::size_t last = kept.rfind('\n');
  std::string end = last == std::string::npos ? kept : kept.substr(last + 1);
  const auto begins = [&end](std::string_view word) {
    return end.starts_with(word) || word.starts_with(end);
  };
  const bool ours =
      begins(kHeadWord) || begins(kReplacedWord) || begins(kStampWord);  // leave anything else alone
  return !ours || isWhole(end) ? std::string() : end;
}

/// Returns the replacement of `old` that an earlier call wrote with the key in `file`. Empty if the file is
/// missing or contains something else.
std::optional<KeyReplacement> replacementIn(const fs::path& file, const std::string& old) {
  std::error_code ignored;
  if (!fs::is_regular_file(file, ignored)) {
    return std::nullopt;
  }
  for (const KeyReplacement& made : replacementsIn(file)) {
    if (made.old == old && made.fresh == publicOf(readKey(file))) {
      return made;
    }
  }
  return std::nullopt;
}

/// Returns whether the witness file contains the line.
bool keeps(const fs::path& witness, const std::string& line) {
  std::error_code ignored;
  if (!fs::is_regular_file(witness, ignored)) {
    return false;
  }
  return readKept(witness).find(line + "\n") != std::string::npos;
}

/// Throws Error{kFileUnwritable} unless lines may be appended: to a new or empty file, or to one that begins
/// with such a line. A link could lead anywhere.
void requireWitness(const fs::path& witness, const std::string& kept) {
  const auto refuseFile = [&witness](const Text& what) {
    throw Error(ErrorCode::kFileUnwritable, what, witness.string(),
                Text::tr("Name a new file, or one that torsio audit head --witness wrote"));
  };
  std::error_code ignored;
  if (fs::is_symlink(fs::symlink_status(witness, ignored))) {
    refuseFile(Text::tr("is a link: checkpoints are never written through one"));
  }
  const std::string first = kept.substr(0, kept.find('\n'));
  if (!kept.empty() && !isWhole(first) && cutOffEnd(kept) != kept) {
    refuseFile(Text::tr("is no file of checkpoints: nothing was written to it"));
  }
}

/// Lines kept elsewhere, sorted by kind.
struct KeptLines {
  std::vector<Head> heads;
  std::vector<KeyReplacement> replacements;  ///< both signatures valid
  std::vector<KeyReplacement> forged;
  std::string firstKey;  ///< that signed a head
};

KeptLines sorted(const std::vector<std::string>& lines) {
  KeptLines kept;
  for (const std::string& line : lines) {
    if (isReplacementLine(line)) {
      std::optional<KeyReplacement> made = replacementOf(line);
      if (!made) {
        notReadable(line);
      }
      (made->isGenuine() ? kept.replacements : kept.forged).push_back(*std::move(made));
      continue;
    }
    if (isStampLine(line)) {
      continue;  // judgeHeads()
    }
    kept.heads.push_back(readHead(line));
    if (kept.firstKey.empty() && kept.heads.back().publicKey != kNone) {
      kept.firstKey = kept.heads.back().publicKey;
    }
  }
  return kept;
}

/// Returns empty if the trail still contains the head's entry.
std::string flawOfTrail(const Head& head, const std::map<std::int64_t, std::string>& hashes) {
  if (head.length == 0) {
    return {};
  }
  const std::string& present = hashes.at(head.length);
  if (present.empty()) {
    return "the audit trail no longer has this entry: it was truncated, or this is an older file";
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
  const std::optional<KeyReplacement> begun = replacementIn(file, publicOf(before));
  if (!begun) {
    requireNewKeyFile(file);
  }
  if (begun && keeps(witness, begun->line())) {
    return {.publicKey = begun->fresh, .line = begun->line()};
  }
  const SecretKey secret = begun ? readKey(file) : drawKey();
  KeyReplacement made{.old = publicOf(before),
                      .fresh = publicOf(secret),
                      .length = AuditRepository(connection).head().length,
                      .utc_us = now_us};
  made.signatureOfOld = signedWith(before, made.signedText());
  made.signatureOfFresh = signedWith(secret, made.signedText());
  writeKey(file, secret, made.line());  // first, so that a later call can resume after an interruption
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
    refuseUnwritable(witness);  // opening a pipe would wait for a reader
  }
  const std::string kept = fs::exists(witness, ignored) ? readKept(witness) : std::string();
  requireWitness(witness, kept);
  const std::uintmax_t before = kept.size() - cutOffEnd(kept).size();
  if (before < kept.size()) {
    fs::resize_file(witness, before, ignored);
  }
  std::string line = head + "\n";
  if (before > 0 && kept[before - 1] != '\n') {
    line.insert(0, 1, '\n');  // somebody removed the last line end
  }
  std::ofstream out(witness, std::ios::binary | std::ios::app);
  out << line;
  out.close();
  if (!out) {
    if (fs::is_regular_file(witness, ignored)) {
      fs::resize_file(witness, before, ignored);  // remove a partial line if the disk is full
    }
    refuseUnwritable(witness);
  }
}

std::vector<AuditFinding> compareWithHeads(Connection& connection, const std::vector<std::string>& lines,
                                           const std::string& publicKey) {
  const KeptLines kept = sorted(lines);
  const TrustedKeys keys(publicKey.empty() ? kept.firstKey : publicKey, kept.replacements,
                         &KeyReplacement::length);
  std::map<std::int64_t, std::string> hashes;  // of the entries that heads refer to; empty: not found
  for (const Head& head : kept.heads) {
    hashes[head.length];
  }
  AuditRepository(connection).forEach([&hashes](const AuditEntry& entry) {
    if (const auto wanted = hashes.find(entry.sequence); wanted != hashes.end()) {
      wanted->second = entry.entryHash;
    }
  });
  const auto flawOf = [&keys](const Head& head) {
    return keys.flawOf(signedText(head), head.signature, head.publicKey, head.length);
  };
  std::int64_t vouchedFor = -1;  // greatest length confirmed by a signed head
  for (const Head& head : kept.heads) {
    if (keys.asksForSignatures() && flawOf(head).empty() && flawOfTrail(head, hashes).empty()) {
      vouchedFor = std::max(vouchedFor, head.length);
    }
  }
  std::vector<AuditFinding> findings;
  for (const Head& head : kept.heads) {
    const bool vouched = head.publicKey == kNone && head.length <= vouchedFor;
    std::string flaw = keys.asksForSignatures() && !vouched ? flawOf(head) : std::string();
    if (flaw.empty()) {
      flaw = flawOfTrail(head, hashes);
    }
    if (!flaw.empty()) {
      findings.push_back({head.length, "head", head.hash.substr(0, 16), flaw});
    }
  }
  for (const KeyReplacement& forged : kept.forged) {
    findings.push_back({forged.length, "head", forged.fresh.substr(0, 16),
                        "the line that puts this key in the place of another is not genuine"});
  }
  return findings;
}

std::vector<std::string> headsOf(const fs::path& witness) {
  std::string kept = readKept(witness);
  kept.resize(kept.size() - cutOffEnd(kept).size());
  std::istringstream in(kept);
  std::vector<std::string> heads;
  for (std::string line; std::getline(in, line);) {
    if (!line.empty()) {
      heads.push_back(line);
    }
  }
  if (heads.empty()) {
    refuse(Text::tr("contains no checkpoint of an audit trail"), witness.string(),
           Text::tr("Choose the file that torsio audit head --witness wrote"));
  }
  return heads;
}

}  // namespace torsio
