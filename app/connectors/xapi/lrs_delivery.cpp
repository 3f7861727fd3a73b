// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/connectors/xapi/lrs_delivery.h"

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include <QDateTime>
#include <nlohmann/json.hpp>

#include "app/connectors/xapi/learning_statement.h"
#include "app/connectors/xapi/lrs_settings.h"
#include "app/services/base/stored_sentence.h"
#include "app/services/base/web_answer.h"
#include "db/connection/connection.h"
#include "db/connection/db_error.h"
#include "db/repository/base/learning_events.h"
#include "sim/core/error.h"
#include "sim/core/plain_text.h"
#include "sim/core/text.h"
#include "sim/core/time_units.h"

namespace torsio {

namespace {

constexpr std::int64_t kBatch = 100;
constexpr std::int64_t kClaim_us = 2 * kMinute_us;  // longer than the timeout of a request
constexpr std::int64_t kFirstWait_us = kMinute_us / 2;
constexpr std::int64_t kMaxWait_us = 6 * 60 * kMinute_us;
constexpr std::int64_t kMaxRetryAfter_us = 24 * 60 * kMinute_us;
constexpr std::size_t kAnswerShown = 300;
constexpr std::size_t kMaxDoubted = 3;
constexpr std::int64_t kMaxTriesAlone = 12;  // over about a day

constexpr int kBadRequest = 400;
constexpr int kConflict = 409;

enum class Fate : std::uint8_t {
  kDelivered,
  kDead,     ///< the store has another statement under this id
  kRefused,  ///< because of the statement, if the store takes others
  kLater,
  kLaterAndStop,  ///< because of the sender, its account or the store: the others would fare no better
};

struct Outcome {
  Fate fate = Fate::kLater;
  Text words{};
  std::string after{};
};

/// The answer as one line that tells the user what to do.
std::string wordsOf(const WebAnswer& answer) {
  std::string words = answer.status == 0 ? "" : "HTTP " + std::to_string(answer.status) + " ";
  return words + plainLine(answer.body, kAnswerShown);
}

/// A store answers with the ids that it took; a proxy's error page does not.
bool took(const WebAnswer& answer, const std::string& id) {
  const nlohmann::json ids = nlohmann::json::parse(answer.body, nullptr, false);
  return ids.is_array() && ids.size() == 1 && ids[0].is_string() &&
         QString::fromStdString(ids[0].get<std::string>())
                 .compare(QString::fromStdString(id), Qt::CaseInsensitive) == 0;
}

/// Meaning of an answer other than "accepted" and "known".
Outcome refused(const WebAnswer& answer) {
  switch (answer.status) {
    case 400:
    case 413:
    case 422:
      return {Fate::kRefused, wordsOf(answer), answer.retryAfter};
    case 401:
    case 403:
    case 407:
      return {Fate::kLaterAndStop, Text::tr("the key is refused: %1", wordsOf(answer)), answer.retryAfter};
    case 402:
      return {Fate::kLaterAndStop,
              Text::tr("the account at the store is closed or full: %1", wordsOf(answer)), answer.retryAfter};
    case 404:
    case 405:
    case 410:
      return {Fate::kLaterAndStop, Text::tr("no learning record store at this address: %1", wordsOf(answer)),
              answer.retryAfter};
    default:
      return {Fate::kLaterAndStop, wordsOf(answer), answer.retryAfter};
  }
}

/// The store already has this id: checks that it is the same statement.
Outcome afterConflict(LrsClient& store, const std::string& id, const std::string& statement) {
  const WebAnswer known = store.get(id);
  if (known.status == 200) {
    return sameStatement(statement, known.body)
               ? Outcome{Fate::kDelivered, Text::tr("the store had it already"), {}}
               : Outcome{Fate::kDead, Text::tr("the store has another statement under this id"), {}};
  }
  if (known.status == 404) {
    return {Fate::kLater, Text::tr("the store knows the id, but the statement cannot be read yet"), {}};
  }
  return refused(known);
}

Outcome send(LrsClient& store, const std::string& id, const std::string& statement) {
  WebAnswer answer = store.post(statement);
  if (answer.status == kBadRequest && store.changeVersion()) {
    answer = store.post(statement);
  }
  if (answer.status == 200) {
    return took(answer, id)
               ? Outcome{Fate::kDelivered, Text::tr("taken"), {}}
               : Outcome{Fate::kLaterAndStop,
                         Text::tr("the reply is not from a learning record store: %1", wordsOf(answer)),
                         {}};
  }
  return answer.status == kConflict ? afterConflict(store, id, statement) : refused(answer);
}

/// One round of sending.
class Round {
 public:
  Round(Connection& connection, const LrsIdentity& identity, LrsClient& store, const UtcClock& now)
      : connection_(connection), outbox_(connection), identity_(identity), store_(store), now_(now) {}

