// SPDX-License-Identifier: GPL-3.0-or-later
// Invitation links: list, create, confirm, send, revoke. A link or code is contained in exactly one answer.
#include <algorithm>
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <QDateTime>

#include "app/connectors/mail/mailing.h"
#include "app/services/access/access_service.h"
#include "app/services/access/first_run.h"
#include "app/services/access/invitations.h"
#include "app/services/access/qr_code.h"
#include "app/services/access/two_people.h"
#include "app/services/people/waiting_requests.h"
#include "app/web/router.h"
#include "app/web/web_desk.h"
#include "sim/core/error.h"

namespace torsio::web {

namespace {

using nlohmann::json;

const char* const kUser = "user ";
const char* const kRequest = "request ";
constexpr std::size_t kMaxUsers = 1000;
constexpr std::size_t kLongestReason = 1000;
constexpr std::size_t kLongestPassword = 1024;
constexpr std::size_t kLongestHandle = 100;

HttpResponse answerInvitations(Call& call) {
  const std::map<UserId, std::int64_t> until = invitationsInForce(call.context);
  json people = json::array();
  for (const UserAccount& user : users(call.context)) {
    if (!user.active || user.id == call.context.actor().userId) {
      continue;
    }
    const auto open = until.find(user.id);
    people.push_back({{"user", call.session->handleFor(kUser + user.id.text())},
                      {"login", user.login},
                      {"by_two", passwordNeedsTwo(call.context, user)},
                      {"until_utc_us", open == until.end() ? json(nullptr) : json(open->second)}});
  }
  json waiting = json::array();
  for (const OpenRequest& open : openRequests(call.context)) {
    if (open.request.act == DutyAct::kInvite) {
      waiting.push_back({{"request", call.session->handleFor(kRequest + open.request.id)},
                         {"login", open.shown},
                         {"by", open.requestedBy},
                         {"reason", open.request.reason},
                         {"own", open.own}});
    }
  }
  return jsonAnswer({{"people", std::move(people)},
                     {"waiting", std::move(waiting)},
                     {"mail", canMailInvitations(call.context)}});
}

std::vector<UserId> usersOf(const Call& call) {
  std::vector<UserId> ids;
  for (const JsonBody& one : call.body.objects("users", kMaxUsers)) {
    const auto found = objectOf(call, one.text("user", kLongestHandle), kUser);
    if (!found) {
      refuseParameter(Text::tr("there is no such user"), "", Text::tr("Load the page again"));
    }
    ids.emplace_back(*found);
  }
  return ids;
}

/// "2026-12-03 14:05".
std::string timeText(std::int64_t utc_us) {
  return QDateTime::fromMSecsSinceEpoch(utc_us / 1000)
      .toString(QStringLiteral("yyyy-MM-dd HH:mm"))
      .toStdString();
}

/// Returns the desk's URL: as set by the centre, otherwise as in this request.
std::string deskAddress(const Call& call) {
  const std::string set = browserAddress(call.context);
  return set.empty() ? call.desk.addressFor(call.request) : set;
}

/// Tells the other administrators by mail of the invitations that they have to confirm, if requested. Returns
/// why that failed; empty: it succeeded; null: nothing to tell.
json toldOthers(Call& call, const std::vector<HandedInvitation>& handed, const std::string& centre) {
  const auto asked = static_cast<std::size_t>(std::count_if(
      handed.begin(), handed.end(), [](const HandedInvitation& one) { return !one.code.empty(); }));
  if (asked == 0 || !call.body.has("mail_password") || !canMailAdministrators(call.context)) {
    return nullptr;
  }
  try {
    const std::vector<Text> refusals =
        mailAdministrators(call.context, call.body.textOrNone("mail_password", kLongestPassword),
                           said(call, waitingMailSubject(centre)),
                           said(call, waitingMailWords(centre, call.context.actor().login, asked)) + "\n");
    for (const Text& refusal : refusals) {
      if (!refusal.empty()) {
        return said(call, refusal);
      }
    }
    return "";
  } catch (const Error& error) {  // the codes exist and are shown anyway
    return said(call, error.happenedText());
  }
}

/// Answers with the invitations and their cards, and mails them if requested. `problem`: why mailing failed;
/// empty: it succeeded.
HttpResponse handedOver(Call& call, const std::vector<HandedInvitation>& handed, bool confirmed) {
  const std::string centre = centreSign(call.context.connectionWithoutRight()).name;
  const std::string address = deskAddress(call);
  json cards = json::array();
  std::vector<MailedWord> mails;
  std::vector<std::size_t> whose;
  for (const HandedInvitation& one : handed) {
    const std::string link = one.secret.empty() ? "" : invitationLink(address, one.secret, confirmed);
    const std::string until = one.secret.empty() ? "" : timeText(one.expiresUtc_us);
    const std::string words = said(call, link.empty() ? invitationCodeWords(centre, one.code)
                                                      : invitationWords(centre, one.login, link, until));
    if (!link.empty()) {
      mails.push_back({one.userId, said(call, invitationSubject(centre)), words});
      whose.push_back(cards.size());
    }
    cards.push_back({{"login", one.login},
                     {"link", link},
                     {"qr", link.empty() ? std::vector<std::string>() : qrRows(link)},
                     {"code", one.code},
                     {"until", until},
                     {"words", words},
                     {"mail", nullptr}});
  }
  if (call.body.has("mail_password") && !mails.empty()) {
    const std::string password = call.body.textOrNone("mail_password", kLongestPassword);
    std::vector<Text> problems(mails.size());
    try {
      problems = sendInvitations(call.context, password, mails);
    } catch (const Error& error) {  // the links exist and are shown anyway
      std::fill(problems.begin(), problems.end(), error.happenedText());
    }
    for (std::size_t i = 0; i < problems.size(); ++i) {
      cards[whose[i]]["mail"] = said(call, problems[i]);
    }
  }
  return jsonAnswer(
      {{"centre", centre}, {"cards", std::move(cards)}, {"told", toldOthers(call, handed, centre)}});
}

HttpResponse answerInvite(Call& call) {
  return handedOver(
      call, inviteOrAsk(call.context, usersOf(call), call.body.textOrNone("reason", kLongestReason)), false);
}

HttpResponse answerConfirm(Call& call) {
  const auto id = objectOf(call, call.body.text("request", kLongestHandle), kRequest);
  return handedOver(call, {confirmInvitation(call.context, id.value_or(""))}, true);
}

HttpResponse answerRevoke(Call& call) {
  const std::vector<UserId> ids = usersOf(call);
  (void)revokeInvitations(call.context, ids, call.body.textOrNone("reason", kLongestReason));
  return answerInvitations(call);
}

}  // namespace

std::vector<Route> invitationRoutes() {
  constexpr auto kIn = RouteAccess::kSignedIn;
  // Routes that may send mail wait for a remote server.
  return {{"GET", "/api/invitations", kIn, answerInvitations},
          {"POST", "/api/invitations", kIn, answerInvite, true},
          {"POST", "/api/invitations/confirm", kIn, answerConfirm, true},
          {"POST", "/api/invitations/revoke", kIn, answerRevoke}};
}

}  // namespace torsio::web
