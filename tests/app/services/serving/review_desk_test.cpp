// SPDX-License-Identifier: GPL-3.0-or-later
// The review desk, opened like from the window and queried over the network.
#include "app/services/serving/review_desk.h"

#include <cstdint>
#include <optional>
#include <string>

#include <QCryptographicHash>
#include <QHostAddress>
#include <QProcess>
#include <QSslSocket>
#include <QTcpServer>
#include <gtest/gtest.h>

#include "app/services/access/invitations.h"
#include "sim/core/error.h"
#include "sim/core/file_io.h"
#include "tests/app/support/study_centre.h"

namespace torsio {
namespace {

constexpr int kPatience_ms = 20'000;

std::uint16_t freePort() {
  QTcpServer probe;
  EXPECT_TRUE(probe.listen(QHostAddress::LocalHost, 0));
  return probe.serverPort();
}

/// Reply to a page request with the server's fingerprint; empty: nobody listens.
struct Heard {
  QByteArray answer;
  std::string fingerprint;
};

Heard ask(std::uint16_t port) {
  QSslSocket socket;
  socket.setPeerVerifyMode(QSslSocket::VerifyNone);
  socket.connectToHostEncrypted(QStringLiteral("127.0.0.1"), port);
  if (!socket.waitForEncrypted(kPatience_ms)) {
    return {};
  }
  Heard heard;
  heard.fingerprint =
      socket.peerCertificate().digest(QCryptographicHash::Sha256).toHex(':').toUpper().toStdString();
  socket.write("GET /api/texts HTTP/1.1\r\nHost: 127.0.0.1\r\nConnection: close\r\n\r\n");
  while (socket.waitForReadyRead(kPatience_ms)) {
    heard.answer += socket.readAll();
  }
  return heard;
}

class ReviewDeskOfAStation : public ::testing::Test {
 protected:
  void TearDown() override { stopReviewDesk(centre.as("administrator"), place); }
  std::optional<Error> refusalOf(const DeskWish& wish) {
    try {
      startReviewDesk(centre.as("administrator"), place, wish);
    } catch (const Error& error) {
      return error;
    }
    return std::nullopt;
  }

  StudyCentre centre;
  DeskPlace place{TORSIO_PROGRAM, centre.folder() / "desk"};
  std::uint16_t port = freePort();
};

TEST_F(ReviewDeskOfAStation, OpensForBrowsersAndCloses) {
  ASSERT_FALSE(openReviewDesk(centre.as("administrator"), place));

  startReviewDesk(centre.as("administrator"), place, {.port = port});

  const auto desk = openReviewDesk(centre.as("administrator"), place);
  ASSERT_TRUE(desk);
  EXPECT_FALSE(desk->goesOn);
  ASSERT_FALSE(desk->addresses.empty());
  EXPECT_EQ(desk->addresses.front().rfind("https://", 0), 0U);
  EXPECT_NE(desk->addresses.front().find(":" + std::to_string(port) + "/"), std::string::npos);
  EXPECT_EQ(browserAddress(centre.as("administrator")) + "/", desk->addresses.front());
  const Heard heard = ask(port);
  EXPECT_TRUE(heard.answer.startsWith("HTTP/1.1 200")) << heard.answer.left(200).toStdString();
  EXPECT_EQ(heard.fingerprint, desk->fingerprint);
  const auto again = refusalOf({.port = port});
  ASSERT_TRUE(again);
  EXPECT_EQ(again->code(), ErrorCode::kBadParameter);
  EXPECT_EQ(centre.audited("setting.change"), 2) << "open, and the address of invitations";

  stopReviewDesk(centre.as("administrator"), place);

  EXPECT_FALSE(openReviewDesk(centre.as("administrator"), place));
  EXPECT_TRUE(ask(port).answer.isEmpty());
  EXPECT_EQ(centre.audited("setting.change"), 3);
}

TEST_F(ReviewDeskOfAStation, ReportsAPortInUseAndTheMessageOfTheProgram) {
  QTcpServer other;
  ASSERT_TRUE(other.listen(QHostAddress::LocalHost, port));

  const auto taken = refusalOf({.otherMachines = false, .port = port});

  ASSERT_TRUE(taken);
  EXPECT_EQ(taken->code(), ErrorCode::kBadParameter);
  EXPECT_EQ(taken->where(), std::to_string(port));
  other.close();
  const std::filesystem::path nonsense = centre.folder() / "nonsense.pem";
  writeFileAtomically(nonsense, "no certificate");
  const auto refused = refusalOf({.port = port, .certificate = nonsense, .key = nonsense});
  ASSERT_TRUE(refused);
  EXPECT_EQ(refused->code(), ErrorCode::kFileUnreadable);
  EXPECT_NE(refused->where().find("certificate"), std::string::npos) << refused->where();
  const auto half = refusalOf({.port = port, .certificate = nonsense});
  ASSERT_TRUE(half);
  EXPECT_EQ(half->code(), ErrorCode::kBadParameter);
  EXPECT_EQ(centre.audited("setting.change"), 0);
}

TEST_F(ReviewDeskOfAStation, CanBeOpenedOnlyForARecordOnThisMachine) {
  EXPECT_TRUE(mayOpenReviewDesk(centre.as("administrator")));
  SeededIdSource ids(3);
  SessionContext remote(
      centre.connection(), ids,
      {"postgresql://torsio@db.example.org/torsio", "station", centre.as("administrator").actor()},
      [] { return kStudyTime_us; });

  EXPECT_FALSE(mayOpenReviewDesk(remote));
  EXPECT_THROW(startReviewDesk(remote, place, {.port = port}), Error);
}

TEST(Serve, EndsWithItsParentProcess) {
  StudyCentre centre;
  QProcess owner;
  owner.start(QStringLiteral("sleep"), {QStringLiteral("600")});
  ASSERT_TRUE(owner.waitForStarted());
  QProcess desk;
  desk.start(
      QStringLiteral(TORSIO_PROGRAM),
      {QStringLiteral("serve"), QStringLiteral("--database"),
       QString::fromStdString(centre.session().key().locator), QStringLiteral("--listen"),
       QStringLiteral("127.0.0.1:0"), QStringLiteral("--ends-with"), QString::number(owner.processId())});
  ASSERT_TRUE(desk.waitForReadyRead(kPatience_ms)) << desk.readAllStandardError().toStdString();

  owner.kill();
  owner.waitForFinished();

  EXPECT_TRUE(desk.waitForFinished(kPatience_ms));
  EXPECT_EQ(desk.exitCode(), 0);
}

}  // namespace
}  // namespace torsio
