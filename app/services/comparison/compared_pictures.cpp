// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/comparison/compared_pictures.h"

#include <array>
#include <memory>
#include <optional>
#include <string>

#include "app/services/comparison/comparison_order.h"
#include "assessment/results/number_format.h"
#include "sim/core/angle.h"

namespace torsio {

namespace {

constexpr int kLinesAlong = 9;  // ridges drawn, so that a twist can be seen on a smooth organ
constexpr std::size_t kAtEndPerRow = 3;

ReliefPlace fromBehind(const Vec3& place_m) {
  const auto [x, y, z] = seenFromFront(place_m);
  return {-x, y, -z};
}

/// Draws the organ of a comparison in the poses of its models.
class Painter {
 public:
  explicit Painter(const ComparisonResult& result)
      : result_(result),
        triangles_(result.body, &result.body->mesh.triangles),
        places_m_(result.body->mesh.vertices_m.size()) {}

  [[nodiscard]] ReportRelief marked(const Text& caption, ReliefPlace (*seen)(const Vec3&)) const {
    ReportRelief relief{caption, triangles_, {}};
    for (const Vec3& place_m : result_.body->mesh.vertices_m) {
      relief.places.push_back(seen(place_m));
    }
    for (const OrganMarker& marker : result_.markers) {
      relief.marks.emplace_back(std::to_string(marker.number), seen(marker.position_m));
    }
    return relief;
  }

  [[nodiscard]] ReportRelief posed(const ModelPose& pose, const Text& caption) {
    const bool held = !result_.options.grasp;
    result_.body->skin.deform(pose.places, held ? std::optional(pose.angle_rad) : std::nullopt, places_m_);
    ReportRelief relief{caption, triangles_, {}};
    for (const Vec3& place_m : places_m_) {
      relief.places.push_back(seenFromFront(place_m));
    }
    for (int i = 0; i < kLinesAlong; ++i) {
      std::vector<ReliefPlace> line;
      for (int section = 0; section < pose.places.sections; ++section) {
        line.push_back(seenFromFront(pose.places.at(section, i * pose.places.ridges / kLinesAlong)));
      }
      relief.lines.push_back(std::move(line));
    }
    return relief;
  }

 private:
  const ComparisonResult& result_;
  std::shared_ptr<const std::vector<TriangleMesh::Triangle>> triangles_;
  std::vector<Vec3> places_m_;
};

Text turnOf(double angle_rad) {
  return formatFixed(degrees(angle_rad), 1) + "\u00b0";
}

ReportFigure picturesOf(const std::string& id, const Text& title) {
  ReportFigure figure;
  figure.id = id;
  figure.title = title;
  figure.kind = FigureKind::kReliefs;
  figure.valuesInLabels = true;
  return figure;
}

ReportFigure markerPicture(const ComparisonResult& result, const Painter& painter) {
  ReportFigure figure = picturesOf("figure-11", Text::tr("The markers (Fig. 11)"));
  FigureSeries row;
  row.reliefs.push_back(painter.marked(Text::tr("from the front"), seenFromFront));
  row.reliefs.push_back(painter.marked(Text::tr("from behind"), fromBehind));
  figure.series.push_back(std::move(row));
  std::string names;
  for (const OrganMarker& marker : result.markers) {
    names += (names.empty() ? "" : ", ") + std::to_string(marker.number) + " " + marker.name;
  }
  figure.notes = {Text::tr("%1.", names)};
  return figure;
}

ReportFigure endPicture(const ComparisonResult& result, Painter& painter) {
  ReportFigure figure = picturesOf(
      "pictures-end",
      Text::tr("Every model in equilibrium with the torque of %1 N m", formatFixed(result.torque_Nm, 4)));
  for (const ModelResult& model : result.models) {
    if (figure.series.empty() || figure.series.back().reliefs.size() == kAtEndPerRow) {
      figure.series.emplace_back();
    }
    const Text turn = turnOf(model.atRest.angle_rad);
    figure.series.back().reliefs.push_back(
        painter.posed(model.atRest, model.noEquilibrium.empty()
                                        ? Text::tr("%1, %2", shortName(model.id), turn)
                                        : Text::tr("%1, no equilibrium: last frame", shortName(model.id))));
  }
  figure.notes = {
      Text::tr("Seen from the front, all in one scale. Lines: %1 of the ridges, straight along "
               "the organ at rest.",
               kLinesAlong)};
  return figure;
}

ReportFigure filmStrip(const ComparisonResult& result, Painter& painter) {
  ReportFigure figure =
      picturesOf("figures-8-9-12", Text::tr("The twist of every model (Figs. 8, 9 and 12)"));
  for (std::size_t i = 0; i <= kFilmSteps; ++i) {
    const double share = static_cast<double>(i) / kFilmSteps;
    figure.categories.push_back(Text::tr("%1 s", formatFixed(share * result.options.ramp_s, 2)));
  }
  for (const ModelResult& model : result.models) {
    FigureSeries row;
    row.name = shortName(model.id);
    for (const ModelPose& pose : model.film) {
      row.reliefs.push_back(painter.posed(pose, turnOf(pose.angle_rad)));
    }
    figure.series.push_back(std::move(row));
  }
  figure.notes = {
      Text::tr("While the torque grows, at the moments above, with the angle of the turned end below. "
               "Elements and springs have mass and follow late.")};
  return figure;
}

}  // namespace

std::vector<ReportFigure> comparedPictures(const ComparisonResult& result) {
  Painter painter(result);
  std::vector<ReportFigure> figures;
  if (!result.markers.empty()) {
    figures.push_back(markerPicture(result, painter));
  }
  figures.push_back(endPicture(result, painter));
  figures.push_back(filmStrip(result, painter));
  return figures;
}

}  // namespace torsio
