// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "app/services/access/session_context.h"

namespace torsio {

class Connection;

/// Where the centre sends learning records, for every station; off unless somebody turned it on.
struct LrsSettings {
  bool on = false;
  std::string endpoint{};  ///< "https://lrs.example.org/xapi": what "/statements" is added to
  std::string homePage{};  ///< "https://example.org": the system to which the accounts of trainees belong
  friend bool operator==(const LrsSettings&, const LrsSettings&) = default;
};

/// kSettingsEdit.
[[nodiscard]] LrsSettings lrsSettings(SessionContext& session);
/// From then on what happens is kept for the learning record store; what happened before is not. Turned off:
/// what waits stays. Audited. kSettingsEdit. Throws Error{kBadParameter}: an address that is none, or one
/// elsewhere without encryption.
void setLrsSettings(SessionContext& session, const LrsSettings& settings);

/// The settings with the key of the accounts' opaque names, for the sender; empty: none were made.
struct LrsIdentity {
  LrsSettings settings{};
  std::string accountKey{};
};
[[nodiscard]] std::optional<LrsIdentity> lrsIdentity(Connection& connection);

/// Name and secret by which a station signs in to the store. They lie in a file of the account that runs the
/// station, for it alone, and never in the record or its backups. A station without one sends nothing.
struct LrsKey {
  std::string user{};
  std::string secret{};
};
/// Empty: this station has none. Throws Error{kPermission} when other accounts could read it until now.
[[nodiscard]] std::optional<LrsKey> stationLrsKey();
/// An empty user takes it away. Throws Error{kBadParameter} for a user with a colon or line breaks in either,
/// {kFileUnwritable}.
void setStationLrsKey(const LrsKey& key);

}  // namespace torsio
