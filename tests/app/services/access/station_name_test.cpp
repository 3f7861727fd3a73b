// SPDX-License-Identifier: GPL-3.0-or-later
// The name of a station is made once and kept beside its settings.
#include "app/services/access/station_name.h"

#include <string>

#include <QSettings>
#include <QSysInfo>
#include <QTemporaryDir>
#include <gtest/gtest.h>

namespace torsio {
namespace {

/// Uses the settings of a folder, as a window with its own XDG_CONFIG_HOME does.
void use(const QTemporaryDir& folder) {
  QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, folder.path());
}

TEST(StationName, IsMadeOnceForEachSetOfSettings) {
  const QTemporaryDir one;
  const QTemporaryDir other;
  const std::string computer = QSysInfo::machineHostName().toStdString();
  use(one);
  EXPECT_FALSE(stationSign().made);
  EXPECT_EQ(stationName(), computer);

  ASSERT_TRUE(makeStationName());
  const std::string name = stationName();
  ASSERT_TRUE(makeStationName());

  EXPECT_EQ(stationName(), name);
  EXPECT_TRUE(name.starts_with(computer + "-")) << name;
  EXPECT_EQ(stationSign().computer, computer);
  use(other);
  ASSERT_TRUE(makeStationName());
  EXPECT_NE(stationName(), name) << "two windows on one computer with different settings";
  use(one);
  EXPECT_EQ(stationName(), name);
}

TEST(StationName, StaysWhenTheComputerIsRenamedAndChangesOnlyWhenAsked) {
  const QTemporaryDir folder;
  use(folder);
  ASSERT_TRUE(makeStationName());
  QSettings stored(QSettings::IniFormat, QSettings::UserScope, "torsio", "station");
  stored.setValue("station/name", "before-the-renaming-k7f2q");
  stored.sync();

  ASSERT_TRUE(makeStationName());
  EXPECT_EQ(stationName(), "before-the-renaming-k7f2q");
  EXPECT_EQ(stationSign().computer, QSysInfo::machineHostName().toStdString());
  renewStationName();
  EXPECT_NE(stationName(), "before-the-renaming-k7f2q");
  EXPECT_NE(twinWords(stationName()).str().find(stationName()), std::string::npos);
  EXPECT_NE(twinRemedy().str().find("torsio station renew"), std::string::npos);
}

}  // namespace
}  // namespace torsio
