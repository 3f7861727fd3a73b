// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>

#include "app/services/access/session_context.h"
#include "app/services/access/two_people.h"
#include "db/connection/connection.h"
#include "db/repository/base/id_source.h"
#include "sim/core/text.h"

namespace torsio {

/// Who maintains a record without the window: a user who signs in, or the operating system account that owns
/// it.
struct Maintainer {
  std::string login{};                      ///< empty: the system
  std::function<std::string()> password{};  ///< called once, when the record is open
  std::function<std::string()> code{};      ///< of the second factor; called if the account has one
  std::string secondLogin{};  ///< of another administrator, for acts that need two people; empty: nobody
  std::function<std::string()> secondPassword{};
  std::function<std::string()> secondCode{};
  std::string systemAccount{};                              ///< if this and the login are empty: nobody,
                                                            ///< without any rights
  std::function<bool(const std::string& file)> ownsFile{};  ///< whether the account owns a file; for SQLite
  std::function<void(const Text&)> tell{};                  ///< called with what was repaired; may be empty
};

/// A record with its maintainer signed in; other accounts of this computer lose access to its files and
/// copies. Both constructors throw Error (kPermission) if no maintainer was named, the password is wrong, or
/// the record belongs to another system account; DbError.
class MaintenanceDesk {
 public:
  /// Opens the record at `locator` for writing.
  MaintenanceDesk(const Maintainer& maintainer, const std::string& locator);
  /// Takes over an open record. `owned`: the locator that the system account must own.
  MaintenanceDesk(const Maintainer& maintainer, Connection opened, const std::string& owned);

  /// Returns the session and begins the next service call.
  [[nodiscard]] SessionContext& session() {
    session_.beginCall();
    return session_;
  }

  /// Requests `wish` as the first person and signs in the second one to carry it out. Does nothing without a
  /// second person.
  void handOver(const Maintainer& maintainer, const DutyWish& wish);

 private:
  void enter(const Maintainer& maintainer, const std::string& owned);

  Connection connection_;
  SystemIdSource ids_;
  SessionContext session_;
};

}  // namespace torsio
