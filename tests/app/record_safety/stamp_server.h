// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <string>
#include <thread>

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
  ~StampServer();
  StampServer(const StampServer&) = delete;
  StampServer& operator=(const StampServer&) = delete;

  [[nodiscard]] std::string address() const { return "http://127.0.0.1:" + std::to_string(port_) + "/tsr"; }
  /// PEM files of the roots.
  [[nodiscard]] std::string root() const { return (folder_ / "good" / "ca.pem").string(); }
  [[nodiscard]] std::string otherRoot() const { return (folder_ / "other" / "ca.pem").string(); }
  void become(Fault fault) { fault_ = fault; }
  [[nodiscard]] std::int64_t sent_bytes() const { return sent_; }

 private:
  void serve();
  void talk(int socket);
  [[nodiscard]] std::string replyTo(const std::string& query, Fault fault);
  bool send(int socket, const std::string& bytes);

  std::filesystem::path folder_;
  int listener_ = -1;
  int port_ = 0;
  std::atomic<Fault> fault_{Fault::kNone};
  std::atomic<bool> stop_{false};
  std::atomic<std::int64_t> sent_{0};
  std::string first_;  // answer
  std::thread thread_;
};

}  // namespace torsio
