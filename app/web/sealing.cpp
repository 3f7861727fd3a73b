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

Text meaningText(SignatureMeaning meaning) {
  return termsOf(meaning)[static_cast<std::size_t>(meaning)].label;
}

/// Checks the password sent with a sealing act. Empty answer: continue.
std::optional<HttpResponse> shownPassword(Call& call) {
  if (!call.body.has("password")) {
    return std::nullopt;
  }
  const std::string password = call.body.text("password", kLongestPassword_bytes);
  if (!call.desk.enterHashing()) {
    return refusal(503,
                   Error(ErrorCode::kDatabase, Text::tr("the server is busy"), "",
                         Text::tr("Try again in a few seconds")),
                   call.wording);
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
                   {{"need_password", true}, {"meaning", call.wording(meaningText(meaning)).toStdString()}});
  }
}

HttpResponse binaryAnswer(const Call& call, const std::string& packed) {
  HttpResponse response;
  response.type = "application/octet-stream";
  response.headers = {{"Cache-Control", "no-store"}};
  putPacked(response, call.request, packed, nullptr);
  return response;
}

HttpResponse organAnswer(const Call& call, const CasePicture& picture) {
  if (picture.organ.empty()) {
    return refusal(404,
                   Error(ErrorCode::kBadData, Text::tr("the organ of this recording is not on this machine"),
                         "", Text::tr("Score from the traces, or ask an administrator for the organ file")),
                   call.wording);
  }
  return binaryAnswer(call, picture.organ);
}

}  // namespace torsio::web
