// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/people/person_requests.h"

#include <algorithm>

#include <nlohmann/json.hpp>

#include "db/connection/connection.h"
#include "db/repository/base/id_source.h"
#include "db/repository/people/request_repository.h"
#include "sim/core/error.h"

namespace torsio {

namespace {

void close(SessionContext& session, const std::string& requestId, PersonRequestAnswer answer,
           const std::string& reason) {
  Transaction transaction(session.connection());
  RequestRepository(session.connection()).answer(requestId, answer, reason, session.now_us());
  session.note(AuditAction::kPersonRequestAnswer, AuditObject::kPersonRequest, requestId,
               {{"answer", storedText(answer)}}, reason);
  transaction.commit();
}

}  // namespace

void requestAboutOwnRecord(SessionContext& session, PersonRequestKind kind) {
  session.require(Operation::kTrialViewOwn);
  if (session.actor().personId.empty()) {
    refuseParameter(Text::tr("you are nobody of the record"), session.actor().login,
                    Text::tr("Sign in as a trainee"));
  }
  for (const PersonRequest& earlier : ownRequests(session)) {
    if (earlier.kind == kind && !earlier.answer) {
      refuseParameter(Text::tr("you have asked for this already"), earlier.id,
                      Text::tr("Wait for the answer, or take it back"));
    }
  }
  const PersonRequest request{.id = session.ids().newUuid(),
                              .personId = session.actor().personId,
                              .kind = kind,
                              .askedUtc_us = session.now_us()};
  Transaction transaction(session.connection());
  RequestRepository(session.connection()).add(request);
  session.note(AuditAction::kPersonRequest, AuditObject::kPersonRequest, request.id,
               {{"kind", storedText(kind)}});
  transaction.commit();
}

void takeBackOwnRequest(SessionContext& session, const std::string& requestId) {
  session.require(Operation::kTrialViewOwn);
  const std::vector<PersonRequest> own = ownRequests(session);
  if (std::none_of(own.begin(), own.end(), [&](const PersonRequest& one) { return one.id == requestId; })) {
    refuse(Text::tr("this is no request of yours"), requestId, Text::tr("Read the page again"));
  }
  close(session, requestId, PersonRequestAnswer::kTakenBack, {});
}

std::vector<PersonRequest> ownRequests(SessionContext& session) {
  session.require(Operation::kTrialViewOwn);
  std::vector<PersonRequest> own = RequestRepository(session.connection()).all();
  std::erase_if(own, [&](const PersonRequest& one) { return one.personId != session.actor().personId; });
  return own;
}

std::vector<PersonRequest> personRequests(SessionContext& session) {
  session.require(Operation::kPersonExport);
  return RequestRepository(session.connection()).all();
}

void answerPersonRequest(SessionContext& session, const std::string& requestId, bool done,
                         const std::string& reason) {
  session.require(Operation::kPersonExport);
  if (!done && reason.empty()) {
    refuseParameter(Text::tr("declining a request needs a reason"), requestId,
                    Text::tr("Say in a few words why"));
  }
  close(session, requestId, done ? PersonRequestAnswer::kDone : PersonRequestAnswer::kDeclined, reason);
}

}  // namespace torsio
