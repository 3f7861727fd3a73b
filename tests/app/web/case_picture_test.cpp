// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures of recordings for browsers: as close to the window's as docs/server.md promises, and small
// enough for a slow line. Bases of shapes: deviations of drawn vertices.

#include "app/web/case_picture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <map>
#include <string>
#include <vector>

#include <QByteArray>
#include <QImage>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "app/services/base/assets.h"
#include "app/services/review/blinded_case.h"
#include "app/web/organ_shelf.h"
#include "app/web/shapes/shape_basis.h"
#include "sim/scene/blood_map.h"
#include "sim/scene/scene.h"
#include "sim/scene/skin/tissue_skin.h"
#include "tests/app/support/review_centre.h"
#include "tests/app/web/web_client.h"
#include "tests/sim/servo/bar_scene.h"

namespace torsio::web {

namespace {

struct Organ {
  const char* scene;
  const char* pattern;
};

class CasePictureOf : public ::testing::TestWithParam<Organ> {};

TEST_P(CasePictureOf, IsWithinAFifthOfAMillimetreAndSmall) {
  SceneRequest request;
  request.assets = assetsFolder();
  request.id = GetParam().scene;
  request.pattern = GetParam().pattern;
  const Scene scene = loadScene(request);
  ReviewCentre centre({.raters = 1, .trainees = 1, .trial_s = 8.0, .scene = &scene});
  const auto physician = centre.physician(0);

  OrganShelf shelf;
  const CasePicture picture =
      casePicture(loadBlindedRecording(*physician, centre.cases(0).front()), assetsFolder(), shelf);

  ASSERT_FALSE(picture.organ.empty());
  EXPECT_LE(picture.farthest_mm, kWithin_mm);
  const std::string about = unpackedGzip(picture.organ).substr(0, 4000);
  const std::size_t named = about.find("\"skin\":\"");
  ASSERT_NE(named, std::string::npos);
  const auto skin = shelf.find(about.substr(named + 8, 32));
  ASSERT_NE(skin, nullptr);
  const std::size_t body = about.find("\"body\":\"");
  ASSERT_NE(body, std::string::npos);
  ASSERT_EQ(shelf.find(about.substr(body + 8, 32)), picture.body);
  // With 0.1 MB of pages: 1.5 MB until a first case is usable.
  EXPECT_LE(picture.organ.size() + picture.body->size() + picture.recording.size() + skin->size(),
            1'300'000U);
  const std::string head = unpackedGzip(picture.recording).substr(0, 4000);
  const bool undone = std::string(GetParam().pattern) == "detorse";
  for (const char* trace : {"flow_percent", "dose", "patency_percent", "pressure_mmHg"}) {
    EXPECT_EQ(head.find(trace) != std::string::npos, undone) << trace;
  }
  EXPECT_EQ(about.find("\"blood\"") != std::string::npos, undone) << "the colour of its blood";
  for (const std::string& packed : {picture.organ, *picture.body, picture.recording, *skin}) {
    const std::string bytes = unpackedGzip(packed);
    for (const std::string& secret : centre.secrets()) {
      EXPECT_EQ(bytes.find(secret), std::string::npos) << secret;
    }
  }
  RecordProperty("farthest_um", static_cast<int>(std::lround(1000.0F * picture.farthest_mm)));
  RecordProperty("organ_bytes", static_cast<int>(picture.organ.size()));
  RecordProperty("body_bytes", static_cast<int>(picture.body->size()));
  RecordProperty("skin_bytes", static_cast<int>(skin->size()));
  RecordProperty("recording_bytes", static_cast<int>(picture.recording.size()));
}

TEST(CasePicture, RecordingsOfAnOrganShareItsBody) {
  SceneRequest request;
  request.assets = assetsFolder();
  request.id = "forearm";
  const Scene scene = loadScene(request);
  ReviewCentre centre({.raters = 1, .trainees = 2, .trial_s = 4.0, .scene = &scene});
  const auto physician = centre.physician(0);
  const std::vector<AssignmentId> cases = centre.cases(0);
  ASSERT_EQ(cases.size(), 2U);
  OrganShelf shelf;

  const CasePicture one = casePicture(loadBlindedRecording(*physician, cases[0]), assetsFolder(), shelf);
  std::string name;
  {
    const CasePicture other = casePicture(loadBlindedRecording(*physician, cases[1]), assetsFolder(), shelf);
    EXPECT_EQ(one.body, other.body);
    EXPECT_LT(other.organ.size(), other.body->size() / 3) << "what a second case still takes";
    const std::string about = unpackedGzip(other.organ).substr(0, 4000);
    name = about.substr(about.find("\"body\":\"") + 8, 32);
  }
  EXPECT_EQ(shelf.find(name), one.body);
}

INSTANTIATE_TEST_SUITE_P(Shipped, CasePictureOf,
                         ::testing::Values(Organ{"forearm", ""}, Organ{"stomach", ""},
                                           Organ{"small-bowel-loop", "detorse"}),
                         [](const auto& organ) {
                           std::string name = organ.param.scene;
                           std::erase(name, '-');
                           return name;
                         });

// Colours of organs in pages compared with the window's.

/// Like container.js: arrays as numbers, with differences and multiples resolved.
struct ReadContainer {
  nlohmann::json meta;
  std::map<std::string, std::vector<double>> arrays;
};

template <typename Value>
std::vector<double> numbersAt(const std::string& bytes, std::size_t offset, std::size_t count,
                              std::size_t stride) {
  std::vector<Value> values(count);
  std::memcpy(values.data(), bytes.data() + offset, count * sizeof(Value));
  for (std::size_t i = stride; stride > 0 && i < count; ++i) {
    values[i] = static_cast<Value>(values[i] + values[i - stride]);
  }
  return {values.begin(), values.end()};
}

ReadContainer readContainer(const std::string& bytes) {
  constexpr std::size_t kHead = 8;
  std::uint32_t length = 0;
  std::memcpy(&length, bytes.data() + 4, sizeof length);
  const nlohmann::json head = nlohmann::json::parse(bytes.substr(kHead, length));
  ReadContainer read{head.at("meta"), {}};
  for (const nlohmann::json& one : head.at("arrays")) {
    const std::string type = one.at("type");
    const std::size_t offset = kHead + length + one.at("offset").get<std::size_t>();
    const std::size_t count = one.at("count");
    const std::size_t stride = one.value("delta", std::size_t{0});
    std::vector<double> values;
    if (type == "u8") {
      values = numbersAt<std::uint8_t>(bytes, offset, count, stride);
    } else if (type == "i16") {
      values = numbersAt<std::int16_t>(bytes, offset, count, stride);
    } else if (type == "u32") {
      values = numbersAt<std::uint32_t>(bytes, offset, count, stride);
    } else {
      values = numbersAt<float>(bytes, offset, count, stride);
    }
    for (double& value : values) {
      value *= one.value("scale", 1.0);
    }
    read.arrays.emplace(one.at("name"), std::move(values));
  }
  return read;
}

QImage pictureOf(const std::vector<double>& bytes) {
  QByteArray file;
  for (const double byte : bytes) {
    file.append(static_cast<char>(static_cast<unsigned char>(byte)));
  }
  return QImage::fromData(file);
}

TEST(SkinPicture, HasTheColoursAndPositionsOfTheWindowsSkin) {
  SceneRequest request;
  request.assets = assetsFolder();
  request.id = "stomach";
  const Scene scene = loadScene(request);
  const TissueSkin painted = paintSkin(scene, tissueLook(scene.id));
  OrganShelf shelf;

  const std::string name = shelf.putSkin(scene);

  EXPECT_EQ(shelf.putSkin(scene), name);
  EXPECT_EQ(shelf.find("0123456789abcdef0123456789abcdef"), nullptr);
  ASSERT_NE(shelf.find(name), nullptr);
  RecordProperty("skin_bytes", static_cast<int>(shelf.find(name)->size()));
  EXPECT_LE(shelf.find(name)->size(), 650'000U);
  const ReadContainer read = readContainer(unpackedGzip(*shelf.find(name)));
  const QImage colour = pictureOf(read.arrays.at("colour"));
  const QImage relief = pictureOf(read.arrays.at("relief"));
  const SkinCharts& charts = painted.charts;
  ASSERT_EQ(colour.size(), QSize(charts.width, charts.height));
  ASSERT_EQ(relief.size(), QSize(charts.width / 2, charts.height / 2));
  ASSERT_EQ(read.arrays.at("corner").size(), charts.corners.size());
  ASSERT_EQ(read.arrays.at("index").size(), 3 * charts.triangles.size());
  double away = 0.0;
  std::size_t far = 0;
  double height = 0.0;
  for (std::size_t i = 0; i < charts.corners.size(); ++i) {
    ASSERT_EQ(read.arrays.at("corner")[i], charts.corners[i].vertex);
    ASSERT_NEAR(read.arrays.at("place")[2 * i], static_cast<double>(charts.corners[i].place[0]), 0.04);
    ASSERT_NEAR(read.arrays.at("place")[2 * i + 1], static_cast<double>(charts.corners[i].place[1]), 0.04);
    const auto x = static_cast<int>(charts.corners[i].place[0]);
    const auto y = static_cast<int>(charts.corners[i].place[1]);
    const std::size_t at = 4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(charts.width) +
                                static_cast<std::size_t>(x));
    const QRgb shown = colour.pixel(x, y);
    const int worst =
        std::max({std::abs(qRed(shown) - painted.rgba[at]), std::abs(qGreen(shown) - painted.rgba[at + 1]),
                  std::abs(qBlue(shown) - painted.rgba[at + 2])});
    away += worst;
    far += worst > 20 ? 1 : 0;
    height += std::abs(
        qGray(relief.pixel(std::min(x / 2, relief.width() - 1), std::min(y / 2, relief.height() - 1))) -
        painted.rgba[at + 3]);
  }
  const auto corners = static_cast<double>(charts.corners.size());
  EXPECT_LT(away / corners, 4.0) << "of 255";
  EXPECT_LT(static_cast<double>(far) / corners, 0.01);
  EXPECT_LT(height / corners, 6.0);
  for (std::size_t t = 0; t < charts.triangles.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      ASSERT_EQ(read.arrays.at("index")[3 * t + k], charts.triangles[t][k]);
    }
  }
}

TEST(BloodPaint, MixesToTheWindowsColours) {
  const auto scene = std::make_shared<const Scene>(hollowScene(twistedTube()));
  const BloodMap map(scene);
  OrganState sound = scene->stateAt(0.0);
  sound.hollow.saturation = 0.78;
  OrganState bruised = sound;
  bruised.hollow.congestion = 0.8;
  bruised.hollow.reading.flow = 0.3;
  bruised.hollow.marks[0] = {.arc_m = 0.30, .round_rad = 1.0, .tick = 10, .torn = false};
  bruised.hollow.markCount = 1;
  OrganState clipped = bruised;
  clipped.hollow.marks[1] = {.arc_m = 0.302, .round_rad = 1.1, .tick = 20, .torn = true};
  clipped.hollow.markCount = 2;
  clipped.hollow.clipped = true;
  OrganState released = clipped;
  released.hollow.clipped = false;
  const std::vector<OrganState> states{sound, bruised, clipped, released};
  const std::vector<std::size_t> frames{0, 1, 1, 2, 3};
  BinaryContainer container;

  addBloodPaint(container, map, states, frames);

  const ReadContainer read = readContainer(container.bytes());
  ASSERT_EQ(read.meta.at("paints").size(), 3U);
  const std::size_t vertices = scene->mesh.vertices_m.size();
  std::size_t bruises = 0;
  for (std::size_t frame = 0; frame < frames.size(); ++frame) {
    std::vector<std::array<float, 3>> drawn(vertices);
    map.evaluate(states[frames[frame]], drawn);
    for (std::size_t v = 0; v < vertices; ++v) {
      for (std::size_t k = 0; k < 3; ++k) {
        double mixed = 1.0;
        mixed += read.arrays.at("fed")[v] / 255.0 * (read.arrays.at("blood")[3 * frame + k] - mixed);
        std::size_t layer = 0;
        for (const nlohmann::json& paint : read.meta.at("paints")) {
          if (frame >= paint.at("from") && frame < paint.at("to")) {
            const double share = read.arrays.at("paint")[layer * vertices + v] / 255.0;
            bruises += share > 0.5 ? 1 : 0;
            mixed += share * (paint.at("factor").at(k).get<double>() - mixed);
          }
          ++layer;
        }
        ASSERT_NEAR(mixed, static_cast<double>(drawn[v][k]), 0.006) << "frame " << frame << " vertex " << v;
      }
    }
  }
  EXPECT_GT(bruises, 20U) << "something was painted at all";
}

TEST(BloodPaint, DoesNotChangeAnOrganWithoutBlood) {
  BinaryContainer container;

  addBloodPaint(container, BloodMap(std::make_shared<const Scene>(barScene())), {}, {});

  EXPECT_TRUE(readContainer(container.bytes()).arrays.empty());
}

/// A tube of radius 30 and length 200 rotated by `angle` at its far end, mm.
std::vector<float> tube(double angle) {
  std::vector<float> places;
  for (int ring = 0; ring <= 20; ++ring) {
    for (int side = 0; side < 16; ++side) {
      const double along = ring / 20.0;
      const double around = side * 0.392699081698724 + angle * along;
      places.push_back(static_cast<float>(30.0 * std::cos(around)));
      places.push_back(static_cast<float>(30.0 * std::sin(around)));
      places.push_back(static_cast<float>(200.0 * along));
    }
  }
  return places;
}

/// Largest deviation of the shape as a page computes it.
float farthestDrawn(const ShapeBasis& basis, const std::vector<float>& weights,
                    const std::vector<float>& shape) {
  float farthest = 0.0F;
  for (std::size_t vertex = 0; vertex < shape.size(); vertex += 3) {
    float square = 0.0F;
    for (std::size_t i = vertex; i < vertex + 3; ++i) {
      float place = basis.mean[i];
      for (std::size_t k = 0; k < weights.size(); ++k) {
        place += weights[k] * basis.scale[k] * static_cast<float>(basis.steps[k * shape.size() + i]);
      }
      square += (place - shape[i]) * (place - shape[i]);
    }
    farthest = std::max(farthest, std::sqrt(square));
  }
  return farthest;
}

TEST(ShapeBasis, ReproducesEveryShapeWithinTheBound) {
  std::vector<std::vector<float>> shapes;
  for (int i = 0; i <= 61; ++i) {
    shapes.push_back(tube(i * 0.05));
  }
  ShapeFitter fitter(shapes.front(), 0.15F, 40);
  fitter.learn(std::vector<std::vector<float>>{shapes[0], shapes[20], shapes[40], shapes[61]}, 0.15F);
  const std::size_t learnt = fitter.basis().components();

  const std::vector<ShapeFitter::Fit> fits = fitter.fit(shapes);

  ASSERT_EQ(fits.size(), shapes.size());
  EXPECT_GE(fitter.basis().components(), learnt);
  EXPECT_LT(fitter.basis().components(), 20U);
  for (std::size_t s = 0; s < shapes.size(); ++s) {
    const float drawn = farthestDrawn(fitter.basis(), fits[s].weights, shapes[s]);
    EXPECT_LE(drawn, 0.15F + 1e-3F) << s;
    EXPECT_NEAR(fits[s].farthest, drawn, 1e-3F) << "what is told is what is drawn";
    for (const float weight : fits[s].weights) {
      EXPECT_NEAR(weight / kWeightStep_mm, std::round(weight / kWeightStep_mm), 1e-2F);
    }
  }
}

TEST(ShapeBasis, LearnsNothingTwice) {
  std::vector<std::vector<float>> shapes;
  for (int i = 0; i <= 30; ++i) {
    shapes.push_back(tube(i * 0.1));
  }
  ShapeFitter fitter(shapes.front(), 0.15F, 40);
  fitter.learn(shapes, 0.15F);
  const std::size_t learnt = fitter.basis().components();

  fitter.learn(shapes, 0.15F);
  EXPECT_EQ(fitter.basis().components(), learnt);
  shapes.push_back(tube(1.0));
  for (std::size_t i = 0; i < shapes.back().size(); i += 3) {
    shapes.back()[i] += 10.0F;  // not a rotation
  }
  fitter.learn(shapes, 0.15F);

  EXPECT_GT(fitter.basis().components(), learnt);
  EXPECT_LE(fitter.basis().components(), learnt + 2);
  for (const ShapeFitter::Fit& fit : fitter.fit(shapes)) {
    for (const float weight : fit.weights) {
      EXPECT_LT(std::abs(weight), 100.0F) << "no components that cancel each other";
    }
  }
}

TEST(ShapeBasis, CanBeSplitIntoTwoParts) {
  const std::vector<std::vector<float>> shapes{tube(0.0), tube(1.0), tube(2.0), tube(3.0)};
  ShapeFitter fitter(shapes.front(), 0.05F, 40);
  fitter.learn(shapes, 0.15F);
  const ShapeBasis& whole = fitter.basis();
  ASSERT_GE(whole.components(), 2U);

  const ShapeBasis first = whole.upTo(1);
  const ShapeBasis others = whole.from(1);

  EXPECT_EQ(first.mean, whole.mean);
  EXPECT_EQ(first.components() + others.components(), whole.components());
  std::vector<std::int16_t> steps = first.steps;
  steps.insert(steps.end(), others.steps.begin(), others.steps.end());
  EXPECT_EQ(steps, whole.steps);
  EXPECT_EQ(whole.from(whole.components()).components(), 0U);
}

TEST(ShapeBasis, OneShapeNeedsNoComponent) {
  const std::vector<std::vector<float>> shapes{tube(0.3), tube(0.3)};
  ShapeFitter fitter(shapes.front(), 0.1F, 40);

  const std::vector<ShapeFitter::Fit> fits = fitter.fit(shapes);

  EXPECT_EQ(fitter.basis().components(), 0U);
  EXPECT_LE(fits[1].farthest, 0.01F) << "the mean is rounded";
}

TEST(ShapeBasis, StopsAtTheMaximumAndReturnsTheDeviation) {
  const std::vector<std::vector<float>> shapes{tube(0.0), tube(1.0), tube(2.0), tube(3.0)};
  ShapeFitter fitter(shapes.front(), 0.05F, 2);

  const std::vector<ShapeFitter::Fit> fits = fitter.fit(shapes);

  EXPECT_EQ(fitter.basis().components(), 2U);
  EXPECT_GT(fits.back().farthest, 0.05F);
}

}  // namespace

}  // namespace torsio::web
