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

/// Key of a centre that signs what is kept elsewhere (Ed25519 of libsodium): heads of the audit trail and of
/// allocations. As its file holds it.
using SecretKey = std::array<std::uint8_t, 64>;

[[nodiscard]] SecretKey drawKey();
/// Throws Error: kFileMissing; kBadData when the file holds none; kPermission when other accounts could read
/// it.
[[nodiscard]] SecretKey readKey(const std::filesystem::path& file);
/// Writes a key, and the line by which it takes the place of another ("": it does not), for its owner alone.
/// Throws Error (kFileUnwritable).
void writeKey(const std::filesystem::path& file, const SecretKey& secret, const std::string& replacement);
/// Throws Error (kFileUnwritable) when the file exists.
void requireNewKeyFile(const std::filesystem::path& file);

/// The public part, 64 hexadecimal digits.
[[nodiscard]] std::string publicOf(const SecretKey& key);
[[nodiscard]] bool isPublicKey(const std::string& hex);
/// The signature of a text, 128 hexadecimal digits.
[[nodiscard]] std::string signedWith(const SecretKey& key, const std::string& text);
[[nodiscard]] bool isSignature(const std::string& hex);
/// Whether the signature is that of this key under this text.
[[nodiscard]] bool genuine(const std::string& text, const std::string& signature,
                           const std::string& publicKey);

inline constexpr const char* kReplacedWord = "torsio-key";  ///< begins such a line

/// One key in the place of another, from some length of the audit trail and some time on. Its line is
/// "torsio-key 1 OLD NEW LENGTH TIME SIGNATURE SIGNATURE".
struct KeyReplacement {
  std::string old{};
  std::string fresh{};
  std::int64_t length = 0;
  std::int64_t utc_us = 0;
  std::string signatureOfOld{};
  std::string signatureOfFresh{};

  [[nodiscard]] std::string signedText() const;
  [[nodiscard]] std::string line() const;
  [[nodiscard]] bool isGenuine() const;  ///< both keys signed it
};
[[nodiscard]] bool isReplacementLine(const std::string& line);
/// Empty: the line is none, or was cut off before its second signature.
[[nodiscard]] std::optional<KeyReplacement> replacementOf(const std::string& line);
/// The genuine ones among the lines of a file: of a key, or of a witness. Throws Error (kFileMissing).
[[nodiscard]] std::vector<KeyReplacement> replacementsIn(const std::filesystem::path& file);

/// Keys whose signatures count, each in its time: one key, those it replaced, and those that replaced it.
class TrustedKeys {
 public:
  /// `publicKey` empty: no signature is asked for. `measure`: by what times are told, length or time.
  TrustedKeys(const std::string& publicKey, const std::vector<KeyReplacement>& replacements,
              std::int64_t KeyReplacement::*measure);

  [[nodiscard]] bool asksForSignatures() const { return !times_.empty(); }
  /// What is wrong with a signature under a head, which was made at length or time `at`. Empty: it is
  /// genuine, and of a key of its time.
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
