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
  /// "https://desk.example.org": as browsers see it, behind a proxy; empty: as the request says.
  std::string publicUrl{};
  std::size_t workers = 0;                              ///< 0: as many as the engine of the record can use
  PasswordCost passwordCost = PasswordCost::kModerate;  ///< of what is hashed here; tests use a cheap one
  /// Hears of each answer: "GET /api/cases/* 200 3 ms". Of an address only what the route says of it,
  /// nobody's name, no handle. Several threads at once; empty: nobody listens.
  std::function<void(const std::string& line)> accessLog{};
};

/// The review desk for browsers: sign-in, sessions, and which request goes to which service. Every rule lies
/// in the services; here is what a network asks for on top: who sends it, from which page, how often. Any
/// thread.
class WebDesk {
 public:
  /// Opens the record and reads the pages. Throws Error, DbError.
  explicit WebDesk(const DeskSettings& settings);
  ~WebDesk();
  WebDesk(const WebDesk&) = delete;
  WebDesk& operator=(const WebDesk&) = delete;

  /// For HttpServer: returns at once, replies later.
  void handle(HttpRequest request, HttpServer::Reply reply);

  [[nodiscard]] const Router& router() const noexcept { return router_; }
  [[nodiscard]] WebSessions& sessions() noexcept { return sessions_; }
  [[nodiscard]] PictureCache& pictures() noexcept { return pictures_; }
  [[nodiscard]] OrganShelf& shelf() noexcept { return shelf_; }
  [[nodiscard]] const std::map<std::string, Wording>& languages() const noexcept { return languages_; }

  /// "https://desk.example.org": as the browser of this request reaches the desk.
  [[nodiscard]] std::string addressFor(const HttpRequest& request) const;
  /// Whose address this is for counting tries: of the peer, or, where the peer is a proxy on this machine
  /// (publicUrl), the last one that it names in X-Forwarded-For. Nobody else is believed.
  [[nodiscard]] std::string clientOf(const HttpRequest& request) const;
  /// Held while a password is hashed, which takes a quarter of a gigabyte: one at a time, and only few wait.
  /// False: too many wait already.
  [[nodiscard]] bool enterHashing();
  void leaveHashing();
  /// Makes the picture of a case that somebody will open next, while nothing else is asked of the thread that
  /// makes pictures.
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
  DeskWorkers heavy_;    // few threads: a picture takes a core
};

}  // namespace torsio::web
