// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/connection/locator.h"

#include <algorithm>
#include <array>
#include <system_error>
#include <utility>

#include <QUrl>
#include <QUrlQuery>

#include "sim/core/error.h"

namespace torsio {

namespace {

/// libpq parameters allowed in an address. None is secret.
constexpr std::array<std::string_view, 23> kServerParameters{"application_name",
                                                             "channel_binding",
                                                             "connect_timeout",
                                                             "gssencmode",
                                                             "hostaddr",
                                                             "keepalives",
                                                             "keepalives_count",
                                                             "keepalives_idle",
                                                             "keepalives_interval",
                                                             "krbsrvname",
                                                             "passfile",
                                                             "requirepeer",
                                                             "service",
                                                             "sslcert",
                                                             "sslcompression",
                                                             "sslcrl",
                                                             "sslkey",
                                                             "sslmode",
                                                             "sslrootcert",
                                                             "sslsni",
                                                             "ssl_min_protocol_version",
                                                             "target_session_attrs",
                                                             "tcp_user_timeout"};

constexpr std::array<std::string_view, 6> kTlsModes{"disable", "allow",     "prefer",
                                                    "require", "verify-ca", "verify-full"};

bool plainName(const std::string& name) {
  return std::all_of(name.begin(), name.end(),
                     [](char c) { return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_'; });
}

template <std::size_t Count>
std::string listOf(const std::array<std::string_view, Count>& names) {
  std::string list;
  for (const std::string_view name : names) {
    list.append(list.empty() ? "" : ", ").append(name);
  }
  return list;
}

void requireKnown(const std::string& name) {
  if (name == "password" || name == "sslpassword") {
    refuseParameter(Text::tr("an address does not hold the parameter %1", name), name,
                    Text::tr("Write the password to the password file of your account (~/.pgpass)"));
  }
  if (std::find(kServerParameters.begin(), kServerParameters.end(), name) == kServerParameters.end()) {
    refuseParameter(Text::tr("unknown connection parameter %1", name), name,
                    Text::tr("Allowed are schema, %1", listOf(kServerParameters)));
  }
}

void requireValue(const ServerParameter& parameter) {
  if (parameter.value.empty()) {
    refuseParameter(Text::tr("connection parameter %1 has no value", parameter.name), parameter.name,
                    Text::tr("Give it one, or leave it out"));
  }
  if (parameter.value.find_first_of(std::string(";\0\n\r", 4)) != std::string::npos) {
    refuseParameter(Text::tr("the value of connection parameter %1 cannot be used", parameter.name),
                    parameter.name, Text::tr("Choose a name or a path without semicolons and line breaks"));
  }
  if (parameter.name == "sslmode" &&
      std::find(kTlsModes.begin(), kTlsModes.end(), parameter.value) == kTlsModes.end()) {
    refuseParameter(Text::tr("sslmode cannot be %1", parameter.value), parameter.name,
                    Text::tr("Choose one of %1", listOf(kTlsModes)));
  }
}

void readParameters(const QUrl& url, Locator& locator) {
  bool schemaGiven = false;
  for (const auto& [key, value] : QUrlQuery(url).queryItems(QUrl::FullyDecoded)) {
    const ServerParameter parameter{key.toStdString(), value.toStdString()};
    const bool twice = parameter.name == "schema" ? std::exchange(schemaGiven, true)
                                                  : !locator.parameter(parameter.name).empty();
    if (twice) {
      refuseParameter(Text::tr("connection parameter %1 is given twice", parameter.name), parameter.name,
                      Text::tr("Leave one out"));
    }
    if (parameter.name == "schema") {
      locator.schema = parameter.value;
      continue;
    }
    requireKnown(parameter.name);
    requireValue(parameter);
    locator.parameters.push_back(parameter);
  }
}

}  // namespace

std::string Locator::shown() const {
  if (engine == Engine::kSqlite) {
    return file;
  }
  const std::string service = parameter("service");
  std::string address =
      "postgresql://" + host + (port > 0 ? ":" + std::to_string(port) : "") + "/" + database;
  if (!service.empty()) {
    address += "?service=" + service;
  }
  if (!schema.empty()) {
    address += (service.empty() ? "?schema=" : "&schema=") + schema;
  }
  return address;
}

std::string Locator::parameter(std::string_view name) const {
  const auto found = std::find_if(parameters.begin(), parameters.end(),
                                  [&](const ServerParameter& one) { return one.name == name; });
  return found == parameters.end() ? std::string() : found->value;
}

Locator parseLocator(const std::string& text) {
  Locator locator;
  if (!text.starts_with("postgresql://") && !text.starts_with("postgres://")) {
    if (text.empty()) {
      refuseParameter(Text::tr("no database was named"), "", Text::tr("Give the path of a database file"));
    }
    locator.file = text;
    return locator;
  }
  const QUrl url(QString::fromStdString(text), QUrl::StrictMode);
  locator.engine = Engine::kPostgresql;
  locator.user = url.userName(QUrl::FullyDecoded).toStdString();
  locator.password = url.password(QUrl::FullyDecoded).toStdString();
  locator.host = url.host(QUrl::FullyDecoded).toStdString();
  locator.database = url.path(QUrl::FullyDecoded).mid(1).toStdString();
  readParameters(url, locator);
  const bool service = !locator.parameter("service").empty();
  locator.port = url.port(service ? 0 : locator.port);
  if (!url.isValid() || url.hasFragment() ||
      (!service && (locator.host.empty() || locator.database.empty()))) {
    refuseParameter(Text::tr("not a PostgreSQL address"), Text::tr("database"),
                    Text::tr("Write it as postgresql://user@host:port/database?sslmode=verify-full"));
  }
  if (!plainName(locator.schema)) {
    refuseParameter(Text::tr("schema name is not allowed"), locator.shown(),
                    Text::tr("Use lower-case letters, digits and underscores only"));
  }
  return locator;
}

std::string addressOf(const Locator& server) {
  QUrl url;
  url.setScheme(QStringLiteral("postgresql"));
  url.setHost(QString::fromStdString(server.host));
  url.setPort(server.port > 0 ? server.port : -1);
  url.setPath(QLatin1Char('/') + QString::fromStdString(server.database), QUrl::DecodedMode);
  url.setUserName(QString::fromStdString(server.user), QUrl::DecodedMode);
  if (!server.password.empty()) {
    url.setPassword(QString::fromStdString(server.password), QUrl::DecodedMode);
  }
  std::vector<ServerParameter> parameters = server.parameters;
  if (!server.schema.empty()) {
    parameters.push_back({"schema", server.schema});
  }
  QString query;
  for (const ServerParameter& parameter : parameters) {
    query += (query.isEmpty() ? QString() : QStringLiteral("&")) + QString::fromStdString(parameter.name) +
             QLatin1Char('=') +
             QString::fromLatin1(QUrl::toPercentEncoding(QString::fromStdString(parameter.value)));
  }
  if (!query.isEmpty()) {
    url.setQuery(query, QUrl::StrictMode);
  }
  return url.toString(QUrl::FullyEncoded).toStdString();
}

namespace fs = std::filesystem;

void refuseReadOnly(const Text& what, const fs::path& path) {
  throw Error(ErrorCode::kFileUnwritable, what, path.string(),
              Text::tr("Choose a folder in which you may write, or open the database for reading only"));
}

namespace {

/// True if all write permissions were removed: then we do not write, even as root.
bool markedReadOnly(const fs::path& path) {
  constexpr auto kWrite = fs::perms::owner_write | fs::perms::group_write | fs::perms::others_write;
  std::error_code failed;
  const fs::file_status status = fs::status(path, failed);
  return !failed && fs::exists(status) && (status.permissions() & kWrite) == fs::perms::none;
}

}  // namespace

void requireUsableFile(const fs::path& file, OpenMode mode) {
  std::error_code ignored;
  const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
  if (fs::is_directory(file, ignored)) {
    throw Error(ErrorCode::kFileUnreadable, Text::tr("is a folder, not a database"), file.string(),
                Text::tr("Name a file in that folder"));
  }
  const bool exists = fs::exists(file, ignored);
  if (exists && !fs::is_regular_file(file, ignored)) {  // opening a pipe would block until somebody writes
    throw Error(ErrorCode::kFileUnreadable, Text::tr("is not a file, so it cannot be a database"),
                file.string(), Text::tr("Name a file"));
  }
  if (exists && fs::file_size(file, ignored) == 0) {
    throw Error(ErrorCode::kFileUnreadable,
                Text::tr("is empty, which no record ever is: something emptied it"), file.string(),
                Text::tr("Restore the latest backup, or delete the file if there never was a record here"));
  }
  if (!exists && fs::is_symlink(fs::symlink_status(file, ignored))) {
    throw Error(ErrorCode::kFileMissing, Text::tr("is a link to a file that is not there"), file.string(),
                Text::tr("Connect the disk that it is on, or remove the link"));
  }
  if (!exists && mode != OpenMode::kCreate) {
    throw Error(ErrorCode::kFileMissing, Text::tr("no such database"), file.string(),
                Text::tr("Check the path"));
  }
  if (!exists && !fs::is_directory(folder, ignored)) {
    throw Error(ErrorCode::kFileMissing, Text::tr("no such folder"), folder.string(),
                Text::tr("Create it, or choose another"));
  }
  if (mode == OpenMode::kReadOnly) {
    return;
  }
  if (exists && markedReadOnly(file)) {
    refuseReadOnly(Text::tr("database file is read-only"), file);
  }
  // The write-ahead log is a file beside the database, so the folder must be writable.
  if (markedReadOnly(folder)) {
    refuseReadOnly(Text::tr("folder is read-only"), folder);
  }
}

bool hasJournal(const std::string& file) {
  std::error_code failed;
  const std::uintmax_t size = std::filesystem::file_size(file + "-journal", failed);
  return !failed && size > 0;
}

}  // namespace torsio