  LrsDelivery run() {
    sendAll();
    postponeDoubted();
    return done_;
  }

 private:
  void sendAll() {
    for (std::vector<LearningEvent> due = outbox_.due(now_(), kBatch); !due.empty();
         due = outbox_.due(now_(), kBatch)) {
      for (const LearningEvent& event : due) {
        if (outbox_.claim(event, now_() + kClaim_us)) {
          take(event);
        }
        if (done_.stopped) {
          return;
        }
      }
    }
  }

  void take(const LearningEvent& event) {
    if (!agreesToLearningRecords(connection_, event.personId)) {
      outbox_.forget(event);
      ++done_.forgotten;
      return;
    }
    std::string statement = event.statement;
    if (statement.empty()) {
      try {
        statement = statementOf(connection_, event, identity_, rules_, now_());
      } catch (const DbError&) {
        throw;
      } catch (const Error& error) {
        outbox_.setRefused(event, storedSentence(error.happenedText()), now_());
        ++done_.dead;
        return;
      }
      if (statement.empty()) {
        outbox_.forget(event);
        ++done_.forgotten;
        return;
      }
      statement = outbox_.keepStatement(event, statement);
    }
    settle(event, send(store_, statementId(event), statement));
  }

  void settle(const LearningEvent& event, const Outcome& outcome) {
    const std::int64_t now_us = now_();
    switch (outcome.fate) {
      case Fate::kDelivered:
        outbox_.setDelivered(event, storedSentence(outcome.words), now_us);
        ++done_.delivered;
        for (const Doubted& one : std::exchange(doubted_, {})) {
          setAside(one.event, one.outcome);
        }
        return;
      case Fate::kRefused:
        if (done_.delivered == 0) {
          doubted_.push_back({event, outcome});
          done_.stopped = doubted_.size() == kMaxDoubted;
          return;
        }
        [[fallthrough]];
      case Fate::kDead:
        setAside(event, outcome);
        return;
      case Fate::kLater:
      case Fate::kLaterAndStop: {
        postpone(event, outcome);
        done_.stopped = outcome.fate == Fate::kLaterAndStop;
        return;
      }
    }
  }

  void setAside(const LearningEvent& event, const Outcome& outcome) {
    outbox_.setRefused(event, storedSentence(outcome.words), now_());
    ++done_.dead;
  }

  void postpone(const LearningEvent& event, const Outcome& outcome) {
    const std::int64_t now_us = now_();
    const std::int64_t wait_us = std::max(retryAfter_us(outcome.after, now_us),
                                          waitBeforeNextTry_us(event.tries + 1, statementId(event)));
    outbox_.setRetry(event, storedSentence(outcome.words), now_us, now_us + wait_us);
    ++done_.later;
  }

