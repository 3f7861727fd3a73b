// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "app/services/access/operation.h"
#include "assessment/domain/ids.h"
#include "assessment/domain/people/account.h"
#include "assessment/domain/people/audit_terms.h"

namespace torsio {

class Connection;
class IdSource;

/// A signed-in user (only access_service.h creates one from a password).
struct Actor {
  UserId userId{};
  std::string login{};
  PersonId personId{};  ///< empty: not a person of the record (an administrator, for example)
  std::vector<std::string> roles{};
  /// Signed in with a station PIN: only practice without a record, whatever the roles.
  bool practiceOnly = false;
  /// Time when the password was last entered, by the session's clock; 0: never. Signatures check it.
  std::int64_t passwordShownUtc_us = 0;
  /// The operating system account that owns the record and maintains it from the command line without signing
  /// in: backup, check, restore, move, and export of results; nothing else.
  std::string systemAccount{};
  /// What proves the sign-in to a prepared server; empty elsewhere.
  std::string serverToken{};

  [[nodiscard]] bool hasRole(const std::string& role) const;
};

/// Wall-clock time, microseconds since 1970 UTC.
using UtcClock = std::function<std::int64_t()>;

/// What a worker thread needs to act for the same user on its own connection.
struct SessionKey {
  std::string locator{};
  std::string station{};
  Actor actor{};
};

/// An entry for the audit trail. Ids and codes only, never names.
struct AuditNote {
  AuditAction action;
  AuditObject objectKind;
  std::string objectId{};
  std::string oldJson{};
  std::string newJson{};
  std::string reason{};
};

/// One signed-in user at one station with one database; every service of the application uses it. Each
/// service function starts with require(), which opens connection() for it: permissions are read from the
/// database each time, so revoking one takes effect at once. Default deny. Belongs to the thread that created
/// it.
class SessionContext {
 public:
  /// Opens (or creates) the database of `key` and migrates its schema. Throws Error, DbError.
  explicit SessionContext(const SessionKey& key);
  /// For tests and the demonstration: an open connection and custom ids and time. Connection and ids outlive
  /// the session.
  SessionContext(Connection& connection, IdSource& ids, SessionKey key, UtcClock now);
  ~SessionContext();
  SessionContext(SessionContext&&) noexcept;
  SessionContext& operator=(SessionContext&&) = delete;

  /// Returns the record for a service that has passed require() in this call. Throws ContractError if no
  /// right was checked since beginCall() or since the actor changed: a service without a check is a bug.
  [[nodiscard]] Connection& connection() const;
  /// Returns the record for what needs no right by design: signing in, the centre's name, the station's own
  /// writes, the demonstration of a new centre.
  [[nodiscard]] Connection& connectionWithoutRight() const;
  /// Begins a service call: earlier require() calls no longer open the record. Called by whatever passes this
  /// session to a service (ShellContext::session(), test centres).
  void beginCall() noexcept { asked_ = false; }
  [[nodiscard]] IdSource& ids() const noexcept { return *ids_; }
  [[nodiscard]] const Actor& actor() const noexcept { return key_.actor; }
  [[nodiscard]] const std::string& station() const noexcept { return key_.station; }
  [[nodiscard]] const SessionKey& key() const noexcept { return key_; }
  [[nodiscard]] std::int64_t now_us() const { return now_(); }
  /// Returns the hashing cost for new passwords; tests use a cheap one.
  [[nodiscard]] PasswordCost passwordCost() const noexcept { return passwordCost_; }
  void setPasswordCost(PasswordCost cost) noexcept { passwordCost_ = cost; }
  /// Reopens an owned connection after the server was unreachable. Call only between two services; does
  /// nothing for a borrowed connection. Throws Error, DbError, and then keeps the old one.
  void reconnect();
  /// Call after signing in or out, on the same connection.
  void setActor(Actor actor) {
    key_.actor = std::move(actor);
    beginCall();
  }

  /// Makes the next signature ask for the password.
  void forgetPasswordShown() noexcept { key_.actor.passwordShownUtc_us = 0; }

  [[nodiscard]] bool may(Operation operation) const;
  /// Opens connection() for this call, or throws Error{kPermission} that describes the operation.
  void require(Operation operation) const;
  /// Requires either of two operations; a refusal names the second.
  void requireEither(Operation first, Operation second) const;
  /// Requires an "own" operation: the record must also belong to the actor's person.
  void requireOwn(Operation operation, const PersonId& personId) const;

  /// Adds an entry to the audit trail; call it inside the transaction of the change. `now`: what was stored;
  /// null: nothing to tell.
  void note(const AuditNote& note) const;
  void note(AuditAction action, AuditObject objectKind, const std::string& objectId) const;
  void note(AuditAction action, AuditObject objectKind, const std::string& objectId,
            const nlohmann::json& now, const std::string& reason = {}) const;
  /// Like note(), with what was stored before.
  void noteChange(AuditAction action, AuditObject objectKind, const std::string& objectId,
                  const nlohmann::json& before, const nlohmann::json& now,
                  const std::string& reason = {}) const;

 private:
  struct Owned;
  std::unique_ptr<Owned> owned_;  // null if connection and ids are borrowed
  Connection* connection_;
  IdSource* ids_;
  SessionKey key_;
  UtcClock now_;
  PasswordCost passwordCost_ = PasswordCost::kFull;
  mutable bool asked_ = false;  // require() has passed in this call
};

/// Opens (or creates) a database and migrates its schema. Throws Error, DbError.
[[nodiscard]] Connection openUpToDate(const std::string& locator);

}  // namespace torsio
