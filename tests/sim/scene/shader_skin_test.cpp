// SPDX-License-Identifier: GPL-3.0-or-later
// The skin as the vertex shader deforms it, in the processor's arithmetic, against Scene::deform.
// tests/app/gui/scene/organ_shader_test.cpp runs the shader itself.
#include "sim/scene/shader_skin.h"

#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "sim/core/angle.h"
#include "sim/scene/blood_map.h"
#include "sim/scene/hollow_organ.h"
#include "sim/scene/scene.h"
#include "tests/support/shipped_scene.h"

namespace torsio {
namespace {

constexpr double kSame_m = 0.0002;

double farthest_m(const Scene& scene, ShaderSkin& skin, const OrganState& state) {
  std::vector<Vec3> expected_m(scene.mesh.vertices_m.size());
  scene.deform(state, expected_m);
  skin.update(state);
  double most_m = 0.0;
  for (std::uint32_t v = 0; v < expected_m.size(); ++v) {
    most_m = std::max(most_m, norm(skin.place_m(v) - expected_m[v]));
  }
  return most_m;
}

TEST(ShaderSkin, PutsEveryVertexOfEveryShippedPatternWhereTheProcessorPutsIt) {
  const std::filesystem::path assets = testing::shippedRequest("forearm", {}).assets;
  double worst_m = 0.0;
  for (const std::string& id : sceneIds(assets)) {
    for (const std::string& pattern : patternIds(assets, id)) {
      SCOPED_TRACE(id + ' ' + pattern);
      const auto scene = std::make_shared<const Scene>(testing::shippedScene(id, pattern));
      std::optional<ShaderSkin> skin = ShaderSkin::of(scene, {});
      ASSERT_TRUE(skin.has_value());
      const double most_rad =
          scene->hollow ? scene->hollow->detorsion().start.most_rad : scene->pattern.targetAngle_rad;
      for (const double share : {0.0, 0.03, 0.31, 0.62, 1.0, -0.55, -1.0}) {
        OrganState state = scene->stateAt(share * most_rad);
        const double far_m = farthest_m(*scene, *skin, state);
        EXPECT_LT(far_m, kSame_m) << share;
        worst_m = std::max(worst_m, far_m);
        state.hollow.reading.pressure_Pa *= 0.3;
        EXPECT_LT(farthest_m(*scene, *skin, state), kSame_m) << share << ", vented";
      }
    }
  }
  RecordProperty("worst_um", static_cast<int>(1e6 * worst_m));
}

TEST(ShaderSkin, HasTheNormalsOfTheTriangles) {
  const auto scene = std::make_shared<const Scene>(testing::shippedScene("stomach"));
  std::optional<ShaderSkin> skin = ShaderSkin::of(scene, {});
  ASSERT_TRUE(skin.has_value());
  const OrganState state = scene->stateAt(scene->pattern.targetAngle_rad);
  skin->update(state);
  std::vector<Vec3> at_m(scene->mesh.vertices_m.size());
  scene->deform(state, at_m);
  std::vector<Vec3> normals(at_m.size());
  for (const TriangleMesh::Triangle& t : scene->mesh.triangles) {
    const Vec3 normal = cross(at_m[t[1]] - at_m[t[0]], at_m[t[2]] - at_m[t[0]]);
    for (const std::uint32_t v : t) {
      normals[v] += normal;
    }
  }
  for (std::uint32_t v = 0; v < normals.size(); ++v) {
    EXPECT_GT(dot(normalized(normals[v]), normalized(skin->normal_m2(v))), std::cos(radians(2.0))) << v;
  }
}

TEST(ShaderSkin, IsNotOfThePapersFormulation) {
  SceneRequest request = testing::shippedRequest("forearm", {});
  request.formulation = Formulation::kPaper;
  EXPECT_FALSE(ShaderSkin::of(std::make_shared<const Scene>(loadScene(request)), {}).has_value());
}

}  // namespace
}  // namespace torsio
