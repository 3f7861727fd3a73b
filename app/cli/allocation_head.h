// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>

#include <nlohmann/json.hpp>

namespace torsio::cli {

// The signature under the head of an allocation. Private to app/cli's .cpp files.

/// The head of an allocation with its signature: "torsio-allocation 1 RECORDS HASH TIME PUBLIC SIGNATURE",
/// time in microseconds since 1970 UTC. `key`: file; empty: the head as it is, without the last three. Throws
/// Error as readKey().
[[nodiscard]] std::string signedAllocationHead(const std::string& head, const std::string& key,
                                               std::int64_t now_us);

/// The first four words of such a line, which say what is signed apart from the time.
[[nodiscard]] std::string unsignedAllocationHead(const std::string& line);

/// By what the signatures are checked, as the command names it; empty: as this station has it.
struct HeadKeys {
  std::string key{};        ///< file of the key that must have signed
  std::string publicKey{};  ///< the same, by its public part
  std::string witness{};    ///< file with the lines by which keys replaced each other
};

/// What the signatures under the heads of one allocation say.
struct SignatureFinding {
  std::string flaw{};  ///< empty: nothing speaks against the file
  bool isSigned = false;
  nlohmann::ordered_json json{};  ///< state, key, time, the key it was compared with, what that means
};
/// `fileHead`: line of the file, `keptHead`: one that was kept elsewhere; empty: there is none. Throws Error
/// as readKey(), kFileMissing for a witness that was named.
[[nodiscard]] SignatureFinding checkSignatures(const std::string& fileHead, const std::string& keptHead,
                                               const HeadKeys& keys);

}  // namespace torsio::cli
