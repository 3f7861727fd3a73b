// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/maintenance/guarded_erase.h"

#include "app/services/access/two_people.h"
#include "db/connection/connection.h"
#include "db/repository/people/people_repository.h"
#include "db/repository/people/person_data.h"

namespace torsio {

namespace {

bool isSimulated(SessionContext& session, const PersonId& personId) {
  const std::optional<Person> person = PeopleRepository(session.connection()).find(personId);
  return person && person->demonstration;
}

}  // namespace

bool mayEraseNow(SessionContext& session, const PersonId& personId) {
  return isSimulated(session, personId) || secondPersonIsThere(session, DutyAct::kErase, personId);
}

void eraseGuarded(SessionContext& session, const PersonId& personId, const std::string& reason) {
  Transaction transaction(session.connection());
  if (!isSimulated(session, personId)) {
    requireSecondPerson(session, DutyAct::kErase, personId);
  }
  erasePerson(session.connection(), personId, session.actor().userId, reason, session.now_us());
  transaction.commit();
}

}  // namespace torsio
