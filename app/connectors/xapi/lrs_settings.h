// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "app/services/access/session_context.h"
#include "app/services/base/web_answer.h"

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

/// Client of a store of xAPI 1.0.3 or 2.0 (IEEE 9274.1.1): it speaks 1.0.3 until the store says that it knows
/// only the other (changeVersion()). Asks as askWeb() does; an answer of more than a megabyte is none. One
/// thread at a time.
class LrsClient {
 public:
  /// `patience`: longest wait for an answer, its last byte included. `stop`: see WebRequest; outlives the
  /// client.
  LrsClient(const std::string& endpoint, LrsKey key,
            std::chrono::milliseconds patience = std::chrono::seconds(30),
            const std::atomic<bool>* stop = nullptr);

  /// Sends a statement.
  [[nodiscard]] WebAnswer post(const std::string& statement) const;
  /// Requests the statement with this id.
  [[nodiscard]] WebAnswer get(const std::string& id) const;
  /// Asks the store, once, for its versions. Returns true if the client speaks another one from now on.
  [[nodiscard]] bool changeVersion();

 private:
  /// `place`: below the endpoint.
  [[nodiscard]] WebAnswer ask(const std::string& place, std::optional<std::string> body) const;

  std::string endpoint_;  // ends with a slash
  LrsKey key_;
  std::chrono::milliseconds patience_;
  const std::atomic<bool>* stop_;
  std::string_view version_;
  bool asked_ = false;  // for its versions
};

}  // namespace torsio
