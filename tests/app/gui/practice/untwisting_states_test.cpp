// SPDX-License-Identifier: GPL-3.0-or-later
// The states in which organs that come twisted are pictured, and the buttons that explain them.
#include <cmath>
#include <filesystem>
#include <utility>

#include <QComboBox>
#include <QStyle>
#include <QStyleOptionComboBox>
#include <gtest/gtest.h>

#include "app/gui/practice/simulator_window.h"
#include "app/gui/simulator/exercise_panel.h"
#include "app/gui/simulator/posed_states.h"
#include "sim/scene/hollow_organ.h"
#include "sim/scene/scene_file.h"
#include "sim/tissue/hollow/perfusion.h"

namespace torsio::gui {
namespace {

const std::filesystem::path kAssets = std::filesystem::path(TORSIO_SOURCE_DIR) / "assets";

// At 8 mmHg, the antrum of its former organ is squeezed to the packed radius with a fifth of its lumen open.
TEST(UntwistingStates, ClosedOnesAreShutAndIschaemicOnesHaveBeenTwistedLong) {
  SceneRequest request;
  request.assets = kAssets;
  request.id = "gastric-organo-axial";
  request.pattern = "detorse";
  request.former = true;
  const Scene scene = loadScene(request);
  const double pressure_Pa = scene.hollow->detorsion().wall.pressure_Pa;
  ASSERT_GT(scene.hollow->patency(scene.hollow->closing_rad(pressure_Pa), pressure_Pa), 0.1);

  const LiveState closed = untwistingState(scene, UntwistingState::kClosed);
  const LiveState ischaemic = untwistingState(scene, UntwistingState::kIschaemic);
  const LiveState recovered = untwistingState(scene, UntwistingState::kRecovered);

  EXPECT_LE(closed.hollow.reading.patency, kShutPatency);
  EXPECT_EQ(closed.hollow.scaled_s, 0.0);
  EXPECT_GT(ischaemic.hollow.scaled_s, 3600.0);
  EXPECT_GT(recovered.hollow.scaled_s, ischaemic.hollow.scaled_s);
}

// A stomach has four arteries and is rarely strangulated: at the largest twist of this scene, 77 % of the
// flow remain, which is enough, and nothing is lost. It is congested all the same, visibly.
TEST(UntwistingStates, ACongestedOrganIsDiscolouredLikeAnIschaemicOne) {
  for (const auto& [id, starves] : {std::pair{"gastric-mesentero-axial", false}, std::pair{"midgut", true}}) {
    SceneRequest request;
    request.assets = kAssets;
    request.id = id;
    request.pattern = "detorse";
    const Scene scene = loadScene(request);

    const HollowPose pose = untwistingState(scene, UntwistingState::kIschaemic).hollow;

    const TissueColour colour = colourOf({.flow = pose.reading.flow,
                                          .congestion = pose.congestion,
                                          .dose = pose.reading.dose,
                                          .saturation = pose.saturation});
    EXPECT_GT(std::hypot(colour.red - kSerosaPink.red, colour.green - kSerosaPink.green,
                         colour.blue - kSerosaPink.blue),
              0.28)
        << id;
    EXPECT_EQ(pose.reading.flow < scene.hollow->detorsion().vessels.enoughFlow, starves) << id;
    EXPECT_EQ(pose.reading.dose > 0.0, starves) << id;
  }
}

TEST(ExerciseBoxes, ShowFullNamesOfAnOrganInASmallWindow) {
  WindowSetup setup;
  setup.assets = kAssets;
  setup.remember = false;
  SimulatorWindow window(setup);
  window.resize(1280, 800);
  window.showNormal();
  const auto* panel = window.findChild<ExercisePanel*>();
  ASSERT_NE(panel, nullptr);
  const auto* box = panel->findChild<QComboBox*>();
  ASSERT_NE(box, nullptr);
  ASSERT_GE(box->count(), 9);

  QStyleOptionComboBox option;
  option.initFrom(box);
  option.editable = false;
  const int room =
      box->style()->subControlRect(QStyle::CC_ComboBox, &option, QStyle::SC_ComboBoxEditField, box).width();
  for (int i = 0; i < box->count(); ++i) {
    EXPECT_LE(box->fontMetrics().horizontalAdvance(box->itemText(i)), room) << box->itemText(i).toStdString();
  }
}

}  // namespace
}  // namespace torsio::gui
