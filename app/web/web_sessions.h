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
#include "assessment/domain/ids.h"

namespace torsio::web {

/// The name of the cookie; the prefix makes browsers insist on this very host and on encryption.
inline constexpr const char* kCookie = "__Host-torsio";

using SteadyTime = std::chrono::steady_clock::time_point;

/// 256 random bits as 43 characters that a cookie, a header and a path may hold.
[[nodiscard]] std::string freshSecret();

/// Somebody who is signed in with a browser. Whoever works for it holds `busy`, so that two requests of one
/// browser never overtake each other; a heavy route only while it begins.
struct WebSession {
  std::mutex busy;
  Actor actor{};
  UserId userId{};  ///< as in `actor`, and never changed: read without `busy`
  std::string login{};
  std::string id{};       ///< names it in lists; opens nothing
  std::string browser{};  ///< "Firefox, Windows", as it says itself
  std::string stamp{};    ///< passwordStamp() when it began: another one ends it
  std::string token{};    ///< asked of every change, so that no other site can order one
  SteadyTime begun{};

  /// A name for something of the record ("run 17") that means nothing outside of this session; the same one
  /// each time.
  [[nodiscard]] std::string handleFor(const std::string& what);
  /// What is behind it; empty for what was never given out.
  [[nodiscard]] std::string whatOf(const std::string& handle) const;
  /// The same for cases.
  [[nodiscard]] std::string handleOf(const AssignmentId& assignmentId);
  [[nodiscard]] std::optional<AssignmentId> caseOf(const std::string& handle) const;

  /// The recording that plays: no rater watches two at once.
  AssignmentId played{};
  SteadyTime reported{};  ///< when it was reported last

 private:
  mutable std::mutex mutex_;                    // of the handles: heavy routes read them without `busy`
  std::map<std::string, std::string> things_;   // by handle
  std::map<std::string, std::string> handles_;  // by thing
};

/// Everybody who is signed in with a browser, by the hash of the cookie. In memory alone: whoever stops the
/// server signs everybody out, and drafts are in the record. Any thread.
class WebSessions {
 public:
  /// How long a session lasts without a request, and at all.
  struct Limits {
    std::chrono::seconds idle{std::chrono::minutes(30)};
    std::chrono::seconds whole{std::chrono::hours(12)};
  };
  /// One of them, for whoever asks who is signed in.
  struct Line {
    std::string id{};
    UserId userId{};
    std::string login{};
    std::string browser{};
    std::chrono::seconds age{};
    std::chrono::seconds idle{};
  };
  explicit WebSessions(Limits limits) : limits_(limits) {}

  /// Whether the centre's idle time should be read again: true once in ten seconds.
  [[nodiscard]] bool idleIsOld(SteadyTime now);
  /// How long a session lasts without a request from now on.
  void setIdle(std::chrono::seconds idle);
  /// Returns what the browser's cookie will hold; nothing else can find the session.
  [[nodiscard]] std::string open(const Actor& actor, const std::string& browser, const std::string& stamp,
                                 SteadyTime now);
  /// The newest first.
  [[nodiscard]] std::vector<Line> list(SteadyTime now);
  /// Ends the session of this name. False: there is none any more.
  bool end(const std::string& id);
  /// Null: nobody, or too long ago.
  [[nodiscard]] std::shared_ptr<WebSession> find(const std::string& cookie, SteadyTime now);
  void close(const std::string& cookie);
  /// Ends all sessions of a user: before a change of password opens a new one.
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

/// A browser and a system, out of what a browser says about itself: "Firefox, Windows"; empty for none that
/// is known. Nothing else of it is kept.
[[nodiscard]] std::string browserName(const std::string& userAgent);

/// How often something may be tried from one address. A try that was right does not count, up to six times as
/// many: behind a centre's proxy ten physicians who sign in at once have one address. Any thread.
class TryLimit {
 public:
  TryLimit(std::size_t most, std::chrono::seconds within) : most_(most), within_(within) {}
  /// Counts a try; how long to wait before the next one is allowed, 0 for this one may go on.
  [[nodiscard]] std::chrono::seconds tried(const std::string& address, SteadyTime now);
  void wasRight(const std::string& address);

 private:
  struct Window {
    SteadyTime begun{};
    std::size_t tries = 0;
    std::size_t right = 0;
  };
  std::size_t most_;
  std::chrono::seconds within_;
  std::mutex mutex_;
  std::map<std::string, Window> windows_;
};

}  // namespace torsio::web
