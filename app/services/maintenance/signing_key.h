// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace torsio {

/// A centre's key (Ed25519 of libsodium) that signs heads of the audit trail and of allocations. In the
/// format of its file.
using SecretKey = std::array<std::uint8_t, 64>;

[[nodiscard]] SecretKey drawKey();
/// Throws Error: kFileMissing; kBadData if the file has no key; kPermission if other accounts could read it.
[[nodiscard]] SecretKey readKey(const std::filesystem::path& file);
/// Writes a key, and the line by which it replaces another one ("": it replaces none), readable only by its
/// owner. Throws Error (kFileUnwritable).
void writeKey(const std::filesystem::path& file, const SecretKey& secret, const std::string& replacement);
/// Throws Error (kFileUnwritable) if the file exists.
void requireNewKeyFile(const std::filesystem::path& file);

/// Returns the public key, 64 hexadecimal digits.
[[nodiscard]] std::string publicOf(const SecretKey& key);
[[nodiscard]] bool isPublicKey(const std::string& hex);
/// Returns the signature of a text, 128 hexadecimal digits.
[[nodiscard]] std::string signedWith(const SecretKey& key, const std::string& text);
[[nodiscard]] bool isSignature(const std::string& hex);
/// Returns whether the signature of the text was made with this key.
[[nodiscard]] bool genuine(const std::string& text, const std::string& signature,
                           const std::string& publicKey);

inline constexpr const char* kReplacedWord = "torsio-key";  ///< first word of such a line

/// Replacement of one key by another from some length and time of the audit trail on. Its line is "torsio-key
/// 1 OLD NEW LENGTH TIME SIGNATURE SIGNATURE".
struct KeyReplacement {
  std::string old{};
  std::string fresh{};
  std::int64_t length = 0;
  std::int64_t utc_us = 0;
  std::string signatureOfOld{};
  std::string signatureOfFresh{};

  [[nodiscard]] std::string signedText() const;
  [[nodiscard]] std::string line() const;
  [[nodiscard]] bool isGenuine() const;  ///< signed by both keys
};
[[nodiscard]] bool isReplacementLine(const std::string& line);
/// Returns empty if the line is not a complete replacement.
[[nodiscard]] std::optional<KeyReplacement> replacementOf(const std::string& line);
/// Reads a file of keys or heads. Throws Error: kFileMissing; kFileUnreadable, also for a pipe or a device,
/// which would wait or never end, and for a file that is too large to be one.
[[nodiscard]] std::string readKept(const std::filesystem::path& file);
/// Returns the genuine replacements in a key or witness file. Throws Error (kFileMissing).
[[nodiscard]] std::vector<KeyReplacement> replacementsIn(const std::filesystem::path& file);

/// Keys whose signatures count, each in its period: one key, its predecessors and its successors.
class TrustedKeys {
 public:
  /// `publicKey` empty: no signature is required. `measure`: unit of periods, length or time.
  TrustedKeys(const std::string& publicKey, const std::vector<KeyReplacement>& replacements,
              std::int64_t KeyReplacement::*measure);

  [[nodiscard]] bool asksForSignatures() const { return !times_.empty(); }
  /// Returns what is wrong with the signature of a head made at length or time `at`; empty if it is genuine
  /// and from the key valid then.
  [[nodiscard]] std::string flawOf(const std::string& text, const std::string& signature,
                                   const std::string& publicKey, std::int64_t at) const;

 private:
  struct Time {
    std::int64_t first = 0;
    std::int64_t last = std::numeric_limits<std::int64_t>::max();
  };
  std::map<std::string, Time> times_;
};

}  // namespace torsio
