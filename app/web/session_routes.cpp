// SPDX-License-Identifier: GPL-3.0-or-later
// Browser sessions: listed and ended by their owner and by user managers.
#include <cstdint>
#include <string>

#include "app/services/access/access_service.h"
#include "app/web/router.h"
#include "app/web/web_desk.h"
#include "sim/core/error.h"

namespace torsio::web {

namespace {

using nlohmann::json;

constexpr std::size_t kLongestId = 100;

json sessionsJson(const Call& call, bool ofAll) {
  json lines = json::array();
  for (const WebSessions::Line& line : call.desk.sessions().list(call.now)) {
    if (!ofAll && line.userId != call.session->userId) {
      continue;
    }
    json one{{"id", line.id},
             {"browser", line.browser},
             {"begun_s", line.age.count()},
             {"idle_s", line.idle.count()},
             {"this", line.id == call.session->id}};
    if (ofAll) {
      one["login"] = line.login;
    }
    lines.push_back(std::move(one));
  }
  return {{"sessions", std::move(lines)}};
}

HttpResponse answerOwnSessions(Call& call) {
  return jsonAnswer(sessionsJson(call, false));
}

HttpResponse answerAll(Call& call) {
  requireSessionsOfOthers(call.context);
  return jsonAnswer(sessionsJson(call, true));
}

/// Returns the session named `id` among those that the caller may end.
WebSessions::Line lineOf(Call& call, bool ofAll) {
  const std::string id = call.body.text("id", kLongestId);
  for (WebSessions::Line& line : call.desk.sessions().list(call.now)) {
    if (line.id == id && (ofAll || line.userId == call.session->userId)) {
      return std::move(line);
    }
  }
  refuseParameter(Text::tr("this session is over"), "", Text::tr("Read the list again"));
}

HttpResponse answerEndOwn(Call& call) {
  call.desk.sessions().end(lineOf(call, false).id);
  return jsonAnswer(sessionsJson(call, false));
}

HttpResponse answerEndAny(Call& call) {
  requireSessionsOfOthers(call.context);
  const WebSessions::Line line = lineOf(call, true);
  noteEndedSessions(call.context, line.userId);
  call.desk.sessions().end(line.id);
  return jsonAnswer(sessionsJson(call, true));
}

}  // namespace

std::vector<Route> sessionRoutes() {
  constexpr auto kIn = RouteAccess::kSignedIn;
  return {{"GET", "/api/sessions", kIn, answerOwnSessions},
          {"POST", "/api/sessions/end", kIn, answerEndOwn},
          {"GET", "/api/all-sessions", kIn, answerAll},
          {"POST", "/api/all-sessions/end", kIn, answerEndAny}};
}

}  // namespace torsio::web
