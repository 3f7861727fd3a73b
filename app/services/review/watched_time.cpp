// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/review/watched_time.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <QCoreApplication>

#include "db/connection/connection.h"
#include "db/repository/rating/desk_repository.h"
#include "sim/core/error.h"

namespace torsio {

namespace {

constexpr double kSameSpeed = 0.001;
constexpr const char* kBrowser = "browser";

/// Two windows of one station are two players.
std::string windowOf(const SessionContext& session) {
  return "window " + session.station() + " " + std::to_string(QCoreApplication::applicationPid());
}

void requirePlayable(const PlayedStretch& stretch, const ViewingRules& rules, const Text& where) {
  const bool forwards = stretch.from_us >= 0 && stretch.to_us >= stretch.from_us;
  if (!forwards || !std::isfinite(stretch.speed)) {
    refuseParameter(Text::tr("the watched part is not in the recording"), where,
                    Text::tr("Open the case again"));
  }
  const bool allowed =
      stretch.speed == 1.0 || std::any_of(rules.speeds.begin(), rules.speeds.end(), [&](double speed) {
        return std::abs(speed - stretch.speed) <= kSameSpeed;
      });
  if (!allowed) {
    refuseParameter(Text::tr("the recording was played at a speed that is not allowed"), where,
                    Text::tr("Play it again at an allowed speed"));
  }
}

/// The rater's account, kept for the length of a call.
class KeptAccount {
 public:
  explicit KeptAccount(SessionContext& session) : session_(session) {
    session.require(Operation::kEvaluationSubmit);
    account_ = DeskRepository(session.connection()).watchAccount(session.actor().personId);
  }
  [[nodiscard]] const WatchAccount& read() const noexcept { return account_; }
  void charge(const std::string& recording, const std::string& player, std::int64_t now_us,
              std::int64_t left_us) {
    account_ = charged(recording, player, now_us, left_us);
    if (!session_.actor().personId.empty()) {
      DeskRepository(session_.connection()).saveWatchAccount(session_.actor().personId, account_);
    }
  }

 private:
  SessionContext& session_;
  WatchAccount account_;
};

}  // namespace

std::vector<PlayedStretch> playable(std::vector<PlayedStretch> played, const ViewingRules& rules,
                                    const Text& where) {
  for (const PlayedStretch& stretch : played) {
    requirePlayable(stretch, rules, where);
  }
  return played;
}

CreditedLog creditedLog(WatchLog log, const std::vector<PlayedStretch>& played, std::int64_t budget_us) {
  const double whole_us = static_cast<double>(std::max<std::int64_t>(budget_us, 0));
  double left_us = whole_us;
  for (const PlayedStretch& stretch : played) {
    const double most_us = left_us * stretch.speed;
    const double length_us = std::min(static_cast<double>(stretch.to_us - stretch.from_us), most_us);
    log.played(stretch.from_us, stretch.from_us + std::llround(length_us), stretch.speed);
    left_us -= length_us / stretch.speed;
  }
  return {std::move(log), std::llround(whole_us - left_us)};
}

void beginWatching(SessionContext& session, const std::string& recording) {
  KeptAccount account(session);
  account.charge(recording, kBrowser, session.now_us(), account.read().slack_us);
}

WatchLog watchedInBrowser(SessionContext& session, const std::string& recording, WatchLog log,
                          const std::vector<PlayedStretch>& played) {
  KeptAccount account(session);
  const std::int64_t now_us = session.now_us();
  const std::int64_t most_us = budget_us(account.read(), recording, now_us);
  CreditedLog credited = creditedLog(std::move(log), played, most_us);
  credited.log.worked(std::min(passed_us(account.read(), recording, now_us), kLongestPause_us));
  account.charge(recording, kBrowser, now_us, most_us - credited.used_us);
  return std::move(credited.log);
}

WatchLog watchedInWindow(SessionContext& session, const std::string& recording, const WatchLog& kept,
                         const WatchLog& played) {
  session.require(Operation::kEvaluationSubmit);
  const double speed = played.fastest();
  std::vector<PlayedStretch> fresh;
  std::int64_t fresh_us = 0;
  for (const auto& [from, to] : played.without(kept)) {
    fresh.push_back({from, to, speed});
    fresh_us += std::llround(static_cast<double>(to - from) / speed);
  }
  if (fresh.empty()) {
    return played;
  }
  Transaction transaction(session.connection());
  KeptAccount account(session);
  const std::string here = windowOf(session);
  const bool alone = account.read().player.empty() || account.read().player == here;
  const std::int64_t now_us = session.now_us();
  // Whatever was played: a browser that played something else has not been credited with this time.
  const std::int64_t most_us = budget_us(account.read(), account.read().recording, now_us);
  CreditedLog credited{played, fresh_us};
  if (!alone) {
    credited = creditedLog(kept, fresh, most_us);
    credited.log.joinWork(played);
  }
  account.charge(recording, here, now_us, most_us - credited.used_us);
  transaction.commit();
  return std::move(credited.log);
}

std::string modelRecording(const std::string& campaignId, const std::string& hiddenLabel) {
  return "campaign " + campaignId + " " + hiddenLabel;
}

}  // namespace torsio
