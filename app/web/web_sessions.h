// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstddef>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "app/services/access/session_context.h"
#include "app/services/review/watch_log.h"
#include "assessment/domain/ids.h"

namespace torsio::web {

/// Cookie name; the prefix makes browsers bind it to this host and to encryption.
inline constexpr const char* kCookie = "__Host-torsio";

/// Names the accounts that have signed in from a browser before.
inline constexpr const char* kKnownCookie = "__Host-torsio-known";

using SteadyTime = std::chrono::steady_clock::time_point;

/// Returns the time for sessions and waiting pages; counts the computer's sleep, too, so that a session that
/// nobody used ends while the lid is closed.
[[nodiscard]] SteadyTime deskNow() noexcept;

/// Returns 256 random bits as 43 characters that are valid in cookies, headers and paths.
[[nodiscard]] std::string freshSecret();

/// A browser session. Hold `busy` while working for it, so that its requests never overtake each other; heavy
/// routes hold it only at their start.
struct WebSession {
  std::mutex busy;
  Actor actor{};
  UserId userId{};  ///< same as in `actor`; immutable, readable without `busy`
  std::string login{};
  std::string id{};       ///< identifies it in lists; grants no access
  std::string browser{};  ///< "Firefox, Windows", from the user agent
  std::string stamp{};    ///< passwordStamp() at its start; the session ends when it changes
  std::string token{};    ///< required for every change, against cross-site requests
  SteadyTime begun{};

  /// Returns a handle for an object of the record ("run 17"): meaningless outside this session, stable within
  /// it.
  [[nodiscard]] std::string handleFor(const std::string& what);
  /// Returns the object of a handle; empty for an unknown one.
  [[nodiscard]] std::string objectOf(const std::string& handle) const;
  /// The same for cases.
  [[nodiscard]] std::string handleOf(const AssignmentId& assignmentId);
  [[nodiscard]] std::optional<AssignmentId> caseOf(const std::string& handle) const;

  /// What was watched of the models of evaluations, by campaign and label.
  std::map<std::string, WatchLog> modelsWatched{};

 private:
  mutable std::mutex mutex_;                    // for the handles: heavy routes read them without `busy`
  std::map<std::string, std::string> objects_;  // by handle
  std::map<std::string, std::string> handles_;  // by object
};

/// All browser sessions, by the hash of their cookie. In memory only: stopping the server signs everybody
/// out; drafts are in the record. Thread-safe.
class WebSessions {
 public:
  /// Maximum idle time and lifetime of a session.
  struct Limits {
    std::chrono::seconds idle{std::chrono::minutes(30)};
    std::chrono::seconds whole{std::chrono::hours(12)};
  };
  /// A session as listed.
  struct Line {
    std::string id{};
    UserId userId{};
    std::string login{};
    std::string browser{};
    std::chrono::seconds age{};
    std::chrono::seconds idle{};
  };
  explicit WebSessions(Limits limits) : limits_(limits) {}

  /// True once every ten seconds: time to re-read the centre's idle time.
  [[nodiscard]] bool idleIsOld(SteadyTime now);
  /// Sets the idle time of all sessions.
  void setIdle(std::chrono::seconds idle);
  /// Returns the new session's cookie; the session cannot be found otherwise.
  [[nodiscard]] std::string open(const Actor& actor, const std::string& browser, const std::string& stamp,
                                 SteadyTime now);
  /// Newest first.
  [[nodiscard]] std::vector<Line> list(SteadyTime now);
  /// Ends the session with this id. False: not found.
  bool end(const std::string& id);
  /// Null: unknown or expired.
  [[nodiscard]] std::shared_ptr<WebSession> find(const std::string& cookie, SteadyTime now);
  void close(const std::string& cookie);
  /// Ends all sessions of a user, before a password change opens a new one.
  void closeAll(const UserId& userId);

 private:
  struct Held {
    std::shared_ptr<WebSession> session;
    SteadyTime seen{};
  };
  [[nodiscard]] bool isOver(const Held& held, SteadyTime now) const;

  Limits limits_;
  std::optional<SteadyTime> idleRead_;
  std::mutex mutex_;
  std::map<std::string, Held> held_;
};

/// Recognises browsers from which somebody has signed in: their tries at a password are not counted together
/// with those of others at the same address. Until the server ends. Thread-safe, immutable.
class KnownBrowsers {
 public:
  /// Returns the cookie of a browser after a good sign-in; `before`: the cookie that it sent.
  [[nodiscard]] std::string cookieAfter(const std::string& before, const std::string& login) const;
  [[nodiscard]] bool knows(const std::string& cookie, const std::string& login) const;

 private:
  [[nodiscard]] std::string markOf(const std::string& login) const;
  std::string secret_ = freshSecret();
};

/// Extracts browser and system from a user agent: "Firefox, Windows"; empty if unknown. The rest is not kept.
[[nodiscard]] std::string browserName(const std::string& userAgent);

/// Wrong passwords and invitations of each address. Thread-safe.
class WrongTries {
 public:
  /// More than `most` within this time are many.
  WrongTries(std::size_t most, std::chrono::seconds within) : most_(most), within_(within) {}
  void add(const std::string& address, SteadyTime now);
  /// Returns the time until the address no longer has many; 0: it has few.
  [[nodiscard]] std::chrono::seconds waitOf(const std::string& address, SteadyTime now);

 private:
  struct Window {
    SteadyTime begun{};
    std::size_t tries = 0;
  };
  std::size_t most_;
  std::chrono::seconds within_;
  std::mutex mutex_;
  std::map<std::string, Window> windows_;
};

}  // namespace torsio::web
