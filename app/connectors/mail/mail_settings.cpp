// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/connectors/mail/mail_settings.h"

#include <algorithm>
#include <array>
#include <cctype>

#include <nlohmann/json.hpp>

#include "app/services/access/centre_settings.h"
#include "db/connection/connection.h"
#include "db/repository/system/setting_repository.h"
#include "sim/core/error.h"

namespace torsio {

namespace {

constexpr std::array kEncryptions{"starttls", "tls", "none"};  // indexed by MailEncryption

}  // namespace

std::optional<MailSettings> mailSettings(SessionContext& session) {
  session.require(Operation::kStudySetup);
  const std::string stored = centreSetting<kMailServer>(session.connection());
  const nlohmann::json json = nlohmann::json::parse(stored, nullptr, false);
  if (!json.is_object() || json.value("host", "").empty()) {
    return std::nullopt;
  }
  MailSettings settings;
  settings.server.host = json.value("host", "");
  settings.server.port = json.value("port", settings.server.port);
  const auto encryption = std::find(kEncryptions.begin(), kEncryptions.end(), json.value("encryption", ""));
  settings.server.encryption = encryption == kEncryptions.end()
                                   ? MailEncryption::kStartTls
                                   : static_cast<MailEncryption>(encryption - kEncryptions.begin());
  settings.server.user = json.value("user", "");
  settings.from = json.value("from", "");
  return settings;
}

void setMailSettings(SessionContext& session, const MailSettings& settings) {
  session.require(Operation::kSettingsEdit);
  const std::string& host = settings.server.host;
  if (host.empty()) {
    setCentreSetting<kMailServer>(session, "");
    return;
  }
  if (std::any_of(host.begin(), host.end(), [](unsigned char letter) { return std::isspace(letter) != 0; })) {
    refuseParameter(Text::tr("this is no name of a server"), host,
                    Text::tr("Write it like mail.example.org"));
  }
  checkAddress(settings.from);
  requireProtectedWay(settings.server);
  setCentreSetting<kMailServer>(
      session,
      nlohmann::json{{"host", host},
                     {"port", settings.server.port},
                     {"encryption", kEncryptions[static_cast<std::size_t>(settings.server.encryption)]},
                     {"user", settings.server.user},
                     {"from", settings.from}}
          .dump());
}

}  // namespace torsio
