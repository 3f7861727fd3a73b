// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/connectors/xapi/lrs_client.h"

#include <utility>

#include <QEventLoop>
#include <QNetworkAccessManager>
#include <QNetworkReply>
#include <QNetworkRequest>
#include <QTimer>
#include <QUrl>
#include <QUrlQuery>

namespace torsio {

namespace {

constexpr int kLook_ms = 100;
constexpr qint64 kMaxAnswer_bytes = 1 << 20;

}  // namespace

struct LrsClient::Talk {
  QUrl statements;
  LrsKey key;
  std::chrono::milliseconds patience;
  const std::atomic<bool>* stop;
  QNetworkAccessManager network{};

  [[nodiscard]] QNetworkRequest request(const QUrl& url) const {
    QNetworkRequest request(url);
    request.setHeader(QNetworkRequest::ContentTypeHeader, QStringLiteral("application/json"));
    request.setRawHeader("X-Experience-API-Version", "1.0.3");
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

}  // namespace torsio
