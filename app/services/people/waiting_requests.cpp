// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/people/waiting_requests.h"

#include <algorithm>
#include <vector>

#include "app/services/access/two_people.h"
#include "app/services/people/consent_service.h"

namespace torsio {

WaitingRequests waitingRequests(SessionContext& session) {
  WaitingRequests waiting;
  if (session.may(Operation::kUserManage) || session.may(Operation::kAllocationReveal)) {
    const std::vector<OpenRequest> open = openRequests(session);
    waiting.toConfirm = static_cast<std::size_t>(
        std::count_if(open.begin(), open.end(), [](const OpenRequest& one) { return one.mayConfirm; }));
  }
  if (session.may(Operation::kPersonExport)) {
    const std::vector<PersonRequest> asked = personRequests(session);
    waiting.ofPeople = static_cast<std::size_t>(
        std::count_if(asked.begin(), asked.end(), [](const PersonRequest& one) { return !one.answer; }));
  }
  return waiting;
}

Text toConfirmWords(std::size_t count) {
  if (count == 0) {
    return {};
  }
  return count == 1 ? Text::tr("A request waits for you as the second person: Users, Requests")
                    : Text::tr("%1 requests wait for you as the second person: Users, Requests", count);
}

Text waitingMailSubject(const std::string& centre) {
  return centre.empty() ? Text::tr("Torsio: requests wait for a second person")
                        : Text::tr("Torsio at %1: requests wait for a second person", centre);
}

Text waitingMailWords(const std::string& centre, const std::string& askedBy, std::size_t count) {
  const Text where = centre.empty() ? Text(std::string("Torsio")) : Text::tr("Torsio at %1", centre);
  return Text::tr(
      "%1 asks in %2 for what needs two people. Requests that wait: %3. Please look at them under Users, "
      "Requests, and confirm or decline them within two weeks.",
      askedBy, where, count);
}

}  // namespace torsio
