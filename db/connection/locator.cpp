// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/connection/locator.h"

#include <algorithm>

#include <QUrl>
#include <QUrlQuery>

#include "sim/base/error.h"

namespace torsio {

namespace {

bool plainName(const std::string& name) {
  return std::all_of(name.begin(), name.end(),
                     [](char c) { return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_'; });
}

}  // namespace

std::string Locator::shown() const {
  if (engine == Engine::kSqlite) {
    return file;
  }
  return "postgresql://" + host + ":" + std::to_string(port) + "/" + database +
         (schema.empty() ? "" : "?schema=" + schema);
}

Locator parseLocator(const std::string& text) {
  Locator locator;
  if (!text.starts_with("postgresql://") && !text.starts_with("postgres://")) {
    if (text.empty()) {
      throw Error(ErrorCode::kBadParameter, Text::tr("no database was named"), "",
                  Text::tr("Give the path of a database file"));
    }
    locator.file = text;
    return locator;
  }
  const QUrl url(QString::fromStdString(text), QUrl::StrictMode);
  locator.engine = Engine::kPostgresql;
  locator.user = url.userName(QUrl::FullyDecoded).toStdString();
  locator.password = url.password(QUrl::FullyDecoded).toStdString();
  locator.host = url.host(QUrl::FullyDecoded).toStdString();
  locator.port = url.port(locator.port);
  locator.database = url.path(QUrl::FullyDecoded).mid(1).toStdString();
  locator.schema = QUrlQuery(url).queryItemValue(QStringLiteral("schema")).toStdString();
  if (!url.isValid() || locator.host.empty() || locator.database.empty()) {
    throw Error(ErrorCode::kBadParameter, Text::tr("not a PostgreSQL address"), Text::tr("database"),
                Text::tr("Write it as postgresql://user:password@host:port/database"));
  }
  if (!plainName(locator.schema)) {
    throw Error(ErrorCode::kBadParameter, Text::tr("schema name is not allowed"), locator.shown(),
                Text::tr("Use lower-case letters, digits and underscores only"));
  }
  return locator;
}

}  // namespace torsio
