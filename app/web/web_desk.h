// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>

#include "app/outputs/wording/wording.h"
#include "app/web/desk_workers.h"
#include "app/web/http_server.h"
#include "app/web/organ_shelf.h"
#include "app/web/page_files.h"
#include "app/web/picture_cache.h"
#include "app/web/router.h"
#include "app/web/web_sessions.h"
#include "assessment/domain/people/account.h"

namespace torsio::web {

struct DeskSettings {
  std::string locator{};
  std::filesystem::path assets{};
  /// URL as seen by browsers behind a proxy, "https://desk.example.org"; empty: taken from the request.
  std::string publicUrl{};
  std::size_t workers = 0;                              ///< 0: as many as suit the database engine
  PasswordCost passwordCost = PasswordCost::kModerate;  ///< for hashes made here; tests use a cheap one
  /// Receives one line per answer: "GET /api/cases/* 200 3 ms", with the route's pattern instead of the
  /// address, so without names or handles. Called from several threads; may be empty.
  std::function<void(const std::string& line)> accessLog{};
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
  /// Acquires the lock for password hashing, which takes a quarter of a gigabyte: one at a time with a short
  /// queue. Returns false if the queue is full.
  [[nodiscard]] bool enterHashing();
  void leaveHashing();
  /// Makes the picture of a case likely to be opened next, if the picture thread is idle.
  void prepare(const Actor& actor, const AssignmentId& assignmentId);
  [[nodiscard]] TryLimit& signInTries() noexcept { return signInTries_; }

 private:
  [[nodiscard]] HttpResponse answer(const HttpRequest& request, const Route& route,
                                    const std::vector<std::string>& parts, SessionContext& context);
  [[nodiscard]] bool fromOwnPage(const HttpRequest& request) const;
  [[nodiscard]] const Wording& wordingFor(const HttpRequest& request) const;

  DeskSettings settings_;
  PageFiles pages_;
  Router router_;
  WebSessions sessions_;
  TryLimit signInTries_;
  PictureCache pictures_;
  OrganShelf shelf_;
  std::map<std::string, Wording> languages_;
  std::mutex hashing_;
  std::atomic<int> hashers_{0};
  DeskWorkers workers_;  // last: their work uses all of the above
  DeskWorkers heavy_;    // few threads: each picture takes a core
};

}  // namespace torsio::web
