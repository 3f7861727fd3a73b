// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/people/roster_accounts.h"

#include <algorithm>
#include <cctype>
#include <map>
#include <set>
#include <string>

#include "app/services/access/access_service.h"
#include "app/services/base/identifiers.h"
#include "assessment/domain/people/account.h"
#include "assessment/domain/people/person.h"

namespace torsio {

namespace {

/// `taken`: likenessOf() the names in use.
std::string signInName(const std::string& personCode, const std::set<std::string>& taken) {
  std::string login = personCode;
  std::transform(login.begin(), login.end(), login.begin(),
                 [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
  if (!taken.contains(likenessOf(login))) {
    return login;
  }
  int number = 2;
  while (taken.contains(likenessOf(login + "." + std::to_string(number)))) {
    ++number;
  }
  return login + "." + std::to_string(number);
}

std::vector<std::string> rolesOf(const PersonRow& row) {
  std::vector<std::string> roles;
  if (row.trainee) {
    roles.emplace_back("trainee");
  }
  if (row.rater) {
    roles.emplace_back("rater");
  }
  return roles;
}

/// Returns the names that the actor may see; none without that right.
std::map<PersonId, std::string> visibleNames(SessionContext& session) {
  std::map<PersonId, std::string> names;
  if (session.may(Operation::kPersonViewIdentity)) {
    for (const NamedPersonRow& person : namedPeople(session)) {
      names[person.row.person.id] = person.identity.fullName;
    }
  }
  return names;
}

}  // namespace

std::vector<PersonRow> peopleWithoutAccount(SessionContext& session) {
  session.require(Operation::kUserManage);
  std::set<std::string> withAccount;
  for (const UserAccount& user : users(session)) {
    withAccount.insert(user.personId);
  }
  std::vector<PersonRow> rows = people(session);
  std::erase_if(rows, [&withAccount](const PersonRow& row) {
    return row.person.state != PersonState::kActive || withAccount.contains(row.person.id);
  });
  return rows;
}

void addAccounts(SessionContext& session, const std::vector<PersonId>& personIds,
                 std::vector<StartAccount>& made, const ProgressCallback& progress) {
  std::vector<PersonRow> rows = peopleWithoutAccount(session);
  const std::set<std::string> wanted(personIds.begin(), personIds.end());
  std::erase_if(rows, [&wanted](const PersonRow& row) { return !wanted.contains(row.person.id); });
  std::map<PersonId, std::string> names = visibleNames(session);
  std::set<std::string> taken;
  for (const UserAccount& user : users(session)) {
    taken.insert(likenessOf(user.login));
  }
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const PersonRow& row = rows[i];
    tellProgress(progress, Text::tr("Start password for %1", row.person.code),
                 static_cast<double>(i) / static_cast<double>(rows.size()));
    NewUser user{.login = signInName(row.person.code, taken),
                 .personId = row.person.id,
                 .roles = rolesOf(row),
                 .startPassword = randomStartPassword(),
                 .demonstration = row.person.demonstration};
    const MadeUser stored = makeUser(session, user);
    taken.insert(likenessOf(user.login));
    made.push_back({.login = user.login,
                    .role = user.roles.front(),
                    .personCode = row.person.code,
                    .startPassword = stored.startPassword,
                    .personName = names[row.person.id],
                    .part = stored.awaitsSecond ? PasswordPart::kFirstHalf : PasswordPart::kWhole});
  }
}

std::vector<StartAccount> accountsOf(SessionContext& session, std::span<const OpenRequest> requests) {
  session.require(Operation::kUserManage);
  std::map<PersonId, std::string> codes;
  for (const PersonRow& row : people(session)) {
    codes[row.person.id] = row.person.code;
  }
  std::map<PersonId, std::string> names = visibleNames(session);
  const std::vector<UserAccount> accounts = users(session);
  std::vector<StartAccount> out;
  for (const OpenRequest& request : requests) {
    StartAccount one{.login = request.shown,
                     .personCode = request.shown,
                     .part = PasswordPart::kSecondHalf,
                     .askedBy = request.requestedBy};
    const auto user = std::find_if(accounts.begin(), accounts.end(), [&](const UserAccount& account) {
      return account.id.text() == request.request.subject;
    });
    if (user != accounts.end() && codes.contains(user->personId)) {
      one.personCode = codes[user->personId];
      one.personName = names[user->personId];
    }
    out.push_back(std::move(one));
  }
  return out;
}

void confirmAccounts(SessionContext& session, std::span<const OpenRequest> requests,
                     std::vector<StartAccount>& made, const ProgressCallback& progress) {
  std::vector<StartAccount> accounts = accountsOf(session, requests);
  for (std::size_t i = 0; i < requests.size(); ++i) {
    tellProgress(progress, Text::tr("Start password for %1", accounts[i].login),
                 static_cast<double>(i) / static_cast<double>(requests.size()));
    accounts[i].startPassword = confirmRequest(session, requests[i].request.id);
    if (!accounts[i].startPassword.empty()) {
      made.push_back(std::move(accounts[i]));
    }
  }
}

}  // namespace torsio
