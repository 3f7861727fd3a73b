// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "app/services/access/access_service.h"

namespace torsio {

class Connection;

/// What anybody at the station may know before signing in.
struct CentreSign {
  std::string name{};      ///< empty before the first run
  std::string language{};  ///< "en", "zh_CN"; empty: none was chosen
};
[[nodiscard]] CentreSign centreSign(Connection& connection);

/// Whether the address of a server says its password, which every user of the machine would see among the
/// arguments of a program. False for a file. Throws Error (kBadParameter) for an address that is none.
[[nodiscard]] bool saysPassword(const std::string& locator);

/// What lies where a record is to be kept.
enum class RecordPlace {
  kNothing,  ///< no file yet: one can be made there
  kEmpty,    ///< a database that nobody uses yet
  kCentre,   ///< a centre with its accounts
};

/// Looks without writing anything. Throws Error, DbError with what is wrong: a folder that is missing or
/// cannot be written, a file that is no record or is damaged, a server that does not answer.
[[nodiscard]] RecordPlace lookAtRecord(const std::string& locator);

/// Looks at a record that a centre was set up in before, at this station. Throws Error (kFileMissing,
/// kVerifyFailed) when no centre is there any more: whoever comes next must not become its administrator.
void requireKnownRecord(const std::string& locator);

/// An account of the demonstration. The password was drawn at random, must be changed at the first sign-in,
/// and is told once: only its hash is stored.
struct StartAccount {
  std::string login{};
  std::string role{};
  std::string personCode{};
  std::string startPassword{};
  std::string personName{};  ///< empty: unknown, or not for whoever made the account
};

/// Fills the record with people who are not real, and makes an account for each role.
using AddPeople = std::function<std::vector<StartAccount>(SessionContext&)>;

/// Carries out what the first-run wizard decided, all or nothing: the centre, the first administrator (who is
/// signed in afterwards) and, where `first.demonstration` is set, `addPeople` (app/services/demonstration has
/// one). Throws what setUpCentre and `addPeople` throw.
std::vector<StartAccount> performFirstRun(SessionContext& session, const FirstRun& first,
                                          const AddPeople& addPeople);

/// Twenty characters in groups that can be read aloud; from the system's random source.
[[nodiscard]] std::string randomStartPassword();

}  // namespace torsio
