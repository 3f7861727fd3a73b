// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/people/roster_accounts.h"

#include <algorithm>
#include <cctype>
#include <map>
#include <set>

#include "app/services/access/person_text.h"
#include "app/services/access/two_people.h"
#include "assessment/domain/people/account.h"

namespace torsio {

namespace {

/// `taken`: what the names in use look like.
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
  std::map<PersonId, std::string> names;
  if (session.may(Operation::kPersonViewIdentity)) {
    for (const NamedPersonRow& person : namedPeople(session)) {
      names[person.row.person.id] = person.identity.fullName;
    }
  }
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
    made.push_back({user.login, user.roles.front(), row.person.code,
                    stored.awaitsSecond ? stored.startPassword + "-\u2026" : stored.startPassword,
                    names[row.person.id]});
  }
}

}  // namespace torsio
