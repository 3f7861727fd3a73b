// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/simulator/loaded_scene.h"

#include <string>

#include "sim/core/error.h"

namespace torsio::gui {

LoadedScene loadSceneForView(const SceneRequest& request) {
  LoadedScene loaded;
  loaded.scene = std::make_shared<const Scene>(loadScene(request));
  // A user's organ does not look like the scene it borrows.
  const std::string tissue = request.organFile ? request.organFile->stem().string() : std::string();
  loaded.view = makeViewScene(loaded.scene, tissue);
  loaded.shape = showAsyncShape(*loaded.scene, loaded.view);
  if (!request.organFile) {
    loaded.view.markers = organMarkers(*loaded.scene, request.assets);
  }
  return loaded;
}

LoadedScene loadRecordedScene(const SceneLoader& loader, SceneRequest request, const TrialHeader& header) {
  request.tissue = header.model;
  for (const Formulation formulation : {Formulation::kSaintVenant, Formulation::kPaper}) {
    request.formulation = formulation;
    LoadedScene loaded = loader(request);
    if (loaded.scene->organHash == header.organHash && loaded.scene->parameterHash == header.parameterHash) {
      return loaded;
    }
  }
  throw Error(ErrorCode::kVerifyFailed,
              Text::tr("the organ or its parameters are not those of the recording"),
              Text::tr("run %1", header.trialId),
              Text::tr("Open the organ file of the recording first, or use the version that recorded it: %1",
                       header.softwareVersion));
}

std::shared_ptr<LatestShape> showAsyncShape(const Scene& scene, ViewScene& view) {
  if (!runsAsync(scene.tissue)) {
    return nullptr;
  }
  auto newest = std::make_shared<LatestShape>(scene);
  view.shapeNumber = [newest] { return newest->number(); };
  view.shape = [newest](std::span<Vec3> out_m) { newest->vertices(out_m); };
  return newest;
}

}  // namespace torsio::gui
