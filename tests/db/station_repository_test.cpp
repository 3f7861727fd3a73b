// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/repository/trial/station_repository.h"

#include "assessment/domain/study/station_state.h"
#include "db/connection/connection.h"
#include "db/connection/db_error.h"
#include "db/repository/trial/trial_repository.h"
#include "tests/db/sample_record.h"
#include "tests/support/stored_rows.h"

namespace torsio {
namespace {

class StationRepositoryTest : public SampleTest {
 protected:
  StationRepository stations() { return StationRepository(connection()); }
};

TEST_F(StationRepositoryTest, ShowsWhichStationOwnsARunningTrial) {
  const std::string id = sample().ids.newUuid();
  TrialRepository trials(connection(), {"room 2", ""});
  trials.begin(sampleHeader(id, "T-01"));

  stations().heartbeat(
      {.station = "room 2", .trialId = id, .userId = "u", .heartbeatUtc_us = kSampleTime_us});

  // Another station reads the board.
  Connection other = open();
  const std::optional<StationState> owner = stationOnBoard(other, "room 2");
  ASSERT_TRUE(owner.has_value());
  EXPECT_EQ(owner->trialId, id);
  EXPECT_EQ(owner->heartbeatUtc_us, kSampleTime_us);
  EXPECT_EQ(owner->userId, "u");
  EXPECT_EQ(owner->traineeCode, "T-01");
  EXPECT_EQ(owner->sceneId, "forearm");
  EXPECT_EQ(owner->phaseLabel, "virtual 0-20 min");
  EXPECT_EQ(owner->startedUtc_us, kSampleTime_us);
  EXPECT_FALSE(owner->ended);
}

TEST_F(StationRepositoryTest, TheBoardDistinguishesEndedFromRunningTrials) {
  const std::string id = sample().ids.newUuid();
  TrialRepository trials(connection(), {"room 2", ""});
  trials.begin(sampleHeader(id, "T-01"));
  stations().heartbeat({.station = "room 2", .trialId = id, .heartbeatUtc_us = kSampleTime_us});
  ASSERT_FALSE(stationOnBoard(connection(), "room 2")->ended);

  trials.finish({0, 0, 0, TrialOutcome::kCompleted, "hash"});

  EXPECT_TRUE(stationOnBoard(connection(), "room 2")->ended);
}

TEST_F(StationRepositoryTest, EachHeartbeatOverwritesThePreviousOne) {
  stations().heartbeat({.station = "b", .userId = "u", .softwareVersion = "0.1", .heartbeatUtc_us = 1});
  stations().heartbeat({.station = "a", .heartbeatUtc_us = 2});
  stations().heartbeat({.station = "b", .softwareVersion = "0.2", .heartbeatUtc_us = 3});

  const std::vector<StationState> board = stations().board();
  ASSERT_EQ(board.size(), 2U);
  EXPECT_EQ(board[0].station, "a");
  EXPECT_EQ(board[1].userId, "");
  EXPECT_EQ(board[1].softwareVersion, "0.2");
  EXPECT_EQ(board[1].heartbeatUtc_us, 3);
  stations().leave("a");
  EXPECT_FALSE(stationOnBoard(connection(), "a").has_value());
  EXPECT_EQ(faultFrom([&] { stations().heartbeat({.station = "c", .trialId = "none"}); }),
            DbFault::kForeignKey);
}

TEST_F(StationRepositoryTest, KeepsTheStateOfAStationsDevice) {
  stations().heartbeat({.station = "office", .heartbeatUtc_us = 1});
  stations().heartbeat({.station = "room 1",
                        .heartbeatUtc_us = 1,
                        .deviceJson = "[\"Touch\"]",
                        .deviceHaptic = true,
                        .deviceLight = "red",
                        .deviceProblemJson = "[\"cable\"]",
                        .deviceCheckedUtc_us = kSampleTime_us});

  const std::vector<StationState> board = stations().board();

  ASSERT_EQ(board.size(), 2U);
  EXPECT_EQ(board[0].deviceJson, "");
  EXPECT_FALSE(board[0].deviceHaptic);
  EXPECT_EQ(board[0].deviceCheckedUtc_us, 0);
  EXPECT_EQ(board[1].deviceJson, "[\"Touch\"]");
  EXPECT_TRUE(board[1].deviceHaptic);
  EXPECT_EQ(board[1].deviceLight, "red");
  EXPECT_EQ(board[1].deviceProblemJson, "[\"cable\"]");
  EXPECT_EQ(board[1].deviceCheckedUtc_us, kSampleTime_us);
  stations().heartbeat(
      {.station = "room 1", .heartbeatUtc_us = 2, .deviceJson = "[\"Touch\"]", .deviceLight = "green"});
  EXPECT_EQ(stationOnBoard(connection(), "room 1")->deviceLight, "green");
  EXPECT_EQ(stationOnBoard(connection(), "room 1")->deviceProblemJson, "");
  EXPECT_EQ(faultFrom([&] { stations().heartbeat({.station = "c", .deviceLight = "purple"}); }),
            DbFault::kCheck);
}

}  // namespace
}  // namespace torsio
