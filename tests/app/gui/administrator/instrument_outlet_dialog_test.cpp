// SPDX-License-Identifier: GPL-3.0-or-later
// The window outputs the instrument to other programs; a viewer made of OpenIGTLink's own classes connects.
#include "app/gui/administrator/station/instrument_outlet_dialog.h"

#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QSettings>
#include <QSpinBox>
#include <QTcpServer>
#include <QTest>

#include "app/connectors/tracker/instrument_outlet.h"
#include "app/connectors/tracker/tracker_choice.h"
#include "app/gui/widgets/child.h"
#include "tests/app/gui/support/maintenance_window.h"
#include "tests/support/fake_tracker.h"

namespace torsio::gui {
namespace {

class OutletPages : public MaintenancePages {
 protected:
  void SetUp() override {
    QSettings::setPath(QSettings::IniFormat, QSettings::UserScope,
                       folder_.path() + QStringLiteral("/settings"));
    MaintenancePages::SetUp();
    window_->desk()->open(PageId::kDevices);
  }
  static bool says(QDialog& dialog, const QString& words) {
    const auto& state = child<QLabel>(dialog, "outletState");
    return QTest::qWaitFor([&] { return state.text().contains(words); }, 30'000);
  }
  static int freePort() {
    QTcpServer free;
    free.listen(QHostAddress::LocalHost, 0);
    return free.serverPort();
  }
};

TEST_F(OutletPages, OfferTheInstrumentToOtherProgramsAndStopIt) {
  EXPECT_TRUE(child<QPushButton>(*window_->desk()->page(), "otherPrograms").isEnabled());
  const int port = freePort();
  InstrumentOutletDialog dialog(context(), window_.get());
  EXPECT_FALSE(child<QCheckBox>(dialog, "outletOn").isChecked()) << "off until somebody turns it on";
  EXPECT_TRUE(says(dialog, QStringLiteral("Nothing is offered")));

  child<QCheckBox>(dialog, "outletOn").setChecked(true);
  child<QSpinBox>(dialog, "outletPort").setValue(port);
  child<QPushButton>(dialog, "outletKeep").click();
  torsio::testing::FakeTracker slicer;
  ASSERT_TRUE(slicer.call(static_cast<std::uint16_t>(port)));
  EXPECT_TRUE(says(dialog, QStringLiteral("Connected: 1")));
  EXPECT_EQ(rememberedTracker().outletPort, port);
  EXPECT_EQ(rememberedTracker().outletAddress, "127.0.0.1");
  outletOfThisStation()->show({});
  EXPECT_EQ(slicer.receive().device, kOutletInstrument);
  EXPECT_TRUE(says(dialog, QStringLiteral("poses sent: 1")));

  child<QCheckBox>(dialog, "outletOn").setChecked(false);
  child<QPushButton>(dialog, "outletKeep").click();
  EXPECT_TRUE(says(dialog, QStringLiteral("Nothing is offered")));
  EXPECT_EQ(rememberedTracker().outletPort, 0);
  EXPECT_EQ(outletOfThisStation(), nullptr);
  EXPECT_TRUE(failures_.isEmpty());
}

TEST_F(OutletPages, ExplainTheWholeNetworkAndWhyAPortIsInUse) {
  QTcpServer taken;
  ASSERT_TRUE(taken.listen(QHostAddress::AnyIPv4, 0));
  InstrumentOutletDialog dialog(context(), window_.get());
  const auto& caution = child<QLabel>(dialog, "outletCaution");
  EXPECT_FALSE(caution.property("caution").toBool());

  child<QCheckBox>(dialog, "outletOn").setChecked(true);
  auto& who = child<QComboBox>(dialog, "outletWho");
  who.setCurrentIndex(who.findData(QStringLiteral("0.0.0.0")));
  child<QSpinBox>(dialog, "outletPort").setValue(taken.serverPort());
  EXPECT_TRUE(caution.property("caution").toBool());
  child<QPushButton>(dialog, "outletKeep").click();

  EXPECT_TRUE(says(dialog, QStringLiteral("cannot listen at this address")));
  EXPECT_TRUE(child<QLabel>(dialog, "outletState").property("caution").toBool());
}

}  // namespace
}  // namespace torsio::gui
