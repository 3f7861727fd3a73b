// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/maintenance/stamped_heads.h"

#include <algorithm>
#include <cstdlib>
#include <map>
#include <set>
#include <sstream>
#include <system_error>
#include <utility>

#include <QByteArray>
#include <QUrl>
#include <nlohmann/json.hpp>

#include "app/services/access/centre_settings.h"
#include "app/services/base/web_answer.h"
#include "app/services/maintenance/anchor.h"
#include "app/services/maintenance/time_stamp.h"
#include "assessment/results/number_format.h"
#include "db/connection/connection.h"
#include "db/migrations/migrations.h"
#include "sim/core/error.h"
#include "sim/core/file_io.h"
#include "sim/core/plain_text.h"
#include "sim/core/time_units.h"

namespace torsio {

namespace {

constexpr std::size_t kMaxAnswer_bytes = 65'536;           // a stamp with its chain has 2,000 to 10,000
constexpr std::uintmax_t kMaxCertificates_bytes = 30'000;  // the setting holds them
constexpr std::size_t kShownHash = 16;                     // digits
constexpr std::int64_t kClocksDiffer_us = 5 * kMinute_us;

/// A parsed line.
struct Stamp {
  std::string head;    ///< stampedHash() of the head's line
  std::string answer;  ///< bytes of the authority
};

std::optional<Stamp> readStamp(const std::string& line) {
  std::istringstream words(line);
  std::string word;
  std::string version;
  std::string answer;
  std::string rest;
  Stamp stamp;
  words >> word >> version >> stamp.head >> answer;
  if (!words || word != kStampWord || version != "1" || words >> rest) {
    return std::nullopt;
  }
  const auto bytes = QByteArray::fromBase64Encoding(QByteArray::fromStdString(answer),
                                                    QByteArray::AbortOnBase64DecodingErrors);
  if (!bytes || answer.size() % 4 != 0) {
    return std::nullopt;
  }
  stamp.answer = (*bytes).toStdString();
  return stamp;
}

void requireWebAddress(const std::string& address) {
  const QUrl url(QString::fromStdString(address), QUrl::StrictMode);
  const bool web = url.scheme() == QLatin1String("https") || url.scheme() == QLatin1String("http");
  if (!url.isValid() || !web || url.host().isEmpty() || url.hasFragment() || !url.userInfo().isEmpty()) {
    refuseParameter(Text::tr("not an address of a time stamp authority"), address,
                    Text::tr("Write it like https://stamps.example.org/tsr"));
  }
}

/// A head as kept, with its earliest genuine stamp.
struct StampedHead {
  std::string line;
  AnchoredHead head;
  std::optional<TimeStamp> stamp{};
};

/// Checks the stamps among lines kept elsewhere.
class StampCheck {
 public:
  StampCheck(const std::vector<std::string>& lines, std::string roots) : roots_(std::move(roots)) {
    for (const std::string& line : lines) {
      if (line.starts_with(kHeadWord)) {
        places_[stampedHash(line)] = heads_.size();
        heads_.push_back({line, readHead(line)});
      }
    }
    for (const std::string& line : lines) {
      if (isStampLine(line)) {
        check(readStamp(line));
      }
    }
  }

  [[nodiscard]] const std::vector<StampedHead>& heads() const { return heads_; }
  [[nodiscard]] const std::vector<AuditFinding>& findings() const { return findings_; }
  [[nodiscard]] std::int64_t unchecked() const { return unchecked_; }

 private:
  void check(const std::optional<Stamp>& stamp) {
    const auto place = stamp ? places_.find(stamp->head) : places_.end();
    if (place == places_.end()) {
      findings_.push_back({0, "time stamp", stamp ? plainLine(stamp->head, kShownHash) : "-",
                           stamp ? "its checkpoint is missing, or was changed" : "is not readable"});
      return;
    }
    if (roots_.empty()) {
      ++unchecked_;
      return;
    }
    StampedHead& of = heads_[place->second];
    try {
      TimeStamp found = keptStamp(stamp->answer, of.line, roots_);
      if (!of.stamp || found.utc_us < of.stamp->utc_us) {
        of.stamp = std::move(found);
      }
    } catch (const Error& error) {
      findings_.push_back(
          {of.head.length, "time stamp", stamp->head.substr(0, kShownHash), error.happened()});
    }
  }

