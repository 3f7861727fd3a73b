// SPDX-License-Identifier: GPL-3.0-or-later
// The vertex shader of the organ (assets/shaders) as a program of its own, whose vertices are read back,
// against Scene::deform. On whatever draws: a graphics card, or Mesa's llvmpipe.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <memory>
#include <string>
#include <vector>

#include <QFile>
#include <QGuiApplication>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QOpenGLExtraFunctions>
#include <gtest/gtest.h>

#include "sim/core/angle.h"
#include "sim/scene/blood_map.h"
#include "sim/scene/hollow_organ.h"
#include "sim/scene/scene.h"
#include "sim/scene/shader_skin.h"
#include "sim/servo/contact_coupling.h"
#include "tests/support/shipped_scene.h"

namespace torsio {
namespace {

constexpr double kSame_m = 0.0002;
constexpr int kWide = 1024;

QByteArray textOf(const char* name) {
  QFile file(QStringLiteral(TORSIO_SOURCE_DIR "/assets/shaders/") + QLatin1String(name));
  EXPECT_TRUE(file.open(QIODevice::ReadOnly));
  return file.readAll();
}

/// What Qt Quick 3D puts round a vertex shader.
QByteArray wholeShader() {
  return QByteArray(R"(#version 330 core
in vec4 vertexColour;
uniform sampler2D organVertices;
uniform sampler2D organNeighbours;
uniform sampler2D organRows;
uniform vec3 organBlood;
uniform vec4 dentPlace0;
uniform vec4 dentDepth0;
uniform vec4 dentPlace1;
uniform vec4 dentDepth1;
vec2 UV1;
vec3 TANGENT;
vec4 COLOR;
out vec3 VERTEX;
out vec3 NORMAL;
#define VARYING out
#define MAIN moved
)") + textOf("organ_place.glsl") +
         textOf("moved_tissue.vert") + QByteArray(R"(
void main()
{
    UV1 = vec2(0.0, float(gl_VertexID));
    TANGENT = vec3(0.0);
    COLOR = vertexColour;
    moved();
    gl_Position = vec4(VERTEX, 1.0);
}
)");
}

/// The shader with a context of its own, and what it made of each vertex.
class OrganShader {
 public:
  struct Out {
    float rest[3];
    float arc;
    float tint[3];
    float place_mm[3];
    float normal[3];
  };
  static_assert(sizeof(Out) == 13 * sizeof(float));

  OrganShader() {
    QSurfaceFormat format;
    format.setVersion(3, 3);
    format.setProfile(QSurfaceFormat::CoreProfile);
    context_.setFormat(format);
    surface_.setFormat(format);
    surface_.create();
    ready_ = context_.create() && context_.makeCurrent(&surface_);
    if (ready_) {
      gl_ = context_.extraFunctions();
      link();
    }
  }
  [[nodiscard]] bool ready() const { return ready_; }
  [[nodiscard]] std::string renderer() {
    return reinterpret_cast<const char*>(gl_->glGetString(GL_RENDERER));
  }

  void setOrgan(const ShaderSkin& skin) {
    count_ = skin.vertices().size() / ShaderSkin::kVertexTexels;
    texture(0, "organVertices", GL_RGBA32F, GL_RGBA, 4, skin.vertices().front().data(),
            skin.vertices().size(), kWide);
    texture(1, "organNeighbours", GL_R32F, GL_RED, 1, skin.neighbours().data(), skin.neighbours().size(),
            kWide);
  }

