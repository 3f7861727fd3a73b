// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "app/services/access/session_context.h"

namespace torsio {

class Connection;

/// Where all stations of the centre send learning records; off by default.
struct LrsSettings {
  bool on = false;
  std::string endpoint{};  ///< "https://lrs.example.org/xapi", without "/statements"
  std::string homePage{};  ///< "https://example.org": home page of the trainees' accounts
  friend bool operator==(const LrsSettings&, const LrsSettings&) = default;
};

/// kSettingsEdit.
[[nodiscard]] LrsSettings lrsSettings(SessionContext& session);
/// Once on, events are queued for the store; earlier ones are not. Turning it off keeps the queue. Audited.
/// kSettingsEdit. Throws Error{kBadParameter} for an invalid address, or one on another computer without
/// encryption.
void setLrsSettings(SessionContext& session, const LrsSettings& settings);

/// The settings and the key for opaque account names, for the sender; empty: not set.
struct LrsIdentity {
  LrsSettings settings{};
  std::string accountKey{};
};
[[nodiscard]] std::optional<LrsIdentity> lrsIdentity(Connection& connection);

/// Credentials of a station at the store. They are in a file that only the account running the station can
/// read, never in the record or its backups. A station without them sends nothing.
struct LrsKey {
  std::string user{};
  std::string secret{};
};
/// Empty: this station has none. Throws Error{kPermission} if other accounts can read the file.
[[nodiscard]] std::optional<LrsKey> stationLrsKey();
/// An empty user removes it. Throws Error: {kBadParameter} for a colon in the user or a line break in either;
/// {kFileUnwritable}.
void setStationLrsKey(const LrsKey& key);

/// Answer of a learning record store.
struct LrsAnswer {
  int status = 0;       ///< HTTP status; 0: no answer, for the reason in `body`
  std::string body{};   ///< at most a megabyte
  std::string after{};  ///< Retry-After header; empty: none
};

/// Client of a store of xAPI 1.0.3 or 2.0 (IEEE 9274.1.1): it speaks 1.0.3 until the store says that it knows
/// only the other (changeVersion()). Checks certificates and follows no redirects. Used by the thread that
/// created it, which needs no event loop.
class LrsClient {
 public:
  /// `stop` (may be null; outlives the client): once another thread sets it, a request is aborted within a
  /// tenth of a second.
  LrsClient(const std::string& endpoint, LrsKey key,
            std::chrono::milliseconds patience = std::chrono::seconds(30),
            const std::atomic<bool>* stop = nullptr);
  ~LrsClient();
  LrsClient(const LrsClient&) = delete;
  LrsClient& operator=(const LrsClient&) = delete;

  /// Sends a statement.
  [[nodiscard]] LrsAnswer post(const std::string& statement);
  /// Requests the statement with this id.
  [[nodiscard]] LrsAnswer get(const std::string& id);
  /// Asks the store, once, for its versions. Returns true if the client speaks another one from now on.
  [[nodiscard]] bool changeVersion();

 private:
  struct Talk;
  std::unique_ptr<Talk> talk_;
};

}  // namespace torsio
