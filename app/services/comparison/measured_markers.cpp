// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/comparison/measured_markers.h"

#include <algorithm>

#include "app/services/base/csv_table.h"
#include "app/services/comparison/camera_markers.h"
#include "sim/core/error.h"

namespace torsio {

namespace {

double unitInMetres(const CsvTable& table, std::size_t row) {
  const std::string& unit = table.text(row, "unit");
  if (unit == "mm") {
    return 1e-3;
  }
  if (unit == "cm") {
    return 1e-2;
  }
  if (unit != "m") {
    table.refuse(row, Text::tr("'%1' is no unit of length here", unit), Text::tr("Use mm, cm or m"));
  }
  return 1.0;
}

void takeSample(const CsvTable& table, std::size_t row, int markers, MeasuredSubject& subject) {
  const auto number = static_cast<int>(table.whole(row, "marker", 1, markers));
  MarkerSample sample;
  sample.time_s = table.number(row, "time");
  sample.place_m =
      unitInMetres(table, row) * Vec3{table.number(row, "x"), table.number(row, "y"), table.number(row, "z")};
  std::vector<MarkerSample>& samples = subject.markers[number];
  if (sample.time_s < 0.0 || (!samples.empty() && sample.time_s <= samples.back().time_s)) {
    table.refuse(row, Text::tr("Times are seconds from 0 that rise from sample to sample of a marker"),
                 Text::tr("Sort the rows by time and drop repeated ones"));
  }
  samples.push_back(sample);
}

/// The subjects of a table of comma-separated values.
std::vector<MeasuredSubject> subjectsOfTable(const std::filesystem::path& file, int markers) {
  const CsvTable table = CsvTable::read(file, {"marker", "time", "x", "y", "z", "unit", "subject"});
  std::vector<MeasuredSubject> subjects;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const std::string& name = table.text(row, "subject");
    auto subject = std::find_if(subjects.begin(), subjects.end(),
                                [&](const MeasuredSubject& s) { return s.name == name; });
    if (subject == subjects.end()) {
      subjects.push_back({name, {}});
      subject = std::prev(subjects.end());
    }
    takeSample(table, row, markers, *subject);
  }
  return subjects;
}

/// A place at rest and a later one of each marker.
void requireTwoSamples(const std::vector<MeasuredSubject>& subjects, const std::string& file) {
  bool any = false;
  for (const MeasuredSubject& subject : subjects) {
    for (const auto& [number, samples] : subject.markers) {
      any = true;
      if (samples.size() < 2) {
        refuse(Text::tr("Marker %1 of subject '%2' has one sample only", number, subject.name), file,
               Text::tr("Give its place at rest and at least one later"));
      }
    }
  }
  if (!any) {
    refuse(Text::tr("The file holds no measurements"), file, Text::tr("Give at least two samples a marker"));
  }
}

}  // namespace

std::vector<MeasuredSubject> readMeasuredMarkers(const std::filesystem::path& file,
                                                 const std::vector<OrganMarker>& markers) {
  if (markers.empty()) {
    refuse(Text::tr("This organ has no markers to compare measurements with"), file.string(),
           Text::tr("Choose an organ with markers, such as arm"));
  }
  std::vector<MeasuredSubject> subjects = isCameraMarkerFile(file)
                                              ? std::vector<MeasuredSubject>{readCameraMarkers(file, markers)}
                                              : subjectsOfTable(file, static_cast<int>(markers.size()));
  requireTwoSamples(subjects, file.string());
  return subjects;
}

MeasuredDisplacement finalDisplacement(const std::vector<MeasuredSubject>& subjects, int marker) {
  MeasuredDisplacement result;
  for (const MeasuredSubject& subject : subjects) {
    const auto found = subject.markers.find(marker);
    if (found != subject.markers.end()) {
      result.mean_m += norm(found->second.back().place_m - found->second.front().place_m);
      ++result.subjects;
    }
  }
  if (result.subjects > 0) {
    result.mean_m /= result.subjects;
  }
  return result;
}

}  // namespace torsio
