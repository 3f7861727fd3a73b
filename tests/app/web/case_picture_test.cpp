// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures of recordings for browsers: as close to the window's as docs/server.md promises, and small enough
// for a slow line.
#include "app/web/case_picture.h"

#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "app/services/base/assets.h"
#include "app/services/review/blinded_case.h"
#include "sim/scene/scene.h"
#include "tests/app/support/review_centre.h"
#include "tests/app/web/web_client.h"

namespace torsio::web {
namespace {

using torsio::testing::ReviewCentre;

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
  const std::string about = torsio::testing::unpackedGzip(picture.organ).substr(0, 4000);
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
  const std::string head = torsio::testing::unpackedGzip(picture.recording).substr(0, 4000);
  const bool undone = std::string(GetParam().pattern) == "detorse";
  for (const char* trace : {"flow_percent", "dose", "patency_percent", "pressure_mmHg"}) {
    EXPECT_EQ(head.find(trace) != std::string::npos, undone) << trace;
  }
  EXPECT_EQ(about.find("\"blood\"") != std::string::npos, undone) << "the colour of its blood";
  for (const std::string& packed : {picture.organ, *picture.body, picture.recording, *skin}) {
    const std::string bytes = torsio::testing::unpackedGzip(packed);
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
    const std::string about = torsio::testing::unpackedGzip(other.organ).substr(0, 4000);
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

}  // namespace
}  // namespace torsio::web
