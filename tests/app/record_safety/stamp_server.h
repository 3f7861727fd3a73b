// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <string>

#include "tests/support/raw_server.h"

namespace torsio {

/// A time stamp authority on this machine: a small HTTP server in front of `openssl ts -reply`, whose faults
/// can be set.
class StampServer {
 public:
  enum class Fault {
    kNone,
    kRefuses,         ///< an answer that grants nothing
    kOldAnswer,       ///< always the first answer: another nonce
    kOtherText,       ///< a stamp of other bytes
    kOtherAuthority,  ///< signed by an authority of the same name that nobody trusts
    kBroken,          ///< 500
    kRedirects,       ///< 302 to another server
    kPage,            ///< 200 with a proxy's page
    kEmpty,           ///< 200 without a body
    kHalf,            ///< closes in the middle
    kHangsUp,         ///< closes without an answer
    kSlow,            ///< a byte every tenth of a second
    kEndless,         ///< never ends a body
    kEndlessHead,     ///< never ends its headers
  };

  /// Makes two authorities in `folder`.
  explicit StampServer(const std::filesystem::path& folder);

  [[nodiscard]] std::string address() const {
    return "http://127.0.0.1:" + std::to_string(server_.port()) + "/tsr";
  }
  /// PEM files of the roots.
  [[nodiscard]] std::string root() const { return (folder_ / "good" / "ca.pem").string(); }
  [[nodiscard]] std::string otherRoot() const { return (folder_ / "other" / "ca.pem").string(); }
  void become(Fault fault) { fault_ = fault; }
  [[nodiscard]] std::int64_t sent_bytes() const { return server_.sent_bytes(); }

 private:
  void talk(testing::RawServer::Guest& guest);
  [[nodiscard]] std::string replyTo(const std::string& query, Fault fault);

  std::filesystem::path folder_;
  std::atomic<Fault> fault_{Fault::kNone};
  std::string first_;  // answer
  testing::RawServer server_;
};

}  // namespace torsio
