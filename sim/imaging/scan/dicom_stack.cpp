// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/imaging/scan/dicom_stack.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "sim/core/error.h"
#include "sim/core/portable_math.h"
#include "sim/core/short_number.h"

namespace torsio {

namespace {

constexpr double kSamePlace_mm = 0.01;
constexpr double kEvenShare = 0.01;  // of the distance
constexpr double kEven_mm = 0.01;
constexpr double kLeastShift_mm = 0.02;  // a slice, across: less is no tilt
constexpr double kMaxStray_mm = 0.1;     // off a straight line through the slices
constexpr double kMaxTilt_deg = 35.0;
constexpr std::size_t kMinSlices = 10;
constexpr double kCoarse_mm = 6.0;
constexpr double kLong = 8.0;  // longest over shortest side of a voxel
constexpr double kDegrees = 180.0 / kPi;

[[noreturn]] void refuseStack(const Text& what, const std::string& where, const Text& remedy) {
  throw Error(ErrorCode::kFileUnreadable, what, where, remedy);
}

/// Takes slices at the place of another one out of the stack.
void partTwins(DicomStack& stack, std::vector<double>& along_mm) {
  std::vector<DicomSlice> kept;
  std::vector<double> places_mm;
  for (std::size_t i = 0; i < stack.slices.size(); ++i) {
    if (!kept.empty() && along_mm[i] - places_mm.back() < kSamePlace_mm) {
      stack.twins.push_back(std::move(stack.slices[i]));
      stack.twinOf.push_back(kept.size() - 1);
      continue;
    }
    kept.push_back(std::move(stack.slices[i]));
    places_mm.push_back(along_mm[i]);
  }
  stack.slices = std::move(kept);
  along_mm = std::move(places_mm);
}

/// Checks that the slices lie evenly, or makes room for layers in between; returns the distance of layers.
double spaced(const std::vector<double>& along_mm, bool resample, const std::string& where, DicomStack& stack,
              std::vector<ScanRemark>& remarks) {
  std::vector<double> gaps_mm;
  for (std::size_t i = 1; i < along_mm.size(); ++i) {
    gaps_mm.push_back(along_mm[i] - along_mm[i - 1]);
  }
  std::vector<double> sorted_mm = gaps_mm;
  std::sort(sorted_mm.begin(), sorted_mm.end());
  const double usual_mm = sorted_mm[sorted_mm.size() / 2];
  const auto off = [usual_mm](double gap_mm) { return std::abs(gap_mm - usual_mm); };
  const auto worst = std::max_element(gaps_mm.begin(), gaps_mm.end(),
                                      [&off](double a, double b) { return off(a) < off(b); });
  const bool even = off(*worst) <= std::max(kEvenShare * usual_mm, kEven_mm);
  const auto after = static_cast<std::size_t>(worst - gaps_mm.begin());
  if (!even) {
    const Text what =
        Text::tr("D09 the slices lie unevenly: %1 mm between %2 and %3, elsewhere %4 mm", shortNumber(*worst),
                 stack.slices[after].name, stack.slices[after + 1].name, shortNumber(usual_mm));
    if (!resample) {
      refuseStack(what, where,
                  Text::tr("Look for slices that are missing, or take them as they are with --resample"));
    }
    remarks.push_back({"D09", true,
                       Text::tr("the slices lie unevenly, up to %1 mm apart: what lies in between is guessed",
                                shortNumber(*worst)),
                       *worst, Text::tr("Give a scan with slices at even distances")});
  }
  const double whole_mm = along_mm.back() - along_mm.front();
  const double step_mm = even ? whole_mm / static_cast<double>(gaps_mm.size()) : sorted_mm.front();
  stack.layers = even ? along_mm.size() : static_cast<std::size_t>(std::floor(whole_mm / step_mm + 1e-6)) + 1;
  for (std::size_t i = 0; i < along_mm.size(); ++i) {
    stack.at.push_back(even ? static_cast<double>(i) : (along_mm[i] - along_mm.front()) / step_mm);
  }
  return step_mm;
}

/// How the slices shift across per millimetre along: the tilt of the gantry.
Vec3 shiftOf(const DicomStack& stack, const Vec3& normal, const std::string& where,
             std::vector<ScanRemark>& remarks) {
  const Vec3 first = *stack.slices.front().position_mm;
  const Vec3 way = *stack.slices.back().position_mm - first;
  const double along_mm = dot(way, normal);
  const Vec3 shift = (way - along_mm * normal) / along_mm;
  for (const DicomSlice& slice : stack.slices) {
    const Vec3 from = *slice.position_mm - first;
    const double here_mm = dot(from, normal);
    const double stray_mm = norm(from - here_mm * (normal + shift));
    if (stray_mm > kMaxStray_mm) {
      refuseStack(
          Text::tr("D07 slice %1 is shifted by %2 mm against the others", slice.name, shortNumber(stray_mm)),
          where, Text::tr("Give one series of one scan"));
    }
  }
  const double aSlice_mm = along_mm / static_cast<double>(stack.slices.size() - 1);
  if (norm(shift) * aSlice_mm <= kLeastShift_mm) {
    return {};
  }
  const double tilt_deg = kDegrees * std::atan(norm(shift));
  if (tilt_deg > kMaxTilt_deg) {
    refuseStack(Text::tr("D10 the gantry was tilted by %1 degrees, at most %2 are corrected",
                         shortNumber(tilt_deg), shortNumber(kMaxTilt_deg)),
                where, Text::tr("Give a scan with an upright gantry"));
  }
  remarks.push_back(
      {"D10", false,
       Text::tr("the gantry was tilted by %1 degrees; the voxels lean so much", shortNumber(tilt_deg)),
       tilt_deg, ""});
  return shift;
}

void remarkOnVoxels(const DicomStack& stack, std::vector<ScanRemark>& remarks) {
  std::array<double, 3> sides_mm{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    sides_mm[axis] = norm(stack.step_mm[axis]);
  }
  const double longest_mm = *std::max_element(sides_mm.begin(), sides_mm.end());
  const double shortest_mm = *std::min_element(sides_mm.begin(), sides_mm.end());
  if (sides_mm[2] > kCoarse_mm || longest_mm > kLong * shortest_mm) {
    remarks.push_back({"D11", true,
                       Text::tr("the scan is coarse: voxels of %1 x %2 x %3 mm", shortNumber(sides_mm[0]),
                                shortNumber(sides_mm[1]), shortNumber(sides_mm[2])),
                       longest_mm, Text::tr("Give a series with thinner slices")});
  }
}

}  // namespace

DicomStack stacked(std::vector<DicomSlice> slices, bool resample, const std::string& where,
                   std::vector<ScanRemark>& remarks) {
  DicomStack stack;
  const auto [alongRow, alongColumn] = *slices.front().directions;
  const Vec3 normal = normalized(cross(alongRow, alongColumn));
  std::stable_sort(slices.begin(), slices.end(), [&normal](const DicomSlice& a, const DicomSlice& b) {
    return dot(*a.position_mm, normal) < dot(*b.position_mm, normal);
  });
  std::vector<double> along_mm;
  for (const DicomSlice& slice : slices) {
    along_mm.push_back(dot(*slice.position_mm, normal));
  }
  stack.slices = std::move(slices);
  partTwins(stack, along_mm);
  if (stack.slices.size() < kMinSlices) {
    refuseStack(Text::tr("D11 the series has %1 {slice|slices} at different places, at least %2 are needed",
                         std::to_string(stack.slices.size()), std::to_string(kMinSlices)),
                where, Text::tr("Give a whole series"));
  }
  const double layer_mm = spaced(along_mm, resample, where, stack, remarks);
  const Vec3 shift = shiftOf(stack, normal, where, remarks);
  const DicomSlice& first = stack.slices.front();
  stack.origin_mm = *first.position_mm;
  stack.step_mm = {(*first.spacing_mm)[1] * normalized(alongRow),
                   (*first.spacing_mm)[0] * normalized(alongColumn), layer_mm * (normal + shift)};
  remarkOnVoxels(stack, remarks);
  return stack;
}

}  // namespace torsio
