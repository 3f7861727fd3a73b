// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/services/access/operation.h"
#include "assessment/domain/ids.h"
#include "assessment/domain/people/account.h"
#include "assessment/domain/people/audit_terms.h"

namespace torsio {

class Connection;
class IdSource;

/// Somebody who has signed in (access_service.h is the only place that makes one from a password).
struct Actor {
  UserId userId{};
  std::string login{};
  PersonId personId{};  ///< empty: nobody of the record (an administrator, say)
  std::vector<std::string> roles{};
  /// Came in with a station PIN: practice without a record and nothing else, whatever the roles say.
  bool practiceOnly = false;
  /// When the password was shown last, by the clock of the session; 0: never. A signature asks for it.
  std::int64_t passwordShownUtc_us = 0;
  /// An account of the operating system that owns the record and takes care of it from the command line
  /// without signing in: backing up, checking, restoring, moving, and taking results out; nothing else.
  std::string systemAccount{};

  [[nodiscard]] bool hasRole(const std::string& role) const;
};

/// Wall-clock time, microseconds since 1970 UTC.
using UtcClock = std::function<std::int64_t()>;

/// What a worker thread needs to work for the same person on a connection of its own.
struct SessionKey {
  std::string locator{};
  std::string station{};
  Actor actor{};
};

/// What a change leaves in the audit trail. Ids and codes only, never a name.
struct AuditNote {
  AuditAction action;
  AuditObject objectKind;
  std::string objectId{};
  std::string oldJson{};
  std::string newJson{};
  std::string reason{};
};

/// One signed-in person at one station with one database: what every service of the application works
/// through. Each service function begins with require(), which opens connection() to it: the matrix role x
/// operation is read from the database each time, so a right that was taken away is gone at once. Default
/// deny. Belongs to the thread that made it.
class SessionContext {
 public:
  /// Opens (or makes) the database of `key` and brings its schema up to date. Throws Error, DbError.
  explicit SessionContext(const SessionKey& key);
  /// Tests and the demonstration: an open connection, ids and time of their own. Both outlive the session.
  SessionContext(Connection& connection, IdSource& ids, SessionKey key, UtcClock now);
  ~SessionContext();
  SessionContext(SessionContext&&) noexcept;
  SessionContext& operator=(SessionContext&&) = delete;

  /// Returns the record for a service that has passed require() in this call. Throws ContractError when
  /// nothing was asked for since beginCall() or since somebody else signed in: a service without a right is a
  /// fault of Torsio.
  [[nodiscard]] Connection& connection() const;
  /// Returns the record for what is open by design: signing in, the sign of the centre, the station's own
  /// writing, the demonstration of a new centre.
  [[nodiscard]] Connection& connectionWithoutRight() const noexcept { return *connection_; }
  /// Begins the next call of a service: what require() allowed before opens the record no more. Whoever hands
  /// this session to a service calls it (ShellContext::session(), the centres of the tests).
  void beginCall() noexcept { asked_ = false; }
  [[nodiscard]] IdSource& ids() const noexcept { return *ids_; }
  [[nodiscard]] const Actor& actor() const noexcept { return key_.actor; }
  [[nodiscard]] const std::string& station() const noexcept { return key_.station; }
  [[nodiscard]] const SessionKey& key() const noexcept { return key_; }
  [[nodiscard]] std::int64_t now_us() const { return now_(); }
  /// Of every password that is set from now on; tests use a cheap one.
  [[nodiscard]] PasswordCost passwordCost() const noexcept { return passwordCost_; }
  void setPasswordCost(PasswordCost cost) noexcept { passwordCost_ = cost; }
  /// Opens a connection of its own anew, after the server was away. Only between two services; does nothing
  /// for a borrowed connection. Throws Error, DbError, and then keeps the old one.
  void reconnect();
  /// After signing in or out, on the same connection.
  void setActor(Actor actor) {
    key_.actor = std::move(actor);
    beginCall();
  }

  /// From now on a signature asks for the password again.
  void forgetPasswordShown() noexcept { key_.actor.passwordShownUtc_us = 0; }

  [[nodiscard]] bool may(Operation operation) const;
  /// Opens connection() to this call, or throws Error{kPermission} that names the operation in words.
  void require(Operation operation) const;
  /// Asks for either of two operations; a refusal names the second.
  void requireEither(Operation first, Operation second) const;
  /// For "own" operations: the record must also belong to the actor's person.
  void requireOwn(Operation operation, const PersonId& personId) const;

  /// Adds an entry to the audit trail; call it inside the transaction of the change.
  void note(const AuditNote& note) const;

 private:
  struct Owned;
  std::unique_ptr<Owned> owned_;  // null when connection and ids are borrowed
  Connection* connection_;
  IdSource* ids_;
  SessionKey key_;
  UtcClock now_;
  PasswordCost passwordCost_ = PasswordCost::kModerate;
  mutable bool asked_ = false;  // require() was passed in this call
};

/// Opens (or makes) a database and brings its schema up to date. Throws Error, DbError.
[[nodiscard]] Connection openUpToDate(const std::string& locator);

/// Name of this machine as it stands on trials and audit entries.
[[nodiscard]] std::string stationName();

}  // namespace torsio