  std::vector<Out> run(const ShaderSkin& skin, const std::array<float, 3>& blood,
                       const std::vector<std::array<float, 4>>& covers, const ContactPatch& dent) {
    texture(2, "organRows", GL_RGBA32F, GL_RGBA, 4, skin.rows().front().data(), skin.rows().size(),
            static_cast<int>(ShaderSkin::kRowTexels));
    gl_->glUniform3f(at("organBlood"), blood[0], blood[1], blood[2]);
    four("dentPlace0", dent.point_m, dent.radius_m);
    four("dentDepth0", -dent.depth_m * dent.normal, dent.toolRadius_m);
    four("dentPlace1", {}, 0.0);
    four("dentDepth1", {}, 0.0);
    GLuint array = 0;
    gl_->glGenVertexArrays(1, &array);
    gl_->glBindVertexArray(array);
    GLuint buffers[2] = {};
    gl_->glGenBuffers(2, buffers);
    gl_->glBindBuffer(GL_ARRAY_BUFFER, buffers[0]);
    gl_->glBufferData(GL_ARRAY_BUFFER, static_cast<qopengl_GLsizeiptr>(covers.size() * 16), covers.data(),
                      GL_STATIC_DRAW);
    gl_->glEnableVertexAttribArray(0);
    gl_->glVertexAttribPointer(0, 4, GL_FLOAT, GL_FALSE, 0, nullptr);
    const auto bytes = static_cast<qopengl_GLsizeiptr>(count_ * sizeof(Out));
    gl_->glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, buffers[1]);
    gl_->glBufferData(GL_TRANSFORM_FEEDBACK_BUFFER, bytes, nullptr, GL_STATIC_READ);
    gl_->glEnable(GL_RASTERIZER_DISCARD);
    gl_->glBeginTransformFeedback(GL_POINTS);
    gl_->glDrawArrays(GL_POINTS, 0, static_cast<GLsizei>(count_));
    gl_->glEndTransformFeedback();
    std::vector<Out> out(count_);
    const void* seen = gl_->glMapBufferRange(GL_TRANSFORM_FEEDBACK_BUFFER, 0, bytes, GL_MAP_READ_BIT);
    if (seen != nullptr) {
      std::memcpy(out.data(), seen, static_cast<std::size_t>(bytes));
    }
    gl_->glUnmapBuffer(GL_TRANSFORM_FEEDBACK_BUFFER);
    gl_->glDeleteBuffers(2, buffers);
    gl_->glDeleteVertexArrays(1, &array);
    EXPECT_EQ(gl_->glGetError(), static_cast<GLenum>(GL_NO_ERROR));
    return out;
  }

 private:
  void link() {
    const QByteArray text = wholeShader();
    const GLuint shader = gl_->glCreateShader(GL_VERTEX_SHADER);
    const char* source = text.constData();
    gl_->glShaderSource(shader, 1, &source, nullptr);
    gl_->glCompileShader(shader);
    program_ = gl_->glCreateProgram();
    gl_->glAttachShader(program_, shader);
    gl_->glBindAttribLocation(program_, 0, "vertexColour");
    const char* names[] = {"rest", "arc", "tint", "VERTEX", "NORMAL"};
    gl_->glTransformFeedbackVaryings(program_, 5, names, GL_INTERLEAVED_ATTRIBS);
    gl_->glLinkProgram(program_);
    GLint linked = 0;
    gl_->glGetProgramiv(program_, GL_LINK_STATUS, &linked);
    char log[4096] = {};
    gl_->glGetShaderInfoLog(shader, sizeof log, nullptr, log);
    ASSERT_EQ(linked, GL_TRUE) << log;
    gl_->glUseProgram(program_);
  }
  [[nodiscard]] GLint at(const char* name) { return gl_->glGetUniformLocation(program_, name); }
  void four(const char* name, const Vec3& v, double w) {
    gl_->glUniform4f(at(name), static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z),
                     static_cast<float>(w));
  }
  void texture(int unit, const char* name, GLint inside, GLenum format, std::size_t each,
               const float* numbers, std::size_t texels, int wide) {
    const std::size_t lines = (texels + static_cast<std::size_t>(wide) - 1) / static_cast<std::size_t>(wide);
    std::vector<float> filled(lines * static_cast<std::size_t>(wide) * each);
    std::copy_n(numbers, texels * each, filled.begin());
    gl_->glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    GLuint& made = textures_[static_cast<std::size_t>(unit)];
    if (made == 0) {
      gl_->glGenTextures(1, &made);
    }
    gl_->glBindTexture(GL_TEXTURE_2D, made);
    gl_->glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    gl_->glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    gl_->glTexImage2D(GL_TEXTURE_2D, 0, inside, wide, static_cast<GLsizei>(lines), 0, format, GL_FLOAT,
                      filled.data());
    gl_->glUniform1i(at(name), unit);
  }

  QOpenGLContext context_;
  QOffscreenSurface surface_;
  QOpenGLExtraFunctions* gl_ = nullptr;
  bool ready_ = false;
  GLuint program_ = 0;
  std::array<GLuint, 3> textures_{};
  std::size_t count_ = 0;
};

