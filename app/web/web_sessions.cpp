// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/web/web_sessions.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <string_view>
#include <tuple>
#include <utility>

#include <sodium.h>

#include "app/services/access/boot_clock.h"
#include "sim/core/digest.h"

namespace torsio::web {

namespace {

constexpr std::size_t kSecretBytes = 32;
constexpr std::string_view kCaseThing = "case ";
constexpr std::size_t kMaxWindows = 10'000;  // addresses; beyond, the oldest are dropped

std::string hashOf(const std::string& cookie) {
  Digest digest;
  digest.update(std::string_view(cookie));
  return digest.hex();
}

}  // namespace

SteadyTime deskNow() noexcept {
  return SteadyTime(std::chrono::microseconds(BootClock().now_us()));
}

std::string freshSecret() {
  std::array<unsigned char, kSecretBytes> bytes{};
  randombytes_buf(bytes.data(), bytes.size());
  std::array<char, sodium_base64_ENCODED_LEN(kSecretBytes, sodium_base64_VARIANT_URLSAFE_NO_PADDING)> text{};
  sodium_bin2base64(text.data(), text.size(), bytes.data(), bytes.size(),
                    sodium_base64_VARIANT_URLSAFE_NO_PADDING);
  return text.data();
}

std::string WebSession::handleFor(const std::string& what) {
  const std::lock_guard lock(mutex_);
  const auto found = handles_.find(what);
  if (found != handles_.end()) {
    return found->second;
  }
  const std::string handle = freshSecret();
  handles_.emplace(what, handle);
  objects_.emplace(handle, what);
  return handle;
}

std::string WebSession::objectOf(const std::string& handle) const {
  const std::lock_guard lock(mutex_);
  const auto found = objects_.find(handle);
  return found == objects_.end() ? std::string() : found->second;
}

std::string WebSession::handleOf(const AssignmentId& assignmentId) {
  return handleFor(std::string(kCaseThing) + std::string(assignmentId.text()));
}

std::optional<AssignmentId> WebSession::caseOf(const std::string& handle) const {
  const std::string what = objectOf(handle);
  if (what.rfind(kCaseThing, 0) != 0) {
    return std::nullopt;
  }
  return AssignmentId(what.substr(kCaseThing.size()));
}

std::string KnownBrowsers::markOf(const std::string& login) const {
  Digest digest;
  digest.update(std::string_view(secret_));
  digest.update(std::string_view(login));
  return digest.hex();
}

bool KnownBrowsers::knows(const std::string& cookie, const std::string& login) const {
  return cookie.find(markOf(login)) != std::string::npos;
}

std::string KnownBrowsers::cookieAfter(const std::string& before, const std::string& login) const {
  constexpr std::size_t kMaxMarks = 12;  // people who share a browser
  const std::string mark = markOf(login);
  const std::size_t most = (kMaxMarks - 1) * mark.size();
  const bool ours = before.find_first_not_of("0123456789abcdef") == std::string::npos;
  return knows(before, login) ? before : mark + (ours ? before.substr(0, most) : std::string());
}

std::string browserName(const std::string& userAgent) {
  // Browsers also name those they resemble: the first match is right.
  constexpr std::array<std::pair<const char*, const char*>, 5> kBrowsers{{{"Edg/", "Edge"},
                                                                          {"Firefox/", "Firefox"},
                                                                          {"Chrome/", "Chrome"},
                                                                          {"Chromium/", "Chromium"},
                                                                          {"Safari/", "Safari"}}};
  constexpr std::array<std::pair<const char*, const char*>, 6> kSystems{{{"Android", "Android"},
                                                                         {"iPhone", "iPhone"},
                                                                         {"iPad", "iPad"},
                                                                         {"Windows", "Windows"},
                                                                         {"Mac OS", "macOS"},
                                                                         {"Linux", "Linux"}}};
  const auto first = [&](const auto& known) {
    const auto found = std::find_if(known.begin(), known.end(), [&](const auto& one) {
      return userAgent.find(one.first) != std::string::npos;
    });
    return found == known.end() ? std::string() : std::string(found->second);
  };
  const std::string browser = first(kBrowsers);
  const std::string system = first(kSystems);
  return browser + (browser.empty() || system.empty() ? "" : ", ") + system;
}

bool WebSessions::idleIsOld(SteadyTime now) {
  constexpr std::chrono::seconds kFresh{10};
  const std::lock_guard lock(mutex_);
  if (idleRead_ && now - *idleRead_ < kFresh) {
    return false;
  }
  idleRead_ = now;
  return true;
}

void WebSessions::setIdle(std::chrono::seconds idle) {
  const std::lock_guard lock(mutex_);
  limits_.idle = idle;
}

bool WebSessions::isOver(const Held& held, SteadyTime now) const {
  return now - held.seen > limits_.idle || now - held.session->begun > limits_.whole;
}

std::string WebSessions::open(const Actor& actor, const std::string& browser, const std::string& stamp,
                              SteadyTime now) {
  const std::string cookie = freshSecret();
  auto session = std::make_shared<WebSession>();
  session->actor = actor;
  session->userId = actor.userId;
  session->login = actor.login;
  session->id = freshSecret();
  session->browser = browser;
  session->stamp = stamp;
  session->token = freshSecret();
  session->begun = now;
  const std::lock_guard lock(mutex_);
  std::erase_if(held_, [&](const auto& one) { return isOver(one.second, now); });
  held_[hashOf(cookie)] = {std::move(session), now};
  return cookie;
}

std::shared_ptr<WebSession> WebSessions::find(const std::string& cookie, SteadyTime now) {
  if (cookie.empty()) {
    return nullptr;
  }
  const std::lock_guard lock(mutex_);
  const auto found = held_.find(hashOf(cookie));
  if (found == held_.end()) {
    return nullptr;
  }
  if (isOver(found->second, now)) {
    held_.erase(found);
    return nullptr;
  }
  found->second.seen = now;
  return found->second.session;
}

std::vector<WebSessions::Line> WebSessions::list(SteadyTime now) {
  using std::chrono::duration_cast;
  using std::chrono::seconds;
  std::vector<Line> lines;
  const std::lock_guard lock(mutex_);
  std::erase_if(held_, [&](const auto& one) { return isOver(one.second, now); });
  std::vector<const Held*> newestFirst;
  for (const auto& [hash, held] : held_) {
    newestFirst.push_back(&held);
  }
  std::sort(newestFirst.begin(), newestFirst.end(), [](const Held* one, const Held* other) {
    return std::tie(other->session->begun, one->session->id) <
           std::tie(one->session->begun, other->session->id);
  });
  for (const Held* held : newestFirst) {
    const WebSession& session = *held->session;
    lines.push_back({session.id, session.userId, session.login, session.browser,
                     duration_cast<seconds>(now - session.begun), duration_cast<seconds>(now - held->seen)});
  }
  return lines;
}

bool WebSessions::end(const std::string& id) {
  const std::lock_guard lock(mutex_);
  return std::erase_if(held_, [&](const auto& one) { return one.second.session->id == id; }) > 0;
}

void WebSessions::close(const std::string& cookie) {
  const std::lock_guard lock(mutex_);
  held_.erase(hashOf(cookie));
}

void WebSessions::closeAll(const UserId& userId) {
  const std::lock_guard lock(mutex_);
  for (auto it = held_.begin(); it != held_.end();) {
    it = it->second.session->userId == userId ? held_.erase(it) : std::next(it);
  }
}

void WrongTries::add(const std::string& address, SteadyTime now) {
  const std::lock_guard lock(mutex_);
  if (windows_.size() > kMaxWindows) {
    windows_.clear();
  }
  Window& window = windows_[address];
  if (now - window.begun > within_) {
    window = {now, 0};
  }
  ++window.tries;
}

std::chrono::seconds WrongTries::waitOf(const std::string& address, SteadyTime now) {
  const std::lock_guard lock(mutex_);
  const auto found = windows_.find(address);
  if (found == windows_.end() || found->second.tries < most_ || now - found->second.begun > within_) {
    return std::chrono::seconds(0);
  }
  return std::chrono::duration_cast<std::chrono::seconds>(within_ - (now - found->second.begun)) +
         std::chrono::seconds(1);
}

}  // namespace torsio::web
