// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "app/services/access/access_service.h"
#include "app/services/access/start_password.h"

namespace torsio {

class Connection;

/// What anybody at the station may see before signing in.
struct CentreSign {
  std::string name{};      ///< empty before the first run
  std::string language{};  ///< "en", "zh_CN"; empty: not chosen
};
[[nodiscard]] CentreSign centreSign(Connection& connection);

/// Returns whether a server's address contains a password, which every user of the machine could see among
/// the program's arguments. False for a file. Throws Error (kBadParameter) for an invalid address.
[[nodiscard]] bool saysPassword(const std::string& locator);

/// What exists at a record's address.
enum class RecordPlace {
  kNothing,  ///< no file yet; one can be created
  kEmpty,    ///< an unused database
  kCentre,   ///< a centre with its accounts
};

/// Checks an address without writing. Throws Error, DbError if the folder is missing or read-only, the file
/// is not a record or damaged, or the server does not answer.
[[nodiscard]] RecordPlace lookAtRecord(const std::string& locator);

/// Checks a record in which this station has seen a centre. Throws Error (kFileMissing, kVerifyFailed) if the
/// centre is gone: otherwise the next person could become its administrator.
void requireKnownRecord(const std::string& locator);

/// Fills the record with simulated people and creates an account for each role.
using AddPeople = std::function<std::vector<StartAccount>(SessionContext&)>;

/// Carries out the first-run wizard's decisions, all or nothing: the centre, the first administrator (who is
/// then signed in) and, if `first.demonstration`, `addPeople` (app/services/demonstration has one). Throws
/// what setUpCentre and `addPeople` throw.
std::vector<StartAccount> performFirstRun(SessionContext& session, const FirstRun& first,
                                          const AddPeople& addPeople);

/// Returns the hash under which a secret for one `purpose` is stored, however its groups were typed: without
/// spaces and hyphens.
[[nodiscard]] std::string hashOfSecret(std::string_view purpose, const std::string& typed);

}  // namespace torsio
