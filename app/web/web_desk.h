// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <exception>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <thread>

#include "app/outputs/wording/wording.h"
#include "app/web/case_picture.h"
#include "app/web/desk_metrics.h"
#include "app/web/desk_workers.h"
#include "app/web/http_server.h"
#include "app/web/late_answers.h"
#include "app/web/organ_shelf.h"
#include "app/web/page_files.h"
#include "app/web/record_state.h"
#include "app/web/router.h"
#include "app/web/waiting_pages.h"
#include "app/web/web_sessions.h"
#include "assessment/domain/people/account.h"

namespace torsio::web {

struct DeskSettings {
  std::string locator{};
  std::filesystem::path assets{};
  /// URL as seen by browsers behind a proxy, "https://desk.example.org"; empty: taken from the request.
  std::string publicUrl{};
  /// Further names by which browsers may call the desk; "*.example.org": one label more. Numeric addresses,
  /// "localhost" and the host of `publicUrl` always are its own. Any other name is refused: it may be one
  /// that somebody else lets point here (DNS rebinding).
  std::vector<std::string> hosts{};
  std::size_t workers = 0;                          ///< 0: as many as suit the database engine
  PasswordCost passwordCost = PasswordCost::kFull;  ///< for hashes made here; tests use a cheap one
  /// Receives one line per answer: "GET /api/cases/* 200 3 ms", with the route's pattern instead of the
  /// address, so without names or handles. Called from several threads; may be empty.
  LogLine accessLog{};
  /// Receives a line when the record is lost or back, and one for each cause of an answer above 499, without
  /// names or values.
  LogLine log{};
  /// Everybody who reaches the desk may read /metrics; else only this machine.
  bool openMetrics = false;
  /// Browsers are told to use only https for a year: for a certificate that they trust.
  bool strictTransport = false;
};

/// The review desk for browsers: sign-in, sessions and dispatch of requests to services. All rules are in the
/// services; added here are checks of the sender, its origin and rate. Thread-safe.
class WebDesk {
 public:
  /// Opens the record and loads the pages. Throws Error, DbError.
  explicit WebDesk(const DeskSettings& settings);
  ~WebDesk();
  WebDesk(const WebDesk&) = delete;
  WebDesk& operator=(const WebDesk&) = delete;

  /// Handles a request for HttpServer: returns at once, replies later.
  void handle(HttpRequest request, HttpServer::Reply reply);

  [[nodiscard]] const Router& router() const noexcept { return router_; }
  [[nodiscard]] WebSessions& sessions() noexcept { return sessions_; }
  [[nodiscard]] PictureCache& pictures() noexcept { return pictures_; }
  [[nodiscard]] OrganShelf& shelf() noexcept { return shelf_; }
  [[nodiscard]] const std::map<std::string, Wording>& languages() const noexcept { return languages_; }

  /// Returns the desk's URL as this request's browser sees it.
  [[nodiscard]] std::string addressFor(const HttpRequest& request) const;
  /// Returns the client address for rate limiting: the peer's or, if the peer is a proxy on this machine
  /// (publicUrl), the last one in X-Forwarded-For. Other peers are not trusted.
  [[nodiscard]] std::string clientOf(const HttpRequest& request) const;
  /// Returns whether the threads of the desk still take work; call it every second or so, for a watchdog.
  [[nodiscard]] bool isAlive();
  /// Answers a monitoring system (DeskMetrics), or that there is no such page.
  [[nodiscard]] HttpResponse metrics(const HttpRequest& request);
  /// Makes the picture of a case likely to be opened next, if the picture thread is idle.
  void prepare(const Actor& actor, const AssignmentId& assignmentId);
  [[nodiscard]] const PageFiles& pages() const noexcept { return pages_; }
  /// Wakes the pages that wait for calls, when one was made or ended here. Others are noticed within a
  /// second.
  void tellCalls() { waiting_.tell(); }
  /// Answers waiting pages and lets none wait any more: before the server stops.
  void endWaiting() {
    waiting_.end();
    late_.end();
  }
  [[nodiscard]] WrongTries& wrongTries() noexcept { return wrongTries_; }
  [[nodiscard]] const KnownBrowsers& knownBrowsers() const noexcept { return knownBrowsers_; }

 private:
  [[nodiscard]] HttpResponse answer(const HttpRequest& request, const Route& route,
                                    const std::vector<std::string>& parts, SessionContext& context);
  [[nodiscard]] bool fromOwnPage(const HttpRequest& request) const;
  /// Returns whether the Host header names this desk.
  [[nodiscard]] bool isCalledByItsName(const HttpRequest& request) const;
  [[nodiscard]] const Wording& wordingFor(const HttpRequest& request) const;
  struct Job;
  /// Queues a request for a thread, or answers that there are too many.
  void queue(const std::shared_ptr<Job>& job);
  void work(const std::shared_ptr<Job>& job, SessionContext* context);
  /// Sends an answer; that to a wrong password later, while other guesses wait.
  void finish(const std::shared_ptr<Job>& job, HttpResponse response);
  /// Queues what needs a password to be hashed.
  void queueToHash(const std::shared_ptr<Job>& job);
  /// Returns whether many wrong passwords came from the address of this request.
  [[nodiscard]] bool sentManyWrong(const Job& job);
  /// Returns whether the name in this request has signed in from its browser before.
  [[nodiscard]] bool isKnown(const Job& job) const;
  /// Looks for new calls while pages wait for them.
  void lookOut();
  [[nodiscard]] HttpResponse failure(const std::exception_ptr& thrown, const Route& route,
                                     const Wording& wording);

  DeskSettings settings_;
  PageFiles pages_;
  Router router_;
  WebSessions sessions_;
  WrongTries wrongTries_;
  KnownBrowsers knownBrowsers_;
  PictureCache pictures_;
  OrganShelf shelf_;
  std::map<std::string, Wording> languages_;
  std::atomic<std::chrono::steady_clock::rep> lastBeat_;
  RecordState record_;
  DeskMetrics metrics_;
  WaitingPages waiting_;
  LateAnswers late_;
  std::mutex lookoutMutex_;
  std::condition_variable lookoutEnds_;
  bool ending_ = false;
  DeskWorkers workers_;  // last: their work uses all of the above
  DeskWorkers hashing_;  // one thread: each password takes 64 MiB
  DeskWorkers heavy_;    // few threads: each picture takes a core
  std::thread lookout_;
};

}  // namespace torsio::web
