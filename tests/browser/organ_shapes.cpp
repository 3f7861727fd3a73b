// SPDX-License-Identifier: GPL-3.0-or-later
// `organ_shapes FOLDER [SCENE ...]`: records each pattern of these scenes (default: all shipped ones) and
// writes, as FOLDER/SCENE.PATTERN.organ and .body, what a page receives, gzipped, and as .places the window's
// vertices: a BinaryContainer of "time_s" and "place_mm", three per vertex in the page's frame. Prints a line
// for each: name, largest rotation, bytes of body, organ, recording and skin, largest deviation known to the
// server (mm), and processor time of making it, skin included (s).
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include <QCoreApplication>

#include "app/services/base/assets.h"
#include "app/services/recording/trial_playback.h"
#include "app/services/review/blinded_case.h"
#include "app/web/binary_container.h"
#include "app/web/case_picture.h"
#include "app/web/organ_shelf.h"
#include "sim/scene/hollow_view.h"
#include "sim/scene/organ_state.h"
#include "sim/scene/scene.h"
#include "sim/servo/pose_track.h"
#include "sim/tissue/twist/twist_model_view.h"
#include "tests/app/support/review_centre.h"

namespace {

using namespace torsio;

constexpr double kTrial_s = 6.0;
constexpr std::int64_t kMoments = 24;

/// Vertices as the window draws them: inputs of view_scene.cpp, and TwistView for straight organs.
class WindowShapes {
 public:
  explicit WindowShapes(const std::shared_ptr<const Scene>& scene)
      : scene_(scene), places_m_(scene->mesh.vertices_m.size()) {
    if (scene->hollow) {
      hollow_ = std::make_unique<HollowView>(scene);
    } else if (!scene->rod) {
      twist_ = std::make_unique<TwistView>(scene->model);
    }
  }

  void append(const OrganState& state, std::vector<float>& to) {
    if (twist_) {
      std::vector<float> xyz(3 * places_m_.size());
      twist_->update(state.twist, xyz);
      for (std::size_t i = 0; i < places_m_.size(); ++i) {
        places_m_[i] = {xyz[3 * i], xyz[3 * i + 1], xyz[3 * i + 2]};
      }
    } else if (hollow_) {
      hollow_->deform(state, places_m_);
    } else {
      scene_->deform(state, places_m_);
    }
    constexpr double kMillimetres = 1000.0;
    for (const Vec3& place : places_m_) {
      for (const double part : {place.x, place.z, -place.y}) {
        to.push_back(static_cast<float>(kMillimetres * part));
      }
    }
  }

 private:
  std::shared_ptr<const Scene> scene_;
  std::vector<Vec3> places_m_;
  std::unique_ptr<HollowView> hollow_;
  std::unique_ptr<TwistView> twist_;
};

void write(const std::filesystem::path& file, const std::string& bytes) {
  std::ofstream(file, std::ios::binary) << bytes;
}

void tell(const std::filesystem::path& folder, const std::string& id, const std::string& pattern) {
  SceneRequest request;
  request.assets = assetsFolder();
  request.id = id;
  request.pattern = pattern;
  const auto scene = std::make_shared<const Scene>(loadScene(request));
  testing::ReviewCentre centre({.raters = 1, .trainees = 1, .trial_s = kTrial_s, .scene = scene.get()});
  const auto physician = centre.physician(0);
  const auto recording = [&] { return loadBlindedRecording(*physician, centre.cases(0).front()); };
  web::OrganShelf shelf;
  const std::clock_t begun = std::clock();
  const web::CasePicture picture = web::casePicture(recording(), assetsFolder(), shelf);
  const double took_s = static_cast<double>(std::clock() - begun) / CLOCKS_PER_SEC;

  TrialPlayback playback(recording().trial);
  playback.setPoses(PoseTrack(*scene, playback.header(), playback.chunks()));
  WindowShapes window(scene);
  std::vector<float> times_s;
  std::vector<float> places;
  double furthest_rad = 0.0;
  for (std::int64_t moment = 0; moment < kMoments; ++moment) {
    // Between frames as well: the page may ask for any time.
    playback.seek_us(playback.duration_us() * (2 * moment + 1) / (2 * kMoments));
    times_s.push_back(static_cast<float>(static_cast<double>(playback.position_us()) * 1e-6));
    const OrganState state = organStateOf(playback.state());
    furthest_rad = std::max(furthest_rad, std::abs(state.twist.graspAngle_rad));
    window.append(state, places);
  }
  web::BinaryContainer container;
  container.add("time_s", std::span<const float>(times_s));
  container.add("place_mm", std::span<const float>(places));
  const std::string name = id + "." + scene->pattern.id;
  write(folder / (name + ".organ"), picture.organ);
  write(folder / (name + ".body"), *picture.body);
  write(folder / (name + ".places"), container.bytes());
  std::cout << name << " " << furthest_rad << " " << picture.body->size() << " " << picture.organ.size()
            << " " << picture.recording.size() << " " << shelf.find(shelf.putSkin(*scene))->size() << " "
            << picture.farthest_mm << " " << took_s << std::endl;
}

}  // namespace

int main(int argc, char** argv) {
  const QCoreApplication application(argc, argv);
  if (argc < 2) {
    std::cerr << "organ_shapes FOLDER [SCENE ...]\n";
    return 2;
  }
  std::vector<std::string> ids(argv + 2, argv + argc);
  if (ids.empty()) {
    ids = sceneIds(assetsFolder());
  }
  for (const std::string& id : ids) {
    for (const std::string& pattern : patternIds(assetsFolder(), id)) {
      tell(argv[1], id, pattern);
    }
  }
  return 0;
}
