// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/web/web_sessions.h"

#include <array>
#include <iterator>

#include <sodium.h>

#include "sim/base/digest.h"

namespace torsio::web {

namespace {

constexpr std::size_t kSecretBytes = 32;
constexpr std::size_t kMostWindows = 10'000;  // addresses; beyond it the old ones are forgotten

std::string hashOf(const std::string& cookie) {
  Digest digest;
  digest.update(std::string_view(cookie));
  return digest.hex();
}

}  // namespace

std::string freshSecret() {
  std::array<unsigned char, kSecretBytes> bytes{};
  randombytes_buf(bytes.data(), bytes.size());
  std::array<char, sodium_base64_ENCODED_LEN(kSecretBytes, sodium_base64_VARIANT_URLSAFE_NO_PADDING)> text{};
  sodium_bin2base64(text.data(), text.size(), bytes.data(), bytes.size(),
                    sodium_base64_VARIANT_URLSAFE_NO_PADDING);
  return text.data();
}

std::string WebSession::handleOf(const AssignmentId& assignmentId) {
  const auto found = handles_.find(assignmentId);
  if (found != handles_.end()) {
    return found->second;
  }
  const std::string handle = freshSecret();
  handles_.emplace(assignmentId, handle);
  cases_.emplace(handle, assignmentId);
  return handle;
}

std::optional<AssignmentId> WebSession::caseOf(const std::string& handle) const {
  const auto found = cases_.find(handle);
  return found == cases_.end() ? std::nullopt : std::optional(found->second);
}

std::string WebSessions::open(const Actor& actor, SteadyTime now) {
  const std::string cookie = freshSecret();
  auto session = std::make_shared<WebSession>();
  session->actor = actor;
  session->token = freshSecret();
  session->begun = now;
  const std::lock_guard lock(mutex_);
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
  if (now - found->second.seen > limits_.idle || now - found->second.session->begun > limits_.whole) {
    held_.erase(found);
    return nullptr;
  }
  found->second.seen = now;
  return found->second.session;
}

void WebSessions::close(const std::string& cookie) {
  const std::lock_guard lock(mutex_);
  held_.erase(hashOf(cookie));
}

void WebSessions::closeAll(const UserId& userId) {
  const std::lock_guard lock(mutex_);
  for (auto it = held_.begin(); it != held_.end();) {
    it = it->second.session->actor.userId == userId ? held_.erase(it) : std::next(it);
  }
}

std::chrono::seconds TryLimit::tried(const std::string& address, SteadyTime now) {
  const std::lock_guard lock(mutex_);
  if (windows_.size() > kMostWindows) {
    windows_.clear();
  }
  Window& window = windows_[address];
  if (now - window.begun > within_) {
    window = {now, 0};
  }
  if (++window.tries <= most_) {
    return std::chrono::seconds(0);
  }
  return std::chrono::duration_cast<std::chrono::seconds>(within_ - (now - window.begun)) +
         std::chrono::seconds(1);
}

}  // namespace torsio::web
