// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstddef>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include "app/access/session_context.h"
#include "sim/base/ids.h"

namespace torsio::web {

/// The name of the cookie; the prefix makes browsers insist on this very host and on encryption.
inline constexpr const char* kCookie = "__Host-torsio";

using SteadyTime = std::chrono::steady_clock::time_point;

/// 256 random bits as 43 characters that a cookie, a header and a path may hold.
[[nodiscard]] std::string freshSecret();

/// Somebody who is signed in with a browser. Whoever works for it holds `busy`, so that two requests of one
/// browser never overtake each other.
struct WebSession {
  std::mutex busy;
  Actor actor{};
  std::string token{};  ///< asked of every change, so that no other site can order one
  SteadyTime begun{};

  /// A name for a case that means nothing outside of this session; the same one each time.
  [[nodiscard]] std::string handleOf(const AssignmentId& assignmentId);
  /// The case behind it; nothing for what was never given out.
  [[nodiscard]] std::optional<AssignmentId> caseOf(const std::string& handle) const;

  /// The recording that plays: no rater watches two at once.
  AssignmentId played{};
  SteadyTime reported{};  ///< when it was reported last

 private:
  std::map<std::string, AssignmentId> cases_;
  std::map<AssignmentId, std::string> handles_;
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
  explicit WebSessions(Limits limits) : limits_(limits) {}

  /// Returns what the browser's cookie will hold; nothing else can find the session.
  [[nodiscard]] std::string open(const Actor& actor, SteadyTime now);
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
  Limits limits_;
  std::mutex mutex_;
  std::map<std::string, Held> held_;
};

/// How often something may be tried from one address. Any thread.
class TryLimit {
 public:
  TryLimit(std::size_t most, std::chrono::seconds within) : most_(most), within_(within) {}
  /// Counts a try; how long to wait before the next one is allowed, 0 for this one may go on.
  [[nodiscard]] std::chrono::seconds tried(const std::string& address, SteadyTime now);

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
