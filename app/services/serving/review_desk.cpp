// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/serving/review_desk.h"

#include <chrono>
#include <thread>
#include <utility>

#ifndef _WIN32
#include <cerrno>
#include <csignal>
#endif

#include <QCoreApplication>
#include <QHostAddress>
#include <QProcess>
#include <QTcpServer>
#include <nlohmann/json.hpp>

#include "app/services/access/centre_settings.h"
#include "app/services/access/invitations.h"
#include "db/connection/locator.h"
#include "sim/core/digest.h"
#include "sim/core/error.h"
#include "sim/core/file_io.h"
#include "sim/core/file_lock.h"

namespace torsio {

namespace {

constexpr const char* kDeskSetting = "review_desk";
constexpr std::chrono::milliseconds kLook(100);
constexpr std::chrono::seconds kPatience(30);
constexpr std::size_t kNameDigits = 16;

/// State written by `torsio serve --state`.
struct Notice {
  std::int64_t process = 0;
  OpenReviewDesk desk;
};

std::filesystem::path noticeOf(const SessionContext& session, const DeskPlace& place) {
  Digest digest;
  digest.update(std::string_view(session.key().locator));
  return place.folder / ("desk-" + digest.hex().substr(0, kNameDigits) + ".json");
}

std::filesystem::path logOf(const std::filesystem::path& notice) {
  std::filesystem::path log = notice;
  return log.replace_extension(".log");
}

std::optional<Notice> readNotice(const std::filesystem::path& file) {
  if (!std::filesystem::exists(file) || FileLock(lockNameOf(file)).held()) {
    return std::nullopt;  // unlocked: left over from a killed process
  }
  const nlohmann::json said = nlohmann::json::parse(readFile(file), nullptr, false);
  if (!said.is_object()) {
    return std::nullopt;
  }
  Notice notice;
  notice.process = said.value("process", std::int64_t{0});
  notice.desk.addresses = said.value("addresses", std::vector<std::string>{});
  notice.desk.fingerprint = said.value("fingerprint", std::string());
  notice.desk.goesOn = said.value("ends_with", std::int64_t{0}) == 0;
  return notice;
}

#ifdef _WIN32

// `torsio serve` is not built on this system: app/CMakeLists.txt.
constexpr bool kServes = false;

bool lives(std::int64_t) {
  return false;
}

void requestProcessEnd(std::int64_t) {}

#else

constexpr bool kServes = true;

bool lives(std::int64_t process) {
  return kill(static_cast<pid_t>(process), 0) == 0 || errno != ESRCH;
}

void requestProcessEnd(std::int64_t process) {
  kill(static_cast<pid_t>(process), SIGTERM);
}

#endif

std::string lastLine(const std::filesystem::path& file) {
  std::string text = std::filesystem::exists(file) ? readFile(file) : std::string();
  while (!text.empty() && text.back() == '\n') {
    text.pop_back();
  }
  return text.substr(text.rfind('\n') == std::string::npos ? 0 : text.rfind('\n') + 1);
}

void requireFree(const DeskWish& wish) {
  QTcpServer probe;
  if (!probe.listen(
          wish.otherMachines ? QHostAddress(QHostAddress::AnyIPv4) : QHostAddress(QHostAddress::LocalHost),
          wish.port)) {
    refuseParameter(Text::tr("another program uses this port"), std::to_string(wish.port),
                    Text::tr("Choose another one, or close that program"));
  }
}

QStringList argumentsFor(const SessionContext& session, const DeskPlace& place, const DeskWish& wish,
                         const std::filesystem::path& notice) {
  const auto text = [](const std::filesystem::path& path) { return QString::fromStdString(path.string()); };
  const QString host = QLatin1String(wish.otherMachines ? "0.0.0.0" : "127.0.0.1");
  QStringList arguments{QStringLiteral("serve"),      QStringLiteral("--quiet"),
                        QStringLiteral("--database"), QString::fromStdString(session.key().locator),
                        QStringLiteral("--listen"),   QStringLiteral("%1:%2").arg(host).arg(wish.port),
                        QStringLiteral("--state"),    text(notice)};
  if (!wish.certificate.empty()) {
    arguments << QStringLiteral("--certificate") << text(wish.certificate) << QStringLiteral("--key")
              << text(wish.key);
  } else if (wish.otherMachines) {
    arguments << QStringLiteral("--own-certificate") << text(place.folder);
  }
  if (!wish.goesOn) {
    arguments << QStringLiteral("--ends-with") << QString::number(QCoreApplication::applicationPid());
  }
  return arguments;
}

/// Starts the server and waits for its notice.
Notice startedDesk(const SessionContext& session, const DeskPlace& place, const DeskWish& wish) {
  const std::filesystem::path file = noticeOf(session, place);
  ensureFolder(place.folder);
  QProcess program;
  program.setProgram(QString::fromStdString(place.program.string()));
  program.setArguments(argumentsFor(session, place, wish, file));
  const QString log = QString::fromStdString(logOf(file).string());
  program.setStandardOutputFile(log);
  program.setStandardErrorFile(log, QIODevice::Append);
  program.setStandardInputFile(QProcess::nullDevice());
  qint64 process = 0;
  const bool begun = program.startDetached(&process);
  for (const auto from = std::chrono::steady_clock::now();
       begun && std::chrono::steady_clock::now() - from < kPatience; std::this_thread::sleep_for(kLook)) {
    if (auto notice = readNotice(file)) {
      return std::move(*notice);
    }
    if (!lives(process)) {
      break;
    }
  }
  if (begun && lives(process)) {
    requestProcessEnd(process);
  }
  throw Error(ErrorCode::kFileUnreadable, Text::tr("the review desk did not open"), lastLine(logOf(file)),
              Text::tr("Check its last message, correct the problem and try again"));
}

}  // namespace

bool mayOpenReviewDesk(SessionContext& session) {
  session.require(Operation::kSettingsEdit);
  const Locator locator = parseLocator(session.key().locator);
  return kServes && locator.engine == Engine::kSqlite && locator.file != ":memory:";
}

std::optional<OpenReviewDesk> openReviewDesk(SessionContext& session, const DeskPlace& place) {
  session.require(Operation::kSettingsEdit);
  auto notice = readNotice(noticeOf(session, place));
  return notice ? std::optional(std::move(notice->desk)) : std::nullopt;
}

void startReviewDesk(SessionContext& session, const DeskPlace& place, const DeskWish& wish) {
  if (!mayOpenReviewDesk(session)) {
    refuseParameter(Text::tr("this record is on a server"), "",
                    Text::tr("The server's administrator opens the review desk there with torsio serve"));
  }
  if (openReviewDesk(session, place)) {
    refuseParameter(Text::tr("the review desk is open already"), "", Text::tr("Close it first"));
  }
  if (wish.certificate.empty() != wish.key.empty()) {
    refuseParameter(Text::tr("certificate and key belong together"), "", Text::tr("Choose both files"));
  }
  requireFree(wish);
  const Notice notice = startedDesk(session, place, wish);
  const std::string address = notice.desk.addresses.empty() ? "" : notice.desk.addresses.front();
  noteSetting(session, kDeskSetting, {{"value", ""}}, {{"value", address}});
  if (!address.empty() && session.may(Operation::kUserManage) && browserAddress(session).empty()) {
    setBrowserAddress(session, address);
  }
}

void stopReviewDesk(SessionContext& session, const DeskPlace& place) {
  session.require(Operation::kSettingsEdit);
  const std::filesystem::path file = noticeOf(session, place);
  const std::optional<Notice> notice = readNotice(file);
  if (!notice) {
    return;
  }
  requestProcessEnd(notice->process);
  for (const auto from = std::chrono::steady_clock::now();
       readNotice(file) && std::chrono::steady_clock::now() - from < kPatience;) {
    std::this_thread::sleep_for(kLook);
  }
  const std::string was = notice->desk.addresses.empty() ? "" : notice->desk.addresses.front();
  noteSetting(session, kDeskSetting, {{"value", was}}, {{"value", ""}});
}

}  // namespace torsio
