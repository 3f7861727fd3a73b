// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/anatomy/shipped_files.h"

#include <array>
#include <cmath>
#include <cstdio>
#include <span>
#include <utility>
#include <vector>

#include "sim/anatomy/forearm.h"
#include "sim/anatomy/grasper.h"
#include "sim/anatomy/stomach.h"
#include "sim/anatomy/volvulus_organs.h"
#include "sim/core/angle.h"
#include "sim/geometry/mesh/mesh_export.h"

namespace torsio {

namespace {

constexpr const char* kProvenance = "synthetic: drawn by torsio_make_organs (sim/anatomy), no patient data";
constexpr const char* kLicence = "CC0-1.0 or GPL-3.0-or-later, as you like";

std::string ply(const TriangleMesh& mesh, const std::string& what, const std::string& dimensions,
                std::span<const std::array<float, 2>> texture = {}) {
  MeshExportOptions options;
  options.texture = texture;
  options.normals = !texture.empty();
  options.comments = {"Torsio: " + what, kProvenance, "dimensions: " + dimensions,
                      std::string("licence: ") + kLicence};
  return plyBytes(mesh, options);
}

// Hundredths of a millimetre, and never "-0.00".
std::string hundredths(double value) {
  const double rounded = std::round(value * 100.0) / 100.0;
  std::array<char, 40> text{};
  std::snprintf(text.data(), text.size(), "%.2f", rounded == 0.0 ? 0.0 : rounded);
  return text.data();
}

std::string vectorText(const Vec3& v) {
  std::string text = "[";
  text.append(hundredths(v.x)).append(", ").append(hundredths(v.y)).append(", ").append(hundredths(v.z));
  return text + "]";
}

std::string millimetres(const Vec3& metres) {
  return vectorText(1000.0 * metres);
}

class JsonObject {
 public:
  explicit JsonObject(std::string indent = "  ") : indent_(std::move(indent)) {}
  JsonObject& text(const char* key, const std::string& value) {
    std::string quoted;
    for (const char c : value) {
      quoted.append(c == '"' || c == '\\' ? 1U : 0U, '\\').append(1, c);
    }
    return raw(key, '"' + quoted + '"');
  }
  JsonObject& raw(const char* key, const std::string& value) {
    if (!body_.empty()) {
      body_ += ",\n";
    }
    body_.append(indent_).append(1, '"').append(key).append("\": ").append(value);
    return *this;
  }
  [[nodiscard]] std::string lines() const { return "{\n" + body_ + "\n" + indent_.substr(2) + "}"; }

