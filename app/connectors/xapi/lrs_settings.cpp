// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/connectors/xapi/lrs_settings.h"

#include <array>
#include <filesystem>
#include <string_view>
#include <system_error>
#include <utility>

#include <QEventLoop>
#include <QFileInfo>
#include <QNetworkAccessManager>
#include <QNetworkReply>
#include <QNetworkRequest>
#include <QSettings>
#include <QTimer>
#include <QUrl>
#include <QUrlQuery>
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

constexpr int kLook_ms = 100;
constexpr qint64 kMaxAnswer_bytes = 1 << 20;
/// Versions that this client speaks, the preferred one first, with the beginning of those they stand for.
constexpr std::array<const char*, 2> kVersions{"1.0.3", "2.0.0"};
constexpr std::size_t kSameVersion = 4;  // "1.0." and "2.0."

}  // namespace

struct LrsClient::Talk {
  QUrl statements;
  LrsKey key;
  std::chrono::milliseconds patience;
  const std::atomic<bool>* stop;
  QNetworkAccessManager network{};
  QByteArray version = kVersions.front();
  bool asked = false;  // for its versions

  [[nodiscard]] QNetworkRequest request(const QUrl& url) const {
    QNetworkRequest request(url);
    request.setHeader(QNetworkRequest::ContentTypeHeader, QStringLiteral("application/json"));
    request.setRawHeader("X-Experience-API-Version", version);
    request.setRawHeader("Authorization",
                         "Basic " + QByteArray::fromStdString(key.user + ":" + key.secret).toBase64());
    request.setAttribute(QNetworkRequest::RedirectPolicyAttribute, QNetworkRequest::ManualRedirectPolicy);
    request.setAttribute(QNetworkRequest::AuthenticationReuseAttribute, QNetworkRequest::Manual);
    request.setTransferTimeout(static_cast<int>(patience.count()));
    return request;
  }

  /// Waits for the reply in a local event loop.
  [[nodiscard]] LrsAnswer heard(std::unique_ptr<QNetworkReply> reply) const {
    QEventLoop loop;
    QTimer look;
    const auto giveUp = [&] { reply->abort(); };
    QObject::connect(reply.get(), &QNetworkReply::finished, &loop, &QEventLoop::quit);
    QObject::connect(reply.get(), &QNetworkReply::readyRead, &loop, [&] {
      if (reply->bytesAvailable() > kMaxAnswer_bytes) {
        giveUp();
      }
    });
    QObject::connect(&look, &QTimer::timeout, &loop, [&] {
      if (stop != nullptr && stop->load()) {
        giveUp();
      }
    });
    QTimer::singleShot(patience, &loop,
                       giveUp);  // deadline for slow responses: the idle timeout resets on every byte
    look.start(kLook_ms);
    if (!reply->isFinished()) {
      loop.exec();
    }
    LrsAnswer answer;
    const bool whole = reply->error() == QNetworkReply::NoError ||
                       reply->error() >= QNetworkReply::ContentAccessDenied;  // an HTTP error response
    if (whole) {
      answer.status = reply->attribute(QNetworkRequest::HttpStatusCodeAttribute).toInt();
    }
    answer.body = answer.status == 0 ? reply->errorString().toStdString() : reply->readAll().toStdString();
    answer.after = reply->rawHeader("Retry-After").toStdString();
    return answer;
  }
};

LrsClient::LrsClient(const std::string& endpoint, LrsKey key, std::chrono::milliseconds patience,
                     const std::atomic<bool>* stop)
    : talk_(std::make_unique<Talk>()) {
  talk_->statements = QUrl(QString::fromStdString(endpoint + (endpoint.ends_with('/') ? "" : "/")) +
                           QStringLiteral("statements"));
  talk_->key = std::move(key);
  talk_->patience = patience;
  talk_->stop = stop;
}

LrsClient::~LrsClient() = default;

LrsAnswer LrsClient::post(const std::string& statement) {
  return talk_->heard(std::unique_ptr<QNetworkReply>(
      talk_->network.post(talk_->request(talk_->statements), QByteArray::fromStdString(statement))));
}

LrsAnswer LrsClient::get(const std::string& id) {
  QUrl url = talk_->statements;
  QUrlQuery query;
  query.addQueryItem(QStringLiteral("statementId"), QString::fromStdString(id));
  url.setQuery(query);
  return talk_->heard(std::unique_ptr<QNetworkReply>(talk_->network.get(talk_->request(url))));
}

bool LrsClient::changeVersion() {
  if (std::exchange(talk_->asked, true)) {
    return false;
  }
  QUrl about = talk_->statements;
  about.setPath(about.path().chopped(QStringLiteral("statements").size()) + QStringLiteral("about"));
  const LrsAnswer answer =
      talk_->heard(std::unique_ptr<QNetworkReply>(talk_->network.get(talk_->request(about))));
  const nlohmann::json said = nlohmann::json::parse(answer.body, nullptr, false);
  const auto known = said.is_object() ? said.find("version") : said.end();
  if (answer.status != 200 || known == said.end() || !known->is_array()) {
    return false;
  }
  for (const std::string_view mine : kVersions) {
    for (const nlohmann::json& theirs : *known) {
      if (theirs.is_string() &&
          theirs.get_ref<const std::string&>().starts_with(mine.substr(0, kSameVersion))) {
        const QByteArray chosen(mine.data(), static_cast<qsizetype>(mine.size()));
        return std::exchange(talk_->version, chosen) != chosen;
      }
    }
  }
  return false;
}

}  // namespace torsio
