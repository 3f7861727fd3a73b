// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cerrno>
#include <chrono>
#include <condition_variable>
#include <csignal>
#include <cstdint>
#include <ctime>
#include <filesystem>
#include <iostream>
#include <memory>
#include <mutex>
#include <optional>
#include <pthread.h>
#include <string>
#include <system_error>
#include <thread>
#include <unistd.h>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>
#include <QString>
#include <QtGlobal>
#include <nlohmann/json.hpp>

#include "app/cli/commands.h"
#include "app/cli/options.h"
#include "app/services/access/session_context.h"
#include "app/services/access/station_name.h"
#include "app/services/base/assets.h"
#include "app/services/base/build_info.h"
#include "app/services/base/configuration.h"
#include "app/services/base/log.h"
#include "app/services/maintenance/interrupted_move.h"
#include "app/web/http_server.h"
#include "app/web/own_certificate.h"
#include "app/web/service_manager.h"
#include "app/web/web_desk.h"
#include "db/connection/connection.h"
#include "db/connection/db_error.h"
#include "sim/core/error.h"
#include "sim/core/file_io.h"
#include "sim/core/file_lock.h"

namespace torsio::cli {

namespace {

constexpr std::chrono::milliseconds kFirstPause(250);
constexpr std::chrono::milliseconds kLongestPause(2000);
constexpr std::chrono::seconds kLongestEnd(15);  // requests that were received have 10 s

struct ServeArguments {
  DatabaseOption database;
  std::string listen = "127.0.0.1:8443";
  std::string certificate;
  std::string key;
  std::string publicUrl;
  std::vector<std::string> hosts;
  std::string ownCertificate;
  std::string state;
  std::int64_t endsWith = 0;
  std::int64_t waitForDatabase_s = 300;
  bool quiet = false;
  bool metrics = false;
};

/// Names and marks are transmitted: beyond this machine only encrypted, by this server or a proxy in front of
/// it.
void requireEncryption(const ServeArguments& arguments, const web::HttpAddress& address) {
  const bool proxied = arguments.publicUrl.rfind("https://", 0) == 0;
  if (!arguments.publicUrl.empty() && !proxied) {
    refuseUsage("browsers reach the desk by https only", arguments.publicUrl,
                "Give --public-url https://... as the proxy is called, or leave it out");
  }
  if (arguments.certificate.empty() != arguments.key.empty()) {
    refuseUsage("certificate and key belong together", "", "Give both --certificate and --key");
  }
  if (!arguments.certificate.empty() && !arguments.ownCertificate.empty()) {
    refuseUsage("a desk has one certificate", "", "Give --own-certificate, or --certificate and --key");
  }
  if (arguments.certificate.empty() && arguments.ownCertificate.empty() && !proxied &&
      !address.isLoopback()) {
    refuseUsage("other machines would reach the desk without encryption", arguments.listen,
                "Give --certificate and --key, --own-certificate, or --public-url of a proxy "
                "that encrypts, or listen at 127.0.0.1");
  }
}

/// Signals that stop the server, blocked in every thread except the one that waits for them.
sigset_t endingSignals() {
  sigset_t signals;
  sigemptyset(&signals);
  sigaddset(&signals, SIGINT);
  sigaddset(&signals, SIGTERM);
  pthread_sigmask(SIG_BLOCK, &signals, nullptr);
  return signals;
}

/// Returns the URLs for browsers: for a desk on all interfaces, one for each name of this machine.
std::vector<std::string> addressesOf(const ServeArguments& arguments, const web::HttpAddress& address,
                                     bool encrypted, std::uint16_t port) {
  if (!arguments.publicUrl.empty()) {
    return {arguments.publicUrl};
  }
  std::vector<std::string> names{arguments.listen.substr(0, arguments.listen.rfind(':'))};
  if (address.host == "0.0.0.0" || address.host == "::") {
    names = web::machineNames();
  }
  std::vector<std::string> addresses;
  for (const std::string& name : names) {
    addresses.push_back((encrypted ? "https://" : "http://") + name + ":" + std::to_string(port) + "/");
  }
  return addresses;
}

/// Returns the names by which browsers may call the desk, besides numeric addresses.
std::vector<std::string> namesOf(const ServeArguments& arguments, const std::string& certificate) {
  std::vector<std::string> names = arguments.hosts;
  for (const std::string& name : web::namesIn(certificate)) {
    names.push_back(name);
  }
  for (const std::string& name : web::machineNames()) {
    names.push_back(name);
    names.push_back(name + ".local");
  }
  return names;
}

/// Waits; true: the server is to stop.
bool endsWithin(const sigset_t& signals, std::chrono::milliseconds time) {
  const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(time);
  const timespec wait{.tv_sec = seconds.count(), .tv_nsec = std::chrono::nanoseconds(time - seconds).count()};
  return sigtimedwait(&signals, nullptr, &wait) > 0;
}

/// Opens the record once, which must exist: the server never creates one. Waits for a database server that
/// cannot be reached, and logs each cause once. False: stopped by a signal. Throws DbError after the longest
/// wait.
bool waitForTheRecord(const ServeArguments& arguments, const std::string& locator, const sigset_t& signals) {
  using Clock = std::chrono::steady_clock;
  const Clock::time_point latest = Clock::now() + std::chrono::seconds(arguments.waitForDatabase_s);
  std::string logged;
  for (std::chrono::milliseconds pause = kFirstPause;; pause = std::min(2 * pause, kLongestPause)) {
    try {
      (void)openDatabase(locator, OpenMode::kReadWrite);
      return true;
    } catch (const DbError& error) {
      if (error.fault() != DbFault::kUnreachable || Clock::now() + pause > latest) {
        throw;
      }
      if (logged != error.happened()) {
        logged = error.happened();
        writeLog(LogLevel::kWarning, "Waiting for the database server: " + logged);
      }
    }
    web::tellServiceManager("STATUS=Waiting for the database server\nEXTEND_TIMEOUT_USEC=30000000");
    if (endsWithin(signals, pause)) {
      return false;
    }
  }
}

/// Publishes an open desk to other processes of this machine in a file that is removed with it.
class DeskNotice {
 public:
  explicit DeskNotice(std::filesystem::path file) : file_(std::move(file)) {
    if (file_.empty()) {
      return;
    }
    lock_.emplace(lockNameOf(file_), std::chrono::seconds(2));
    lock_->requireHeld(file_);
  }
  DeskNotice(const DeskNotice&) = delete;
  DeskNotice& operator=(const DeskNotice&) = delete;
  ~DeskNotice() { withdraw(); }
  void withdraw() const {
    if (lock_) {
      std::error_code gone;
      std::filesystem::remove(file_, gone);
    }
  }
  void write(const std::vector<std::string>& addresses, const std::string& fingerprint,
             std::int64_t endsWith) const {
    if (lock_) {
      writeFileAtomically(file_, nlohmann::json{{"process", getpid()},
                                                {"addresses", addresses},
                                                {"fingerprint", fingerprint},
                                                {"ends_with", endsWith}}
                                     .dump());
    }
  }