/// How far the farthest vertex is from the processor's, m; dented.
double farthest_m(const Scene& scene, const OrganState& state, const ContactPatch& dent,
                  const std::vector<OrganShader::Out>& out) {
  std::vector<Vec3> expected_m(scene.mesh.vertices_m.size());
  scene.deform(state, expected_m);
  double most_m = 0.0;
  for (std::size_t v = 0; v < expected_m.size(); ++v) {
    const Vec3 lies_m = expected_m[v] + indentationAt(dent, expected_m[v]);
    const float* p = out[v].place_mm;
    most_m = std::max(most_m, norm(Vec3{p[0], -p[2], p[1]} * 0.001 - lies_m));
  }
  return most_m;
}

TEST(OrganShader, PutsEveryVertexOfEveryShippedPatternWhereTheProcessorPutsIt) {
  OrganShader shader;
  ASSERT_TRUE(shader.ready()) << "no OpenGL 3.3";
  RecordProperty("renderer", shader.renderer());
  double worst_m = 0.0;
  const std::filesystem::path assets = testing::shippedRequest("forearm", {}).assets;
  for (const std::string& id : sceneIds(assets)) {
    for (const std::string& pattern : patternIds(assets, id)) {
      SCOPED_TRACE(id + ' ' + pattern);
      const auto scene = std::make_shared<const Scene>(testing::shippedScene(id, pattern));
      const BloodMap blood(scene);
      std::optional<ShaderSkin> skin =
          ShaderSkin::of(scene, blood.empty() ? std::vector<float>{} : blood.fed());
      ASSERT_TRUE(skin.has_value());
      shader.setOrgan(*skin);
      const std::vector<std::array<float, 4>> covers(scene->mesh.vertices_m.size(), {0.0F, 0.0F, 0.0F, 1.0F});
      const double most_rad =
          scene->hollow ? scene->hollow->detorsion().start.most_rad : scene->pattern.targetAngle_rad;
      for (const double share : {0.0, 0.3, 1.0, -0.6}) {
        const OrganState state = scene->stateAt(share * most_rad);
        skin->update(state);
        const Vec3 touched_m = skin->place_m(7);
        const ContactPatch dent{touched_m, normalized(skin->normal_m2(7)), 0.004, 0.0025, 0.02};
        const double far_m =
            farthest_m(*scene, state, dent, shader.run(*skin, {1.0F, 1.0F, 1.0F}, covers, dent));
        EXPECT_LT(far_m, kSame_m) << share;
        worst_m = std::max(worst_m, far_m);
      }
    }
  }
  RecordProperty("worst_um", static_cast<int>(1e6 * worst_m));
}

TEST(OrganShader, HasNormalsAndColoursOfTheProcessor) {
  OrganShader shader;
  ASSERT_TRUE(shader.ready()) << "no OpenGL 3.3";
  const auto scene = std::make_shared<const Scene>(testing::shippedScene("sigmoid", "detorse"));
  const BloodMap blood(scene);
  std::optional<ShaderSkin> skin = ShaderSkin::of(scene, blood.fed());
  ASSERT_TRUE(skin.has_value());
  shader.setOrgan(*skin);
  OrganState state = scene->stateAt(radians(200.0));
  state.hollow.markCount = 2;
  state.hollow.marks[0] = {.arc_m = 0.5 * scene->lattice().length_m(), .round_rad = 0.3};
  state.hollow.marks[1] = {
      .arc_m = 0.5 * scene->lattice().length_m() + 0.004, .round_rad = 0.3, .torn = true};
  state.hollow.clipped = true;
  std::vector<std::array<float, 4>> covers(scene->mesh.vertices_m.size());
  blood.cover(state, covers);
  std::vector<std::array<float, 3>> factors(covers.size());
  blood.evaluate(state, factors);
  skin->update(state);
  const std::vector<OrganShader::Out> out =
      shader.run(*skin, BloodMap::twistedFactor(state.hollow), covers, {});
  for (std::uint32_t v = 0; v < out.size(); ++v) {
    const Vec3 normal = normalized(skin->normal_m2(v));
    const float* n = out[v].normal;
    EXPECT_GT(dot(normal, Vec3{n[0], -n[2], n[1]}), std::cos(radians(1.0))) << v;
    for (std::size_t k = 0; k < 3; ++k) {
      const double encoded = factors[v][k];
      const double linear = encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
      EXPECT_NEAR(out[v].tint[k], linear, 2e-3) << v;
    }
  }
}

}  // namespace
}  // namespace torsio

int main(int argc, char** argv) {
  const QGuiApplication application(argc, argv);
  ::testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
