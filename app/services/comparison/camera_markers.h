// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/services/comparison/measured_markers.h"

namespace torsio {

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
