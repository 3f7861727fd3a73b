// SPDX-License-Identifier: GPL-3.0-or-later
#include <csignal>
#include <functional>
#include <iostream>
#include <memory>
#include <mutex>
#include <pthread.h>
#include <string>
#include <utility>

#include <CLI/CLI.hpp>

#include "app/base/assets.h"
#include "app/cli/commands.h"
#include "app/cli/database_option.h"
#include "app/web/http_server.h"
#include "app/web/web_desk.h"
#include "db/connection/connection.h"
#include "sim/base/error.h"
#include "sim/base/file_io.h"

namespace torsio::cli {

namespace {

struct ServeArguments {
  DatabaseOption database;
  std::string listen = "127.0.0.1:8443";
  std::string certificate;
  std::string key;
  std::string publicUrl;
  bool quiet = false;
};

/// Names and marks travel: off this machine only encrypted, by this server or by a proxy before it.
void requireEncryption(const ServeArguments& arguments, const web::HttpAddress& address) {
  const bool proxied = arguments.publicUrl.rfind("https://", 0) == 0;
  if (!arguments.publicUrl.empty() && !proxied) {
    throw Error(ErrorCode::kUsage, Text::verbatim("browsers reach the desk by https only"),
                arguments.publicUrl,
                Text::verbatim("Give --public-url https://... as the proxy is called, or leave it out"));
  }
  if (arguments.certificate.empty() != arguments.key.empty()) {
    throw Error(ErrorCode::kUsage, Text::verbatim("certificate and key belong together"), "",
                Text::verbatim("Give both --certificate and --key"));
  }
  if (arguments.certificate.empty() && !proxied && !address.isLoopback()) {
    throw Error(
        ErrorCode::kUsage, Text::verbatim("other machines would reach the desk without encryption"),
        arguments.listen,
        Text::verbatim("Give --certificate and --key, or --public-url of a proxy that encrypts, or listen "
                       "at 127.0.0.1"));
  }
}

/// The signals that end the server, held back from every thread but the one that waits for them.
sigset_t endingSignals() {
  sigset_t signals;
  sigemptyset(&signals);
  sigaddset(&signals, SIGINT);
  sigaddset(&signals, SIGTERM);
  pthread_sigmask(SIG_BLOCK, &signals, nullptr);
  return signals;
}

/// One line at a time, to standard error: a service's log keeps it, with its own time.
void writeAccess(const std::string& line) {
  static std::mutex one;
  const std::lock_guard lock(one);
  std::cerr << line << "\n";
}

void serve(const ServeArguments& arguments) {
  const web::HttpAddress address = web::addressOf(arguments.listen);
  requireEncryption(arguments, address);
  web::TlsMaterial tls;
  if (!arguments.certificate.empty()) {
    tls = {readFile(arguments.certificate), readFile(arguments.key)};
  }
  const std::string locator = arguments.database.locator();
  (void)openDatabase(locator, OpenMode::kReadWrite);  // no new centre is founded here
  const sigset_t signals = endingSignals();
  web::WebDesk desk({.locator = locator,
                     .assets = assetsFolder(),
                     .publicUrl = arguments.publicUrl,
                     .accessLog = arguments.quiet ? std::function<void(const std::string&)>() : writeAccess});
  const web::HttpServer server(address, tls, {},
                               [&desk](web::HttpRequest request, web::HttpServer::Reply reply) {
                                 desk.handle(std::move(request), std::move(reply));
                               });
  const std::string own = (tls.certificate.empty() ? "http://" : "https://") +
                          arguments.listen.substr(0, arguments.listen.rfind(':') + 1) +
                          std::to_string(server.port()) + "/";
  std::cout << "The review desk is open at " << (arguments.publicUrl.empty() ? own : arguments.publicUrl)
            << "  (Ctrl+C closes it)" << std::endl;
  int signal = 0;
  sigwait(&signals, &signal);
}

}  // namespace

void addServe(CLI::App& program) {
  auto arguments = std::make_shared<ServeArguments>();
  CLI::App* command = program.add_subcommand("serve", "Opens the review desk to browsers");
  addDatabaseOption(*command, arguments->database);
  command->add_option("--listen", arguments->listen, "Address and port")->capture_default_str();
  command->add_option("--certificate", arguments->certificate, "PEM file: the certificate with its chain");
  command->add_option("--key", arguments->key, "PEM file: the key of the certificate");
  command->add_option("--public-url", arguments->publicUrl,
                      "https://... as browsers reach it through a proxy");
  command->add_flag("--quiet", arguments->quiet, "Writes no line for each answer");
  command->callback([arguments] { serve(*arguments); });
}

}  // namespace torsio::cli
