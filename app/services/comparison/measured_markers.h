// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "app/services/comparison/organ_markers.h"
#include "sim/core/vec3.h"

namespace torsio {

/// Where a marker on a real limb was at a time.
struct MarkerSample {
  double time_s = 0.0;
  Vec3 place_m;
};

/// What was measured on one person: marker number -> its samples in order of time.
struct MeasuredSubject {
  std::string name;
  std::map<int, std::vector<MarkerSample>> markers;
};

/// Reads markers measured on real limbs: a camera marker file (see readCameraMarkers), or a table with the
/// columns marker (number from 1), time (s), x, y, z, unit (mm, cm or m), subject. The first sample of a
/// marker is its place at rest. `markers`: the organ's. Throws Error: kFileMissing, kFileUnreadable; kBadData
/// naming file and line for a marker that the organ does not have, another unit, an empty subject, times that
/// are negative or do not rise, and a marker with fewer than 2 samples.
[[nodiscard]] std::vector<MeasuredSubject> readMeasuredMarkers(const std::filesystem::path& file,
                                                               const std::vector<OrganMarker>& markers);

/// Mean of the subjects, m, and how many they are.
struct MeasuredDisplacement {
  double mean_m = 0.0;
  int subjects = 0;
};

/// Averages how far a marker has gone from its place at rest (Eq. 24) at its last sample.
[[nodiscard]] MeasuredDisplacement finalDisplacement(const std::vector<MeasuredSubject>& subjects,
                                                     int marker);

/// Tells whether a file is a camera marker file: it begins with "PathFileType". Throws Error: kFileMissing,
/// kFileUnreadable.
[[nodiscard]] bool isCameraMarkerFile(const std::filesystem::path& file);

/// Reads one subject from a camera marker file of motion capture (TRC, track row column, as Motion Analysis
/// and OpenSim have it): tab-separated; PathFileType; the names and values of DataRate, NumFrames,
/// NumMarkers, Units (mm, cm or m); the names of the markers; X1 Y1 Z1 ...; then frame, time (s) and places,
/// empty where the cameras lost a marker. A marker is named by its number ("8", "M8", "Marker8") or exactly
/// as the organ's. The subject is named after the file. Throws Error: kFileMissing, kFileUnreadable; kBadData
/// naming file, line and field.
[[nodiscard]] MeasuredSubject readCameraMarkers(const std::filesystem::path& file,
                                                const std::vector<OrganMarker>& markers);

}  // namespace torsio
