// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <map>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include <QByteArray>
#include <QTcpSocket>
#include <QtGlobal>

namespace torsio::testing {

/// A learning record store on this computer that keeps to xAPI 1.0.3 where it matters to a sender: version
/// header, sign-in, form of a statement, one statement an id for ever; and that can be told to misbehave.
class TestLrs {
 public:
  enum class Fault {
    kNone,
    kDropsBefore,      ///< hangs up before it keeps anything
    kDropsAfter,       ///< keeps the statement and hangs up without an answer
    kHangs,            ///< never answers
    kBusy,             ///< 503
    kBroken,           ///< 500
    kTooMany,          ///< 429, Retry-After: 7200
    kPage,             ///< 200 with a page of a proxy
    kRedirects,        ///< 302 to somewhere else
    kNowhere,          ///< 404 to whatever is posted
    kAlwaysConflicts,  ///< 409 for a known id, also when the statement is the same, as it may
    kNotReadable,      ///< the same, and 404 when asked for it
    kRefuses,          ///< 400
  };
  struct Stored {
    std::string id{};
    std::string bytes{};
  };

  TestLrs();
  ~TestLrs();
  TestLrs(const TestLrs&) = delete;
  TestLrs& operator=(const TestLrs&) = delete;

  [[nodiscard]] std::string endpoint() const;
  void become(Fault fault) { fault_ = fault; }
  /// Refuses from now on statements whose bytes hold this; empty: none.
  void refuse(const std::string& part);
  /// Puts a statement there, as another program may have.
  void put(const std::string& id, const std::string& bytes);

  [[nodiscard]] std::vector<Stored> stored() const;           ///< in the order in which they came
  [[nodiscard]] std::vector<std::string> posted() const;      ///< bytes of every POST with a sound sign-in
  [[nodiscard]] std::vector<std::string> complaints() const;  ///< what broke the specification

  static constexpr const char* kUser = "torsio station";
  static constexpr const char* kSecret = "a secret of the store";

 private:
  void serve(std::atomic<quint16>& port);
  void talk(QTcpSocket& socket);
  [[nodiscard]] QByteArray answerTo(const QByteArray& head, const QByteArray& body);
  [[nodiscard]] QByteArray keep(const QByteArray& body, Fault fault);
  [[nodiscard]] QByteArray read(const std::string& id, Fault fault) const;

  std::atomic<Fault> fault_{Fault::kNone};
  std::atomic<bool> stop_{false};
  quint16 port_ = 0;
  mutable std::mutex mutex_;
  std::string refused_;
  std::vector<Stored> stored_;
  std::vector<std::string> posted_;
  std::vector<std::string> complaints_;
  std::thread thread_;
};

}  // namespace torsio::testing
