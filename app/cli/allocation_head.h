// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>

#include <nlohmann/json.hpp>

namespace torsio::cli {

// Signatures of allocation heads. Private to app/cli's .cpp files.

/// Signs the head of an allocation: "torsio-allocation 1 RECORDS HASH TIME PUBLIC SIGNATURE", time in
/// microseconds since 1970 UTC. `key`: file; empty: returns the head unsigned. Throws Error like readKey().
[[nodiscard]] std::string signedAllocationHead(const std::string& head, const std::string& key,
                                               std::int64_t now_us);

/// Returns the first four words of such a line: the signed part except for the time.
[[nodiscard]] std::string unsignedAllocationHead(const std::string& line);

/// Keys for checking signatures, from the command line; empty: those of this station.
struct HeadKeys {
  std::string key{};        ///< file of the expected signing key
  std::string publicKey{};  ///< its public part instead
  std::string witness{};    ///< file with the lines that record replacements of keys
};

/// Result of checking the signatures of an allocation's heads.
struct SignatureFinding {
  std::string flaw{};  ///< empty: no objection
  bool isSigned = false;
  nlohmann::ordered_json json{};  ///< state, key, time, the expected key, and an explanation
};
/// `fileHead`: line of the file; `keptHead`: a line stored elsewhere; empty: none. Throws Error like
/// readKey(), kFileMissing for a given witness.
[[nodiscard]] SignatureFinding checkSignatures(const std::string& fileHead, const std::string& keptHead,
                                               const HeadKeys& keys);

}  // namespace torsio::cli