 private:
  std::string indent_;
  std::string body_;
};

std::string ply(const TubeOrgan& organ, const std::string& what, const std::string& dimensions) {
  return ply(organ.surface, what, dimensions, organ.texture);
}

std::string linesOf(const std::vector<std::string>& entries) {
  std::string text = "[";
  for (const std::string& entry : entries) {
    text += (text.size() > 1 ? ",\n    " : "\n    ") + entry;
  }
  return text + "\n  ]";
}

std::string polyline(const std::vector<Vec3>& points_m) {
  std::vector<std::string> points;
  points.reserve(points_m.size());
  for (const Vec3& p : points_m) {
    points.push_back(millimetres(p));
  }
  return linesOf(points);
}

std::string placesJson(const std::vector<OrganPlace>& places) {
  std::vector<std::string> entries;
  for (const OrganPlace& place : places) {
    JsonObject one("      ");
    one.raw("number", std::to_string(entries.size() + 1))
        .text("name", place.name)
        .raw("position_mm", millimetres(place.position_m))
        .raw("arc_mm", hundredths(place.arc_mm))
        .raw("angle_deg", hundredths(place.angle_deg));
    entries.push_back(one.lines());
  }
  return linesOf(entries);
}

std::string stomachJson(const WholeStomach& stomach) {
  std::vector<std::string> wall;
  for (const StomachWall& at : stomach.wall) {
    std::string pair = "[";
    pair.append(hundredths(at.share)).append(", ").append(hundredths(at.thickness_mm)).append("]");
    wall.push_back(std::move(pair));
  }
  JsonObject json;
  json.text("organ", "stomach.ply").text("provenance", kProvenance).text("licence", kLicence);
  json.text(
      "frame",
      "LPS; arc_mm along the centreline from the pylorus towards the top of the fundus; angles about it, "
      "right-handed in that direction, from the lesser curvature over the front and the greater curvature to "
      "the back");
  json.raw("fixed_end_mm", millimetres(stomach.organ.fixedEnd_m));
  json.raw("free_end_mm", millimetres(stomach.organ.freeEnd_m));
  json.raw("ridge_zero", vectorText(stomach.organ.ridgeZero));
  json.raw("length_mm", hundredths(stomach.length_mm));
  json.raw("cardia_mm", millimetres(stomach.cardia_m)).raw("oesophagus", vectorText(stomach.oesophagus));
  json.raw("wall_mm", linesOf(wall));
  json.raw("zero_line_mm", polyline(stomach.zeroLine_m));
  json.raw("greater_omentum_mm", polyline(stomach.greaterOmentum_m));
  json.raw("lesser_omentum_mm", polyline(stomach.lesserOmentum_m));
  json.raw("markers", placesJson(stomach.markers));
  json.raw("landmarks", placesJson(stomach.landmarks));
  return json.lines() + "\n";
}

/// Markers, zero line and length of a tube-like organ. `angles`: what its angles mean.
std::string markersJson(const TubeOrgan& organ, const char* file, const std::string& angles) {
  JsonObject json;
  json.text("organ", file).text("provenance", kProvenance).text("licence", kLicence);
  json.text("frame",
            "LPS; arc_mm along the centreline from the fixed end; angles about it, right-handed in that "
            "direction, " +
                angles);
  json.raw("fixed_end_mm", millimetres(organ.fixedEnd_m)).raw("free_end_mm", millimetres(organ.freeEnd_m));
  json.raw("length_mm", hundredths(organ.length_mm));
  json.raw("zero_line_mm", polyline(organ.places.zeroLine_m));
  json.raw("markers", placesJson(organ.places.markers));
  return json.lines() + "\n";
}

std::string grasperJson(const Grasper& g) {
  JsonObject jaws("    ");
  jaws.raw("pivot_mm", millimetres(g.jawPivot_m)).raw("axis", vectorText({1, 0, 0}));
  jaws.raw("opening_deg", hundredths(degrees(g.jawOpening_rad)));
  JsonObject meshes("    ");
  meshes.text("shaft", "grasper_shaft.ply").text("upper_jaw", "grasper_jaw_upper.ply");
  meshes.text("lower_jaw", "grasper_jaw_lower.ply").text("hand", "gloved_hand.ply");
  JsonObject json;
  json.text("id", "grasper").text("title", "Straight grasper, 5 mm").text("provenance", kProvenance);
  json.text("licence", kLicence);
  json.text(
      "frame",
      "tip at the origin, shaft along +z towards the hand; the upper jaw (y > 0) opens by +angle about the "
      "axis through the pivot, the lower by -angle");
  json.raw("tip_mm", vectorText({})).raw("shaft_axis", vectorText({0, 0, 1}));
  json.raw("shaft_length_mm", hundredths(1000.0 * g.shaftLength_m));
  json.raw("shaft_radius_mm", hundredths(1000.0 * g.shaftRadius_m));
  json.raw("tip_radius_mm", "2.50").raw("grip_reach_mm", "4.00");
  json.raw("jaws", jaws.lines()).raw("meshes", meshes.lines());
  return json.lines() + "\n";
}

}  // namespace

std::string armMarkersJson(const Arm& arm, const std::string& file) {
  std::vector<OrganPlace> markers;
  for (const ArmMarker& m : arm.markers) {
    markers.push_back({m.name, 1000.0 * m.arc_m, degrees(m.angle_rad), m.position_m});
  }
  JsonObject json;
  json.text("organ", file).text("provenance", kProvenance).text("licence", kLicence);
  json.text(
      "frame",
      "LPS; axis along +z, elbow at z = 0, fingers up; thumb at +x, back of the hand at +y; arc_mm along the "
      "axis from the elbow; angles about it from +x (radial) over +y (dorsal)");
  json.raw("fixed_end_mm", millimetres(arm.fixedEnd_m)).raw("wrist_mm", millimetres(arm.wrist_m));
  json.raw("free_end_mm", millimetres(arm.freeEnd_m)).raw("ridge_zero", vectorText(arm.ridgeZero));
  json.raw("length_mm", hundredths(1000.0 * arm.freeEnd_m.z));
  json.raw("zero_line_mm", polyline(arm.zeroLine_m));
  json.raw("markers", placesJson(markers));
  return json.lines() + "\n";
}

std::vector<ShippedFile> shippedFiles() {
  const Arm arm = makeArm();
  const WholeStomach stomach = makeWholeStomach();
  const Grasper grasper = makeGrasper();
  const TubeOrgan intestine = makeIntestine();
  const TubeOrgan testis = makeTestis();
  const TubeOrgan sigmoid = makeSigmoid();
  const TubeOrgan bowelLoop = makeBowelLoop();
  const TubeOrgan midgut = makeMidgut();
  const std::string grasperSize = "a usual 5 mm laparoscopic grasper";
  return {
      {"organs/forearm.ply",
       ply(arm.surface, "right forearm and hand, straight, supinated",
           "a man's means of ANSUR II (2012); fingers after Chatzioglou 2024, Anat Cell Biol 57:172",
           arm.texture)},
      {"organs/forearm_markers.json", armMarkersJson(arm, "forearm.ply")},
      {"organs/stomach.ply",
       ply(stomach.organ, "stomach with oesophagus, cardia, fundus, antrum, pylorus and bulb",
           "centreline 267 mm, 0.73 l, moderately full; curvatures, widths and wall after sources on the "
           "page of "
           "organ dimensions")},
      {"organs/stomach_markers.json", stomachJson(stomach)},
      {"organs/former/stomach.ply",
       ply(makeStomach().surface, "J-shaped stomach, moderately full",
           "centreline 267 mm, 0.71 l, section widths after the BodyParts3D stomach and MRI of "
           "fed adults")},
      {"organs/intestine.ply",
       ply(intestine, "loop of small intestine", "200 mm long, 26 mm wide, typical of adults")},
      {"organs/intestine_markers.json",
       markersJson(intestine, "intestine.ply", "from the antimesenteric border")},
      {"organs/former/intestine.ply",
       ply(makeFormerIntestine(), "loop of small intestine", "200 mm long, 26 mm wide, typical of adults")},
      {"organs/testis.ply",
       ply(testis, "left testis on its cord", "testis 50 x 30 x 20 mm, cord 60 mm long, 12 mm wide")},
      {"organs/testis_markers.json",
       markersJson(testis, "testis.ply",
                   "from the medial side over the back (epididymis) and the lateral side")},
      {"organs/sigmoid.ply", ply(sigmoid, "omega loop of sigmoid colon, dilated",
                                 "limbs 200 mm long on a root of 40 mm, 60 to 80 mm wide; assumed")},
      {"organs/sigmoid_markers.json",
       markersJson(sigmoid, "sigmoid.ply", "from the taenia libera, opposite the mesenteric border")},
      {"organs/bowel_loop.ply", ply(bowelLoop, "closed loop of small intestine on a narrow root",
                                    "345 mm long, 26 mm wide, feet 32 mm apart; assumed")},
      {"organs/bowel_loop_markers.json",
       markersJson(bowelLoop, "bowel_loop.ply", "from the antimesenteric border")},
      {"organs/midgut.ply", ply(midgut, "pack of small-bowel coils and jejunal limb on their stalk",
                                "pack 124 x 70 x 104 mm, stalk 60 mm long, 16 mm wide; assumed")},
      {"organs/former/midgut.ply", ply(makeFormerMidgut(), "pack of small-bowel coils on its stalk",
                                       "pack 124 x 70 x 104 mm, stalk 60 mm long, 16 mm wide; assumed")},
      {"organs/midgut_markers.json",
       markersJson(midgut, "midgut.ply", "from the patient's left over the head's side and the right")},
      {"instruments/grasper.json", grasperJson(grasper)},
      {"instruments/gloved_hand.ply", ply(makeGlovedHand(), "gloved right hand about the end of a shaft",
                                          "a man's hand, 84 mm broad at the fingers; assumed")},
      {"instruments/grasper_shaft.ply", ply(grasper.shaft, "shaft of a grasper", grasperSize)},
      {"instruments/grasper_jaw_upper.ply", ply(grasper.upperJaw, "upper jaw of a grasper", grasperSize)},
      {"instruments/grasper_jaw_lower.ply", ply(grasper.lowerJaw, "lower jaw of a grasper", grasperSize)},
  };
}

std::vector<ShippedFile> fineOrgans() {
  // Edges by the root of the triangles' number.
  const std::string dimensions = "as the shipped mesh";
  const Arm arm = makeArm({}, 0.43);
  return {{"forearm.ply", ply(arm.surface, "right forearm and hand", dimensions, arm.texture)},
          {"stomach.ply", ply(makeWholeStomach(0.45).organ, "stomach", dimensions)},
          {"intestine.ply", ply(makeIntestine(0.446), "loop of small intestine", dimensions)},
          {"testis.ply", ply(makeTestis(0.46), "left testis on its cord", dimensions)},
          {"sigmoid.ply", ply(makeSigmoid(0.465), "omega loop of sigmoid colon", dimensions)},
          {"bowel_loop.ply", ply(makeBowelLoop(0.45), "loop of small intestine", dimensions)},
          {"midgut.ply", ply(makeMidgut(0.433), "pack of small-bowel coils", dimensions)}};
}

}  // namespace torsio
