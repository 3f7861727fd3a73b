// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "app/services/comparison/organ_markers.h"
#include "sim/core/vec3.h"

namespace torsio {

/// Position of a marker on a real limb at a time.
struct MarkerSample {
  double time_s = 0.0;
  Vec3 place_m;
};

/// Measurements of one person: marker number -> samples in order of time.
struct MeasuredSubject {
  std::string name;
  double unit_m = 1.0;  ///< in which the file states the positions
  std::map<int, std::vector<MarkerSample>> markers{};
};

/// Reads markers measured on real limbs: a camera marker file (see readCameraMarkers), or a table with the
/// columns marker (number from 1), time (s), x, y, z, unit (mm, cm or m), subject. A marker's first sample is
/// its position at rest. `markers`: the organ's. Throws Error: kFileMissing, kFileUnreadable; kBadData with
/// file and line for an unknown marker or unit, an empty subject, times that are negative or do not increase,
/// and a marker with fewer than 2 samples; unless
/// `unitConfirmed`, for markers that move as no skin does (Stated::kMarkerWay) where another unit would fit.
[[nodiscard]] std::vector<MeasuredSubject> readMeasuredMarkers(const std::filesystem::path& file,
                                                               const std::vector<OrganMarker>& markers,
                                                               bool unitConfirmed = false);

/// Mean over the subjects, m, and their number.
struct MeasuredDisplacement {
  double mean_m = 0.0;
  int subjects = 0;
};

/// Averages a marker's displacement from rest (Eq. 24) at its last sample.
[[nodiscard]] MeasuredDisplacement finalDisplacement(const std::vector<MeasuredSubject>& subjects,
                                                     int marker);

/// Returns whether a file is a camera marker file: it begins with "PathFileType". Throws Error: kFileMissing,
/// kFileUnreadable.
[[nodiscard]] bool isCameraMarkerFile(const std::filesystem::path& file);

/// Reads one subject from a motion capture marker file (TRC, track row column, of Motion Analysis and
/// OpenSim): tab-separated; PathFileType; names and values of DataRate, NumFrames, NumMarkers, Units (mm, cm
/// or m); marker names; X1 Y1 Z1 ...; then frame, time (s) and positions, empty if the cameras lost a marker.
/// A marker is identified by its number ("8", "M8", "Marker8") or the organ's exact name. The subject is
/// named after the file. Throws Error: kFileMissing, kFileUnreadable; kBadData with file, line and field.
[[nodiscard]] MeasuredSubject readCameraMarkers(const std::filesystem::path& file,
                                                const std::vector<OrganMarker>& markers);

}  // namespace torsio
