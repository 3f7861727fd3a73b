// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/installation/unattended_setup.h"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <sstream>
#include <utility>

#include "app/services/access/access_service.h"
#include "app/services/access/centre_settings.h"
#include "app/services/access/first_run.h"
#include "app/services/access/invitations.h"
#include "app/services/access/station_name.h"
#include "app/services/access/station_record.h"
#include "app/services/access/two_people.h"
#include "app/services/base/nearest_name.h"
#include "app/services/people/roster_accounts.h"
#include "app/services/people/roster_import.h"
#include "db/connection/connection.h"
#include "db/connection/locator.h"
#include "sim/core/error.h"

namespace torsio {

namespace {

/// Roles of an account that belongs to nobody in the rosters.
const std::vector<std::string> kOfficeRoles{kAdministratorRole, "allocator", "statistician"};

/// A fault of the answers, which names its file and line.
struct AnswerError : Error {
  using Error::Error;
};

[[noreturn]] void refuseAnswer(const Text& place, Text what, Text remedy) {
  throw AnswerError(ErrorCode::kBadData, std::move(what), place, std::move(remedy));
}

bool isAboutAnswers(const Error& error) {
  switch (error.code()) {
    case ErrorCode::kBadParameter:
    case ErrorCode::kBadData:
    case ErrorCode::kFileMissing:
    case ErrorCode::kFileUnreadable:
      return true;
    default:
      return false;
  }
}

/// Gives what a service refuses the line of the answer.
void atPlace(const Text& place, const auto& act) {
  try {
    act();
  } catch (const AnswerError&) {
    throw;
  } catch (const Error& error) {
    if (!isAboutAnswers(error)) {
      throw;
    }
    refuseAnswer(place, error.happenedText(), error.remedyText());
  }
}

std::string required(const KeyFile& answers, std::string_view key) {
  const std::optional<std::string> value = answers.at(key);
  if (!value) {
    refuseAnswer(answers.file().string(), Text::verbatim("\"%1\" is missing", key),
                 Text::verbatim("Add a line %1 = ...", key));
  }
  return *value;
}

/// Returns whether the first administrator gets a link instead of a start password.
bool wantsLink(const KeyFile& answers) {
  const std::string way = answers.at(kAnsweredFirstSignIn).value_or("password");
  if (way != "password" && way != "link") {
    refuseAnswer(answers.placeOf(kAnsweredFirstSignIn),
                 Text::verbatim("\"%1\" cannot be %2", kAnsweredFirstSignIn, way),
                 Text::verbatim("Write password or link"));
  }
  if (way == "link" && !answers.at(kAnsweredBrowserAddress)) {
    refuseAnswer(answers.placeOf(kAnsweredFirstSignIn),
                 Text::verbatim("a link needs the address of the review desk"),
                 Text::verbatim("Add a line %1 = https://desk.example.org", kAnsweredBrowserAddress));
  }
  return way == "link";
}

/// Reads "LOGIN ROLE [ROLE ...]"; commas between the roles are blanks.
NewUser officeUser(const KeyFile& answers, const KeyLine& line) {
  std::string words = line.value;
  std::replace(words.begin(), words.end(), ',', ' ');
  std::istringstream in(words);
  NewUser user;
  in >> user.login;
  for (std::string role; in >> role;) {
    if (std::find(kOfficeRoles.begin(), kOfficeRoles.end(), role) == kOfficeRoles.end()) {
      refuseAnswer(answers.placeOf(line), Text::verbatim("\"%1\" is no role of such an account", role),
                   Text::verbatim("Write some of %1 after the sign-in name; trainees and raters come with "
                                  "their rosters",
                                  joined(kOfficeRoles)));
    }
    user.roles.push_back(role);
  }
  if (user.roles.empty()) {
    refuseAnswer(answers.placeOf(line), Text::verbatim("the account %1 has no role", user.login),
                 Text::verbatim("Write some of %1 after the sign-in name", joined(kOfficeRoles)));
  }
  return user;
}

void addOfficeUser(SessionContext& session, const KeyFile& answers, const KeyLine& line,
                   std::vector<StartAccount>& made) {
  NewUser user = officeUser(answers, line);
  user.startPassword = randomStartPassword();
  atPlace(answers.placeOf(line), [&] {
    const MadeUser stored = makeUser(session, user);
    made.push_back({.login = user.login,
                    .role = user.roles.front(),
                    .startPassword = stored.startPassword,
                    .part = stored.awaitsSecond ? PasswordPart::kFirstHalf : PasswordPart::kWhole});
  });
}

/// Returns how many people the roster added. A fault in it has the line there, an unreadable file that of the
/// answer.
std::size_t addRosterOf(SessionContext& session, const KeyFile& answers, std::string_view key,
                        RosterKind kind) {
  const std::optional<std::string> name = answers.at(key);
  if (!name) {
    return 0;
  }
  RosterFile roster;
  RosterColumns columns;
  RosterPreview preview;
  const std::filesystem::path file = answers.file().parent_path() / *name;
  atPlace(Text::verbatim("%1: %2", answers.placeOf(key), file.string()), [&] {
    roster = readRoster(file);
    columns = suggestColumns(roster, kind);
    preview = previewRoster(session, roster, kind, columns);
  });
  try {
    return importRoster(session, roster, kind, columns, preview.fingerprint, RosterMode::kCommit).added;
  } catch (const Error& error) {
    throw AnswerError(error.code(), error.happenedText(), error.whereText(), error.remedyText());
  }
}

/// How much of a setup is done.
enum class SetupExtent : std::uint8_t {
  kAll,
  kTrial,  ///< without accounts for the rosters, which cannot be refused: hashing their passwords takes time
};

void addEverybody(SessionContext& session, const KeyFile& answers, SetupExtent extent, SetUpRecord& done) {
  for (const KeyLine& line : answers.every(kAnsweredAccount)) {
    addOfficeUser(session, answers, line, done.accounts);
  }
  done.trainees = addRosterOf(session, answers, kAnsweredTrainees, RosterKind::kTrainees);
  done.raters = addRosterOf(session, answers, kAnsweredRaters, RosterKind::kRaters);
  if (extent == SetupExtent::kAll && answers.at(kAnsweredRosterAccounts) == "yes") {
    std::vector<PersonId> ids;
    for (const PersonRow& row : peopleWithoutAccount(session)) {
      ids.push_back(row.person.id);
    }
    addAccounts(session, ids, done.accounts);
  }
}

void chooseForCentre(SessionContext& session, const KeyFile& answers, SetUpRecord& done) {
  if (const auto code = answers.at(kAnsweredCode)) {
    atPlace(answers.placeOf(kAnsweredCode), [&] { changeCentreSetting(session, kCentreCode, *code); });
  }
  if (const auto address = answers.at(kAnsweredBrowserAddress)) {
    atPlace(answers.placeOf(kAnsweredBrowserAddress), [&] { setBrowserAddress(session, *address); });
  }
  done.code = centreCode(session.connectionWithoutRight());
}

/// Sees to it that the first administrator, who is signed in with a password that was drawn, chooses one.
void handOver(SessionContext& session, const KeyFile& answers, const std::string& password,
              SetUpRecord& done) {
  const UserId administrator = session.actor().userId;
  resetPassword(session, administrator, password, "start password of an unattended setup");
  if (!wantsLink(answers)) {
    done.accounts.push_back(
        {.login = done.administrator, .role = kAdministratorRole, .startPassword = password});
    return;
  }
  const std::string address = browserAddress(session);
  done.link = invitationLink(address, makeInvitation(session, administrator, ""), false);
  done.linkExpiresUtc_us = session.now_us() + kInvitationLife_us;
}

/// Sets up the record of the session, all or nothing.
SetUpRecord setUpFrom(SessionContext& session, const std::filesystem::path& file, SetupExtent extent) {
  const KeyFile answers = KeyFile::read(file, kAnswerKeys);
  const FirstRun first{.centre = required(answers, kAnsweredCentre),
                       .login = required(answers, kAnsweredAdministrator),
                       .password = randomStartPassword(),
                       .language = answers.at(kAnsweredLanguage).value_or("en")};
  (void)wantsLink(answers);  // before anything is done
  SetUpRecord done{.centre = first.centre, .administrator = first.login};
  Transaction transaction(session.connectionWithoutRight());
  atPlace(answers.placeOf(kAnsweredAdministrator), [&] { performFirstRun(session, first, {}); });
  chooseForCentre(session, answers, done);
  handOver(session, answers, first.password, done);
  addEverybody(session, answers, extent, done);
  transaction.commit();
  return done;
}

}  // namespace

SetUpRecord setUpRecord(const std::string& locator, const std::filesystem::path& answers) {
  if (const StationRecord own = stationRecord();
      own.origin == RecordOrigin::kUsual && own.locator == locator) {
    (void)usualRecord();  // whose folder a new account does not have
  }
  if (lookAtRecord(locator) == RecordPlace::kCentre) {
    throw Error(ErrorCode::kPermission, Text::tr("this database belongs to a centre already"),
                parseLocator(locator).shown(), Text::tr("Sign in, or choose another database"));
  }
  tryAnswers(answers);
  SessionContext session(SessionKey{.locator = locator, .station = stationName()});
  return setUpFrom(session, answers, SetupExtent::kAll);
}

void tryAnswers(const std::filesystem::path& answers) {
  SessionContext session(SessionKey{.locator = ":memory:", .station = stationName()});
  (void)setUpFrom(session, answers, SetupExtent::kTrial);
}

}  // namespace torsio