  std::string roots_;  // PEM; empty: none is known
  std::vector<StampedHead> heads_;
  std::map<std::string, std::size_t> places_;  // by stampedHash()
  std::vector<AuditFinding> findings_;
  std::int64_t unchecked_ = 0;
};

void addProven(HeadsVerdict& verdict) {
  const auto tell = [&verdict](const ProvenTime& one) {
    verdict.notes.push_back(one.authority.empty()
                                ? Text::tr("The trail demonstrably existed up to entry %1 at %2", one.length,
                                           formatUtc(one.utc_us))
                                : Text::tr("The trail demonstrably existed up to entry %1 at %2, says %3",
                                           one.length, formatUtc(one.utc_us), one.authority));
  };
  if (verdict.proven.empty()) {
    return;
  }
  const auto [first, last] =
      std::minmax_element(verdict.proven.begin(), verdict.proven.end(),
                          [](const ProvenTime& a, const ProvenTime& b) { return a.utc_us < b.utc_us; });
  tell(*first);
  if (first != last) {
    tell(*last);
  }
}

}  // namespace

std::string certificatesOf(const std::filesystem::path& file) {
  std::error_code ignored;
  const std::filesystem::file_status there = std::filesystem::status(file, ignored);
  if (std::filesystem::exists(there) && !std::filesystem::is_regular_file(there)) {
    throw Error(ErrorCode::kFileUnreadable, Text::tr("is a pipe, a device or a folder"), file.string(),
                Text::tr("Give the certificate of the time stamp authority's root, as PEM"));
  }
  const bool large = std::filesystem::file_size(file, ignored) > kMaxCertificates_bytes && !ignored;
  std::string pem = large ? std::string() : readFile(file);
  requireCertificates(pem, file.string());
  return pem;
}

std::optional<StampAuthority> stampAuthority(Connection& connection) {
  const nlohmann::json json =
      nlohmann::json::parse(centreSetting<kStampAuthority>(connection), nullptr, false);
  if (!json.is_object()) {
    return std::nullopt;
  }
  return StampAuthority{json.value("address", ""), json.value("certificates", "")};
}

std::optional<StampAuthority> stampAuthority(const std::string& locator) {
  Connection connection = openRecord(locator, OpenMode::kReadOnly);
  return stampAuthority(connection);
}

void setStampAuthority(SessionContext& session, const StampAuthority& authority) {
  session.require(Operation::kSettingsEdit);
  if (authority.address.empty()) {
    setCentreSetting<kStampAuthority>(session, "");
    return;
  }
  requireWebAddress(authority.address);
  requireCertificates(authority.certificates, authority.address);
  setCentreSetting<kStampAuthority>(
      session,
      nlohmann::json{{"address", authority.address}, {"certificates", authority.certificates}}.dump());
}

std::string stampedBy(const StampAuthority& authority, const std::string& head,
                      std::chrono::milliseconds patience) {
  const std::string query = stampQuery(head);
  const WebAnswer answer = askWeb({.address = authority.address,
                                   .headers = {"Content-Type: application/timestamp-query"},
                                   .body = query,
                                   .patience = patience,
                                   .most_bytes = kMaxAnswer_bytes});
  if (answer.status != 200) {
    throw Error(ErrorCode::kFileUnreadable,
                answer.status == 0
                    ? Text::tr("the time stamp authority gave no answer: %1", plainLine(answer.body))
                    : Text::tr("the time stamp authority answered with the status %1", answer.status),
                authority.address, Text::tr("The checkpoint is kept without a time stamp; ask again later"));
  }
  (void)stampIn(answer.body, query, authority.certificates);
  return std::string(kStampWord) + " 1 " + stampedHash(head) + " " +
         QByteArray::fromStdString(answer.body).toBase64().toStdString();
}

bool isStampLine(const std::string& line) {
  return line.starts_with(std::string(kStampWord) + " ");
}

bool isWholeStamp(const std::string& line) {
  const std::optional<Stamp> stamp = readStamp(line);
  return stamp && isStampAnswer(stamp->answer);
}

HeadsVerdict judgeHeads(const std::string& locator, const std::vector<std::string>& lines,
                        const std::string& publicKey, const std::string& certificates) {
  Connection connection = openRecord(locator, OpenMode::kReadOnly);
  return judgeHeads(connection, lines, publicKey, certificates);
}

HeadsVerdict judgeHeads(Connection& connection, const std::vector<std::string>& lines,
                        const std::string& publicKey, const std::string& certificates) {
  HeadsVerdict verdict{.findings = compareWithHeads(connection, lines, publicKey)};
  std::set<std::int64_t> doubtful;  // lengths
  for (const AuditFinding& finding : verdict.findings) {
    doubtful.insert(finding.sequence);
  }
  const std::optional<StampAuthority> authority = stampAuthority(connection);
  const StampCheck check(lines, !certificates.empty() ? certificates
                                : authority           ? authority->certificates
                                                      : std::string());
  verdict.findings.insert(verdict.findings.end(), check.findings().begin(), check.findings().end());
  std::vector<std::int64_t> missing;  // lengths; heads before the first stamp owe none
  for (const StampedHead& one : check.heads()) {
    const auto& [line, head, stamp] = one;
    if (!stamp) {
      if (authority || !verdict.proven.empty()) {
        missing.push_back(head.length);
      }
      continue;
    }
    if (verdict.proven.empty()) {
      missing.clear();
    }
    if (!doubtful.contains(head.length)) {
      verdict.proven.push_back({head.length, stamp->utc_us, stamp->authority});
    }
    if (std::abs(head.utc_us - stamp->utc_us) > kClocksDiffer_us) {
      verdict.notes.push_back(Text::tr(
          "the clock of the station was wrong: the checkpoint of entry %1 is dated %2, its time stamp %3",
          head.length, formatUtc(head.utc_us), formatUtc(stamp->utc_us)));
    }
  }
  addProven(verdict);
  if (check.unchecked() > 0) {
    verdict.notes.push_back(
        Text::tr("%1 time {stamp was|stamps were} not checked: no certificate of the authority is known",
                 check.unchecked()));
  } else if (!missing.empty()) {
    verdict.notes.push_back(
        Text::tr("%1 {checkpoint has|checkpoints have} no time stamp; the first is of entry %2",
                 missing.size(), missing.front()));
  }
  return verdict;
}

}  // namespace torsio
