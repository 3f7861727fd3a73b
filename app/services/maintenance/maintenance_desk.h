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

/// Who takes care of a record without the window: somebody who signs in, or the account of the operating
/// system that owns it.
struct Maintainer {
  std::string login{};                      ///< empty: the system
  std::function<std::string()> password{};  ///< asked once, when the record is open
  std::string secondLogin{};  ///< of another administrator, for what needs two people; empty: nobody
  std::function<std::string()> secondPassword{};
  std::string systemAccount{};                              ///< empty, and no login: nobody, who may nothing
  std::function<bool(const std::string& file)> ownsFile{};  ///< of that account; for SQLite
  std::function<void(const Text&)> tell{};                  ///< hears what was mended; may be empty
};

/// A record with whoever takes care of it, signed in; its files and copies are closed to other accounts of
/// this computer. Both constructors throw Error (kPermission) when nobody
/// was named, the password is not right, or the record belongs to another account of the system; DbError.
class MaintenanceDesk {
 public:
  /// Opens the record at `locator` for writing.
  MaintenanceDesk(const Maintainer& maintainer, const std::string& locator);
  /// Takes over the record that is open already. `owned`: the locator that the system must own.
  MaintenanceDesk(const Maintainer& maintainer, Connection opened, const std::string& owned);

  /// Begins the next call of a service.
  [[nodiscard]] SessionContext& session() {
    session_.beginCall();
    return session_;
  }

  /// The first person asks for `wish`, and the second one signs in, to do it. Does nothing without a second.
  void handOver(const Maintainer& maintainer, const DutyWish& wish);

 private:
  void enter(const Maintainer& maintainer, const std::string& owned);

  Connection connection_;
  SystemIdSource ids_;
  SessionContext session_;
};

}  // namespace torsio