 private:
  std::filesystem::path file_;
  std::optional<FileLock> lock_;
};

/// Ends the process where a desk that was told to stop cannot: a database server that is frozen takes what is
/// sent and answers nothing, so that the desk's threads wait for ever. The server undoes what it has not
/// committed. Construct it before the desk; it guards until it is destroyed.
class LatestEnd {
 public:
  explicit LatestEnd(const DeskNotice& notice) : notice_(notice) {}
  LatestEnd(const LatestEnd&) = delete;
  LatestEnd& operator=(const LatestEnd&) = delete;
  ~LatestEnd() {
    {
      const std::lock_guard lock(mutex_);
      ended_ = true;
    }
    changed_.notify_all();
    if (guard_.joinable()) {
      guard_.join();
    }
  }
  /// From now on the desk has kLongestEnd.
  void begin() {
    guard_ = std::thread([this] {
      std::unique_lock lock(mutex_);
      if (!changed_.wait_for(lock, kLongestEnd, [this] { return ended_; })) {
        writeLog(LogLevel::kError, "The database server does not answer; the review desk ended without it");
        notice_.withdraw();
        _exit(static_cast<int>(ErrorCode::kDatabase));
      }
    });
  }

 private:
  const DeskNotice& notice_;
  std::mutex mutex_;
  std::condition_variable changed_;
  bool ended_ = false;
  std::thread guard_;
};

/// Returns when a signal stops the server, or when its owner process ends. Meanwhile tells the service
/// manager that the desk is alive.
void serveUntilTheEnd(const sigset_t& signals, std::int64_t process, web::WebDesk& desk, LatestEnd& latest) {
  web::tellServiceManager("READY=1\nSTATUS=Open");
  while (!endsWithin(signals, std::chrono::seconds(1))) {
    if (process != 0 && kill(static_cast<pid_t>(process), 0) != 0 && errno == ESRCH) {
      break;
    }
    if (desk.isAlive()) {
      web::tellServiceManager("WATCHDOG=1");
    }
  }
  web::tellServiceManager("STOPPING=1");
  latest.begin();
  desk.endWaiting();
}

/// Qt's database driver warns of each statement of a lost connection; the desk logs its loss once.
void dropWarningsOfQt() {
  qInstallMessageHandler([](QtMsgType type, const QMessageLogContext&, const QString& message) {
    if (type == QtCriticalMsg || type == QtFatalMsg) {
      writeLog(LogLevel::kError, message.toStdString());
    }
  });
}

/// Returns what writes the lines of the desk to the log.
web::LogLine linesAt(LogLevel level) {
  return [level](const std::string& line) { writeLog(level, line); };
}

/// Adds an option whose default may be set in the configuration of the computer.
void addConfigured(CLI::App& command, const std::string& name, const ConfiguredKey& key, std::string& value,
                   const std::string& what) {
  value = configured(key).value_or(value);
  command.add_option(name, value, what + "; default: " + std::string(key.name) + " of torsio.conf");
}

void serve(const ServeArguments& arguments) {
  openLog(LogWriter::kService);
  dropWarningsOfQt();
  const web::HttpAddress address = web::addressOf(arguments.listen);
  requireEncryption(arguments, address);
  const DeskNotice notice(arguments.state);
  web::TlsMaterial tls;
  if (!arguments.certificate.empty()) {
    tls = {readFile(arguments.certificate), readFile(arguments.key)};
  } else if (!arguments.ownCertificate.empty()) {
    tls = web::ownCertificate(arguments.ownCertificate, web::machineNames(), std::time(nullptr)).tls;
  }
  const std::string locator = arguments.database.locator();
  const sigset_t signals = endingSignals();
  if (!waitForTheRecord(arguments, locator, signals)) {
    return;
  }
  {
    SessionContext own({locator, stationName(), {}});
    if (const Text moved = settleMove(own); !moved.empty()) {
      writeLog(LogLevel::kWarning, moved.str());
    }
  }
  LatestEnd latest(notice);
  web::WebDesk desk({.locator = locator,
                     .assets = assetsFolder(),
                     .publicUrl = arguments.publicUrl,
                     .hosts = namesOf(arguments, tls.certificate),
                     .accessLog = arguments.quiet ? web::LogLine() : linesAt(LogLevel::kInfo),
                     .log = linesAt(LogLevel::kWarning),
                     .openMetrics = arguments.metrics,
                     .strictTransport = !arguments.certificate.empty() || !arguments.publicUrl.empty()});
  web::HttpLimits limits;
  if (!arguments.publicUrl.empty()) {
    limits.connectionsAnAddress = limits.connections;  // all come from the proxy
  }
  const web::HttpServer server(address, tls, limits,
                               [&desk](web::HttpRequest request, web::HttpServer::Reply reply) {
                                 desk.handle(std::move(request), std::move(reply));
                               });
  const std::vector<std::string> addresses =
      addressesOf(arguments, address, !tls.certificate.empty(), server.port());
  const std::string fingerprint = web::fingerprintOf(tls.certificate);
  for (const std::string& own : addresses) {
    std::cout << "The review desk is open at " << own << "\n";
  }
  if (!arguments.ownCertificate.empty()) {
    std::cout << "Browsers ask whether they may trust its certificate, SHA-256 " << fingerprint << "\n";
  }
  std::cout << "Ctrl+C closes it" << std::endl;
  if (logsToFile()) {
    writeLog(LogLevel::kInfo, "The review desk of torsio " + softwareVersion() + " is open");
  }
  notice.write(addresses, fingerprint, arguments.endsWith);
  serveUntilTheEnd(signals, arguments.endsWith, desk, latest);
}

}  // namespace

void addServe(CLI::App& program) {
  auto arguments = std::make_shared<ServeArguments>();
  CLI::App* command = program.add_subcommand("serve", "Opens the review desk to browsers");
  addDatabaseOption(*command, arguments->database);
  addConfigured(*command, "--listen", kConfiguredListen, arguments->listen,
                "Address and port (without either 127.0.0.1:8443)");
  addConfigured(*command, "--certificate", kConfiguredCertificate, arguments->certificate,
                "PEM file: the certificate with its chain");
  addConfigured(*command, "--key", kConfiguredCertificateKey, arguments->key,
                "PEM file: the key of the certificate");
  addConfigured(*command, "--public-url", kConfiguredPublicUrl, arguments->publicUrl,
                "Address for browsers through a proxy, https://...");
  command->add_option("--host", arguments->hosts,
                      "Further name by which browsers may call the desk; *.example.org: any one below");
  command->add_option("--own-certificate", arguments->ownCertificate, "Folder for a self-signed certificate");
  command->add_option("--state", arguments->state, "File that contains the desk's address while it is open");
  command->add_option("--ends-with", arguments->endsWith, "Process id: the desk stops when that process ends")
      ->check(CLI::PositiveNumber);
  addDefaulted(*command, "--wait-for-database", arguments->waitForDatabase_s,
               "Seconds to wait at start for a database server that cannot be reached",
               CLI::NonNegativeNumber);
  arguments->metrics = configured(kConfiguredMetrics) == "yes";
  command->add_flag("--metrics", arguments->metrics,
                    "Everybody who reaches the desk may read /metrics, not only this computer; default: "
                    "serve.metrics of torsio.conf");
  command->add_flag("--quiet", arguments->quiet, "Switches the access log off");
  command->callback([arguments] { serve(*arguments); });
}

}  // namespace torsio::cli
