// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/web/sealing.h"

#include <cstddef>
#include <optional>
#include <string>
#include <utility>

#include "app/services/access/signing.h"
#include "app/web/page_files.h"
#include "app/web/web_desk.h"
#include "sim/core/error.h"

namespace torsio::web {

namespace {

constexpr std::size_t kLongestPassword_bytes = 1024;

/// Checks the password sent with a sealing act. Empty answer: continue.
std::optional<HttpResponse> shownPassword(Call& call) {
  if (!call.body.has("password")) {
    return std::nullopt;
  }
  const std::string password = call.body.text("password", kLongestPassword_bytes);
  if (!call.desk.enterHashing()) {
    return refusal(call, 503, ErrorCode::kDatabase, Text::tr("the server is busy"),
                   Text::tr("Try again in a few seconds"));
  }
  struct Leave {
    WebDesk& desk;
    ~Leave() { desk.leaveHashing(); }
  } leave{call.desk};
  showPassword(call.context, password);
  return std::nullopt;
}

}  // namespace

HttpResponse sealing(Call& call, SignatureMeaning meaning, const std::function<HttpResponse()>& act) {
  try {
    if (auto busy = shownPassword(call)) {
      return std::move(*busy);
    }
    return act();
  } catch (const PasswordDue& due) {
    return refusal(403, due, call.wording,
                   {{"need_password", true}, {"meaning", said(call, labelOf(meaning))}});
  }
}

HttpResponse binaryAnswer(const Call& call, const std::string& packed) {
  HttpResponse response;
  response.type = "application/octet-stream";
  response.headers = {{"Cache-Control", "no-store"}};
  putPacked(response, call.request, packed, nullptr);
  return response;
}

std::vector<Route> withPicture(std::vector<Route> routes, const std::string& path,
                               std::shared_ptr<const CasePicture> (*picture)(Call&)) {
  const auto recording = [picture](Call& call) { return binaryAnswer(call, picture(call)->recording); };
  const auto organ = [picture](Call& call) {
    const std::shared_ptr<const CasePicture> shown = picture(call);
    if (shown->organ.empty()) {
      return refusal(call, 404, ErrorCode::kBadData,
                     Text::tr("the organ of this recording is not on this machine"),
                     Text::tr("Score from the traces, or ask an administrator for the organ file"));
    }
    return binaryAnswer(call, shown->organ);
  };
  routes.push_back({"GET", path + "/recording", RouteAccess::kSignedIn, recording, true});
  routes.push_back({"GET", path + "/organ", RouteAccess::kSignedIn, organ, true});
  return routes;
}

}  // namespace torsio::web
