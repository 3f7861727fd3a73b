// SPDX-License-Identifier: GPL-3.0-or-later
// Screens of importing an organ, with a shipped organ as if a user had brought it.
#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include <QComboBox>
#include <QCoreApplication>

#include "app/gui/organ/instrument_panel.h"
#include "app/gui/organ/organ_picture.h"
#include "app/gui/organ/organ_wizard.h"
#include "app/gui/organ/scan_panel.h"
#include "app/gui/practice/practice_page.h"
#include "app/gui/widgets/child.h"
#include "sim/geometry/mesh/mesh_import.h"
#include "sim/geometry/query/collision_mesh.h"
#include "sim/imaging/surface/scan_preview.h"
#include "sim/scene/instrument_import.h"

namespace torsio::gui {

namespace {

OrganWizard& bringStomach(Page& page, const QString& anatomy) {
  OrganWizard& wizard = static_cast<PracticePage&>(page).bringOrgan();
  wizard.begin();
  auto& chosen = child<QComboBox>(wizard, "anatomy");
  chosen.setCurrentIndex(chosen.findData(anatomy));
  wizard.judgeMesh(wizard.assets() / "organs" / "stomach.ply");
  while (!wizard.trial()) {
    QCoreApplication::processEvents();
  }
  return wizard;
}

/// CT value of a gas-filled stomach at this distance outside the lumen.
std::int16_t valueAround(double distance_mm) {
  constexpr double kWall_mm = 4.0;
  constexpr std::int16_t kGas_HU = -1000;
  constexpr std::int16_t kTissue_HU = 40;
  constexpr std::int16_t kFat_HU = -100;
  return distance_mm < 0.0 ? kGas_HU : distance_mm < kWall_mm ? kTissue_HU : kFat_HU;
}

/// Makes synthetic slices of a shipped organ, with the mask of its lumen.
ScanPreview stomachSlices(const std::filesystem::path& assets) {
  constexpr double kVoxel_mm = 2.5;
  constexpr double kMargin_mm = 15.0;
  constexpr double kMillimetres = 1000.0;
  const TriangleMesh mesh = importMesh(assets / "organs" / "stomach.ply");
  Vec3 low = mesh.vertices_m.front();
  Vec3 high = low;
  for (const Vec3& v : mesh.vertices_m) {
    low = {std::min(low.x, v.x), std::min(low.y, v.y), std::min(low.z, v.z)};
    high = {std::max(high.x, v.x), std::max(high.y, v.y), std::max(high.z, v.z)};
  }
  ScanPreview preview;
  ScanVolume& volume = preview.volume;
  const Vec3 side_mm = kMillimetres * (high - low) + Vec3{2, 2, 2} * kMargin_mm;
  const std::array<double, 3> sides{side_mm.x, side_mm.y, side_mm.z};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    volume.count[axis] = static_cast<std::size_t>(sides[axis] / kVoxel_mm);
  }
  volume.step_mm = {Vec3{kVoxel_mm, 0, 0}, Vec3{0, kVoxel_mm, 0}, Vec3{0, 0, kVoxel_mm}};
  volume.origin_mm = kMillimetres * low - Vec3{1, 1, 1} * kMargin_mm;
  const CollisionMesh surface(mesh);
  std::uint32_t near = 0;
  for (std::size_t n = 0; n < volume.count[0] * volume.count[1] * volume.count[2]; ++n) {
    const std::size_t row = n / volume.count[0];
    const std::size_t slice = row / volume.count[1];
    const Vec3 place_mm =
        volume.place_mm({static_cast<double>(n % volume.count[0]), static_cast<double>(row % volume.count[1]),
                         static_cast<double>(slice)});
    const SurfacePoint point = surface.closest(place_mm / kMillimetres, near);
    near = point.triangle;
    const double distance_mm = kMillimetres * point.distance_m;
    volume.values.push_back(valueAround(distance_mm));
    preview.within.push_back(distance_mm < 0.0 ? 1 : 0);
  }
  return preview;
}

void showSlices(Page& page) {
  OrganWizard& wizard = static_cast<PracticePage&>(page).bringOrgan();
  wizard.begin();
  ScanPreview preview = stomachSlices(wizard.assets());
  wizard.showScan({}, preview);
  ScanPanel& panel = wizard.scanPanel();
  auto& tissue = child<QComboBox>(wizard, "tissue");
  tissue.setCurrentIndex(static_cast<int>(ScanTissue::kGasLumen));
  panel.setFound(std::move(preview));
  panel.lookAt({55.0, 10.0, -10.0});
}

/// Shows the shipped grasper as if its CAD model had been imported.
void showInstrument(Page& page) {
  OrganWizard& wizard = static_cast<PracticePage&>(page).bringOrgan();
  const std::filesystem::path folder = wizard.assets() / "instruments";
  TriangleMesh whole;
  for (const char* part : {"shaft", "jaw_upper", "jaw_lower"}) {
    const TriangleMesh mesh =
        importMesh(folder / (std::string("grasper_") + part + ".ply"), {.organ = false});
    const auto first = static_cast<std::uint32_t>(whole.vertices_m.size());
    whole.vertices_m.insert(whole.vertices_m.end(), mesh.vertices_m.begin(), mesh.vertices_m.end());
    for (const TriangleMesh::Triangle& t : mesh.triangles) {
      whole.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
    }
  }
  wizard.begin();
  wizard.showToolMesh(folder / "grasper_shaft.ply");
  wizard.instrument().setTool(toolOfMesh({std::move(whole), {}}, wizard.instrument().meshRequest()));
}

ScreenEntry organScreen(const char* name, std::function<void(Page&)> prepare) {
  return {.name = QString::fromLatin1(name),
          .role = QStringLiteral("trainee"),
          .pageId = PageId::kPractice,
          .argument = [](SessionContext&) { return QVariant(); },
          .prepare = std::move(prepare)};
}

}  // namespace

std::vector<ScreenEntry> organScreens() {
  constexpr double kShown_deg = 45.0;
  return {
      organScreen("organ-source", [](Page& page) { static_cast<PracticePage&>(page).bringOrgan().begin(); }),
      organScreen("organ-slices", &showSlices), organScreen("organ-instrument", &showInstrument),
      organScreen(
          "organ-accepted",
          [](Page& page) { bringStomach(page, QStringLiteral("stomach")).picture().twist(kShown_deg); }),
      organScreen("organ-refused",
                  [](Page& page) { static_cast<void>(bringStomach(page, QStringLiteral("testis"))); })};
}

}  // namespace torsio::gui