  /// Deals with statements refused by a store that took none in this round: it may refuse all of them, for a
  /// version, a size or a setting. A statement that was alone in being refused is set aside after many tries.
  void postponeDoubted() {
    const bool all = doubted_.size() == kMaxDoubted;
    for (Doubted& one : doubted_) {
      if (!all && one.event.tries + 1 >= kMaxTriesAlone) {
        setAside(one.event, one.outcome);
        continue;
      }
      if (all) {
        one.outcome.words = Text::tr("the store takes none of the statements: %1", one.outcome.words);
      }
      postpone(one.event, one.outcome);
    }
  }

  struct Doubted {
    LearningEvent event;
    Outcome outcome;
  };

  Connection& connection_;
  LearningRepository outbox_;
  const LrsIdentity& identity_;
  LrsClient& store_;
  const UtcClock& now_;
  ExerciseRules rules_;
  LrsDelivery done_;
  std::vector<Doubted> doubted_;
};

}  // namespace

std::int64_t waitBeforeNextTry_us(std::int64_t tries, const std::string& id) {
  constexpr std::int64_t kDoublings = 20;
  const std::int64_t doubled = kFirstWait_us << std::clamp<std::int64_t>(tries - 1, 0, kDoublings);
  const std::int64_t wait_us = std::min(doubled, kMaxWait_us);
  std::uint32_t spread = 2'166'136'261U;  // FNV-1a
  for (const char c : id) {
    spread = (spread ^ static_cast<unsigned char>(c)) * 16'777'619U;
  }
  return wait_us - wait_us / 4 + static_cast<std::int64_t>(spread % 1'000U) * (wait_us / 2'000);
}

std::int64_t retryAfter_us(const std::string& header, std::int64_t now_us) {
  QString text = QString::fromStdString(header).trimmed();
  bool isNumber = false;
  const qlonglong seconds = text.toLongLong(&isNumber);
  std::int64_t wait_us = 0;
  if (isNumber) {
    wait_us = std::clamp<qlonglong>(seconds, 0, kMaxRetryAfter_us / kSecond_us) * kSecond_us;
  } else if (const QDateTime date = QDateTime::fromString(
                 text.replace(QLatin1String("GMT"), QLatin1String("+0000")), Qt::RFC2822Date);
             date.isValid()) {
    wait_us = date.toMSecsSinceEpoch() * 1000 - now_us;
  }
  return std::clamp<std::int64_t>(wait_us, 0, kMaxRetryAfter_us);
}

LrsDelivery deliverLearningRecords(Connection& connection, const LrsIdentity& identity, LrsClient& store,
                                   const UtcClock& now) {
  return Round(connection, identity, store, now).run();
}

struct LrsWorker::State {
  State(SessionKey station, std::chrono::milliseconds wait) : key(std::move(station)), again(wait) {}

  SessionKey key;
  std::chrono::milliseconds again;
  std::atomic<bool> stop{false};
  std::mutex mutex{};
  std::condition_variable wake{};
};

LrsWorker::LrsWorker(SessionKey key, std::chrono::milliseconds again)
    : state_(std::make_unique<State>(std::move(key), again)), thread_([this] { run(*state_); }) {}

LrsWorker::~LrsWorker() {
  {
    const std::lock_guard lock(state_->mutex);
    state_->stop = true;
  }
  state_->wake.notify_all();
  thread_.join();
}

void LrsWorker::run(State& state) {
  std::unique_lock lock(state.mutex);
  while (!state.wake.wait_for(lock, state.again, [&] { return state.stop.load(); })) {
    lock.unlock();
    try {
      if (const std::optional<LrsKey> key = stationLrsKey()) {
        SessionContext session(state.key);
        Connection& connection = session.connectionWithoutRight();
        const std::optional<LrsIdentity> identity = lrsIdentity(connection);
        if (identity && identity->settings.on) {
          LrsClient store(identity->settings.endpoint, *key, std::chrono::seconds(30), &state.stop);
          (void)deliverLearningRecords(connection, *identity, store, [&] { return session.now_us(); });
        }
      }
    } catch (const std::exception&) {
      // The database or the key file is unavailable: entries stay in the outbox for the next try.
    }
    lock.lock();
  }
}

}  // namespace torsio
