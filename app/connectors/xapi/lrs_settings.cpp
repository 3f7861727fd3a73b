// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/connectors/xapi/lrs_settings.h"

#include <array>
#include <filesystem>
#include <string_view>
#include <system_error>
#include <utility>

#include <QByteArray>
#include <QFileInfo>
#include <QSettings>
#include <QUrl>
#include <nlohmann/json.hpp>

#include "app/outputs/tables/pseudonyms.h"
#include "app/services/access/centre_settings.h"
#include "app/services/base/this_computer.h"
#include "assessment/domain/people/learning_event.h"
#include "db/connection/connection.h"
#include "db/repository/system/setting_repository.h"
#include "sim/core/error.h"
#include "sim/core/file_io.h"

namespace torsio {

namespace {

namespace fs = std::filesystem;

/// Next to the other settings of this account.
fs::path keyFile() {
  const QSettings settings(QSettings::IniFormat, QSettings::UserScope, QStringLiteral("torsio"),
                           QStringLiteral("lrs"));
  return fs::path(QFileInfo(settings.fileName()).absolutePath().toStdString()) / "lrs.key";
}

void requireAddress(const std::string& address, bool protectedWay) {
  const QUrl url(QString::fromStdString(address), QUrl::StrictMode);
  const bool web = url.scheme() == QLatin1String("https") || url.scheme() == QLatin1String("http");
  if (!url.isValid() || !web || url.host().isEmpty() || url.hasQuery() || url.hasFragment() ||
      !url.userInfo().isEmpty()) {
    refuseParameter(Text::tr("not an address of a web server"), address,
                    Text::tr("Write it like https://lrs.example.org/xapi"));
  }
  if (protectedWay && url.scheme() == QLatin1String("http") && !isThisComputer(url.host().toStdString())) {
    refuseParameter(Text::tr("without encryption learning records go to a server on this computer only"),
                    address, Text::tr("Use an address that begins with https://"));
  }
}

}  // namespace

std::optional<LrsIdentity> lrsIdentity(Connection& connection) {
  const nlohmann::json json =
      nlohmann::json::parse(centreSetting<kLearningRecordStore>(connection), nullptr, false);
  if (!json.is_object()) {
    return std::nullopt;
  }
  LrsIdentity identity;
  identity.settings.on = centreSetting<kLearningRecords>(connection);
  identity.settings.endpoint = json.value("endpoint", "");
  identity.settings.homePage = json.value("home_page", "");
  identity.accountKey = json.value("account_key", "");
  return identity;
}

LrsSettings lrsSettings(SessionContext& session) {
  session.require(Operation::kSettingsEdit);
  const std::optional<LrsIdentity> identity = lrsIdentity(session.connection());
  return identity ? identity->settings : LrsSettings{};
}

void setLrsSettings(SessionContext& session, const LrsSettings& settings) {
  session.require(Operation::kSettingsEdit);
  Connection& connection = session.connection();
  const std::optional<LrsIdentity> known = lrsIdentity(connection);
  if (settings.on || !settings.endpoint.empty()) {
    requireAddress(settings.endpoint, true);
    requireAddress(settings.homePage, false);
  }
  Transaction transaction(connection);
  if (!settings.endpoint.empty()) {
    const nlohmann::json json{{"endpoint", settings.endpoint},
                              {"home_page", settings.homePage},
                              {"account_key", known ? known->accountKey : Pseudonyms::freshKey()}};
    setCentreSetting<kLearningRecordStore>(session, json.dump());
  }
  setCentreSetting<kLearningRecords>(session, settings.on);
  transaction.commit();
}

std::optional<LrsKey> stationLrsKey() {
  const fs::path file = keyFile();
  std::error_code unknown;
  if (!fs::exists(file, unknown)) {
    return std::nullopt;
  }
  if (makePrivate(file)) {
    throw Error(ErrorCode::kPermission,
                Text::tr("other accounts of this computer could read this key until now"), file.string(),
                Text::tr("Ask the learning record store for a new one"));
  }
  const std::string text = readFile(file);
  const std::size_t end = text.find('\n');
  if (end == std::string::npos || end == 0) {
    throw Error(ErrorCode::kBadData, Text::tr("is not a key of a learning record store"), file.string(),
                Text::tr("Set it again"));
  }
  LrsKey key{text.substr(0, end), text.substr(end + 1)};
  if (!key.secret.empty() && key.secret.back() == '\n') {
    key.secret.pop_back();
  }
  return key;
}

void setStationLrsKey(const LrsKey& key) {
  const fs::path file = keyFile();
  if (key.user.empty()) {
    std::error_code gone;
    fs::remove(file, gone);
    return;
  }
  if (key.user.find_first_of(":\r\n") != std::string::npos ||
      key.secret.find_first_of("\r\n") != std::string::npos || key.secret.empty()) {
    refuseParameter(Text::tr("not a name and secret for a learning record store"), key.user,
                    Text::tr("Enter both as the store shows them, the name without a colon"));
  }
  ensureFolder(file.parent_path());
  writeFileAtomically(file, key.user + "\n" + key.secret + "\n");
  (void)makePrivate(file);
}

namespace {

constexpr std::size_t kMaxAnswer_bytes = 1 << 20;
/// Versions that this client speaks, the preferred one first, with the beginning of those they stand for.
constexpr std::array<std::string_view, 2> kVersions{"1.0.3", "2.0.0"};
constexpr std::size_t kSameVersion = 4;  // "1.0." and "2.0."

}  // namespace

LrsClient::LrsClient(const std::string& endpoint, LrsKey key, std::chrono::milliseconds patience,
                     const std::atomic<bool>* stop)
    : endpoint_(QUrl(QString::fromStdString(endpoint + (endpoint.ends_with('/') ? "" : "/")))
                    .toEncoded()
                    .toStdString()),
      key_(std::move(key)),
      patience_(patience),
      stop_(stop),
      version_(kVersions.front()) {}

WebAnswer LrsClient::ask(const std::string& place, std::optional<std::string> body) const {
  const QByteArray who = QByteArray::fromStdString(key_.user + ":" + key_.secret).toBase64();
  return askWeb(
      {.address = endpoint_ + place,
       .headers = {"Content-Type: application/json", "X-Experience-API-Version: " + std::string(version_),
                   "Authorization: Basic " + who.toStdString()},
       .body = std::move(body),
       .patience = patience_,
       .most_bytes = kMaxAnswer_bytes,
       .stop = stop_});
}

WebAnswer LrsClient::post(const std::string& statement) const {
  return ask("statements", statement);
}

WebAnswer LrsClient::get(const std::string& id) const {
  return ask("statements?statementId=" + QUrl::toPercentEncoding(QString::fromStdString(id)).toStdString(),
             std::nullopt);
}

bool LrsClient::changeVersion() {
  if (std::exchange(asked_, true)) {
    return false;
  }
  const WebAnswer answer = ask("about", std::nullopt);
  const nlohmann::json said = nlohmann::json::parse(answer.body, nullptr, false);
  const auto known = said.is_object() ? said.find("version") : said.end();
  if (answer.status != 200 || known == said.end() || !known->is_array()) {
    return false;
  }
  for (const std::string_view mine : kVersions) {
    for (const nlohmann::json& theirs : *known) {
      if (theirs.is_string() &&
          theirs.get_ref<const std::string&>().starts_with(mine.substr(0, kSameVersion))) {
        return std::exchange(version_, mine) != mine;
      }
    }
  }
  return false;
}

}  // namespace torsio
