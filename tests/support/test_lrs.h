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

/// A local learning record store that follows xAPI 1.0.3, or 2.0, as far as it matters to a sender: version
/// header, authentication, format of a statement, one statement per id forever; its faults can be set.
class TestLrs {
 public:
  enum class Fault {
    kNone,
    kDropsBefore,      ///< hangs up before storing
    kDropsAfter,       ///< stores the statement and hangs up without an answer
    kHangs,            ///< never answers
    kBusy,             ///< 503
    kBroken,           ///< 500
    kTooMany,          ///< 429, Retry-After: 7200
    kPage,             ///< 200 with a proxy's page
    kRedirects,        ///< 302 to another place
    kNowhere,          ///< 404 for every POST
    kAlwaysConflicts,  ///< 409 for a known id even if the statement is identical, which is permitted
    kNotReadable,      ///< like kAlwaysConflicts, and 404 when queried
    kRefuses,          ///< 400
    kVersionTwo,       ///< 400 to a sender of version 1
    kAnswers,          ///< the status of answerWith()
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
  /// Answers every POST with this status.
  void answerWith(int status) {
    status_ = status;
    fault_ = Fault::kAnswers;
  }
  /// Refuses further statements containing these bytes; empty: none.
  void refuse(const std::string& part);
  /// Stores a statement as if from another program.
  void put(const std::string& id, const std::string& bytes);

  [[nodiscard]] std::vector<Stored> stored() const;       ///< in order of arrival
  [[nodiscard]] std::vector<std::string> posted() const;  ///< bytes of every POST with valid authentication
  [[nodiscard]] std::vector<std::string> complaints() const;  ///< violations of the specification

  static constexpr const char* kUser = "torsio station";
  static constexpr const char* kSecret = "a secret of the store";

 private:
  void serve(std::atomic<quint16>& port);
  void talk(QTcpSocket& socket);
  [[nodiscard]] QByteArray answerTo(const QByteArray& head, const QByteArray& body);
  [[nodiscard]] QByteArray keep(const QByteArray& body, Fault fault);
  [[nodiscard]] QByteArray read(const std::string& id, Fault fault) const;

  std::atomic<Fault> fault_{Fault::kNone};
  std::atomic<int> status_{200};
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
