// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/comparison/measured_markers.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string_view>
#include <system_error>

#include "app/services/base/csv_table.h"
#include "sim/core/error.h"
#include "sim/core/file_io.h"
#include "sim/core/plausible.h"
#include "sim/core/short_number.h"

namespace torsio {

namespace {

double unitInMetres(const CsvTable& table, std::size_t row) {
  const std::string& word = table.text(row, "unit");
  const std::optional<StatedUnit> unit = statedUnit(Stated::kMarkerWay, word);
  if (!unit) {
    table.refuse(row, Text::tr("'%1' is not a unit of length here", word),
                 Text::tr("Use one of these: %1", unitWords(Stated::kMarkerWay)));
  }
  return unit->si;
}

void takeSample(const CsvTable& table, std::size_t row, int markers, MeasuredSubject& subject) {
  const auto number = static_cast<int>(table.whole(row, "marker", 1, markers));
  MarkerSample sample;
  sample.time_s = table.number(row, "time");
  subject.unit_m = unitInMetres(table, row);
  sample.place_m =
      subject.unit_m * Vec3{table.number(row, "x"), table.number(row, "y"), table.number(row, "z")};
  std::vector<MarkerSample>& samples = subject.markers[number];
  if (sample.time_s < 0.0 || (!samples.empty() && sample.time_s <= samples.back().time_s)) {
    table.refuse(row, Text::tr("Times are seconds from 0 that rise from sample to sample of a marker"),
                 Text::tr("Sort the rows by time and drop repeated ones"));
  }
  samples.push_back(sample);
}

/// Returns the subjects of a CSV table.
std::vector<MeasuredSubject> subjectsOfTable(const std::filesystem::path& file, int markers) {
  const CsvTable table = CsvTable::read(file, {"marker", "time", "x", "y", "z", "unit", "subject"});
  std::vector<MeasuredSubject> subjects;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const std::string& name = table.text(row, "subject");
    auto subject = std::find_if(subjects.begin(), subjects.end(),
                                [&](const MeasuredSubject& s) { return s.name == name; });
    if (subject == subjects.end()) {
      subjects.push_back({.name = name});
      subject = std::prev(subjects.end());
    }
    takeSample(table, row, markers, *subject);
  }
  return subjects;
}

/// Refuses markers that move as no skin does if another unit of length would make it plausible. Each row of a
/// table states its own unit; the file's only one is told.
void requirePlausibleWay(const std::vector<MeasuredSubject>& subjects, const std::string& file) {
  for (const MeasuredSubject& subject : subjects) {
    double farthest_m = 0.0;
    for (const auto& [number, samples] : subject.markers) {
      for (const MarkerSample& sample : samples) {
        farthest_m = std::max(farthest_m, norm(sample.place_m - samples.front().place_m));
      }
    }
    const StatedValue way{Stated::kMarkerWay, farthest_m};
    if (farthest_m == 0.0 || isPlausible(way.quantity, way.value)) {
      continue;
    }
    const Text fitting = unitsThatFit({&way, 1}, subject.unit_m);
    if (!fitting.empty()) {
      refuse(Text::tr("the markers of '%1' would have moved %2 at most: %3 is plausible", subject.name,
                      inPlausibleUnit(way.quantity, way.value), plausibleRange(way.quantity)),
             file,
             Text::tr(
                 "Write the right unit into the file (%1 would fit), or give --unit-confirmed if it is right",
                 fitting));
    }
  }
}

/// Throws unless each marker has a position at rest and a later one.
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
    refuse(Text::tr("The file contains no measurements"), file,
           Text::tr("Give at least two samples a marker"));
  }
}

}  // namespace

std::vector<MeasuredSubject> readMeasuredMarkers(const std::filesystem::path& file,
                                                 const std::vector<OrganMarker>& markers,
                                                 bool unitConfirmed) {
  if (markers.empty()) {
    refuse(Text::tr("This organ has no markers to compare measurements with"), file.string(),
           Text::tr("Choose an organ with markers, such as arm"));
  }
  std::vector<MeasuredSubject> subjects = isCameraMarkerFile(file)
                                              ? std::vector<MeasuredSubject>{readCameraMarkers(file, markers)}
                                              : subjectsOfTable(file, static_cast<int>(markers.size()));
  requireTwoSamples(subjects, file.string());
  if (!unitConfirmed) {
    requirePlausibleWay(subjects, file.string());
  }
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

namespace {

constexpr std::string_view kFirstWord = "PathFileType";
constexpr std::size_t kFieldsBefore = 2;  ///< frame and time, before the coordinates

std::string trimmed(std::string_view field) {
  const auto first = field.find_first_not_of(" \r\n");
  return first == std::string_view::npos
             ? std::string()
             : std::string(field.substr(first, field.find_last_not_of(" \r\n") - first + 1));
}

/// The lines of a tab-separated table, with positions for error messages.
class TrackTable {
 public:
  explicit TrackTable(const std::filesystem::path& file) : name_(file.string()) {
    const std::string text = readFile(file);
    for (std::size_t at = 0; at < text.size();) {
      const std::size_t end = std::min(text.find('\n', at), text.size());
      std::vector<std::string> fields;
      for (std::size_t from = at; from <= end;) {
        const std::size_t tab = std::min(text.find('\t', from), end);
        fields.push_back(trimmed(std::string_view(text).substr(from, tab - from)));
        from = tab + 1;
      }
      while (!fields.empty() && fields.back().empty()) {
        fields.pop_back();
      }
      lines_.push_back(std::move(fields));
      at = end + 1;
    }
  }

  [[nodiscard]] std::size_t lines() const noexcept { return lines_.size(); }
  [[nodiscard]] const std::string& name() const noexcept { return name_; }
  /// Returns the fields of a line (from 1), without empty ones at its end.
  [[nodiscard]] const std::vector<std::string>& fields(std::size_t line) const {
    static const std::vector<std::string> kNone;
    return line <= lines_.size() ? lines_[line - 1] : kNone;
  }
  /// Returns a field (from 1); "" beyond the end of the line.
  [[nodiscard]] const std::string& field(std::size_t line, std::size_t number) const {
    static const std::string kEmpty;
    return number <= fields(line).size() ? fields(line)[number - 1] : kEmpty;
  }
  [[noreturn]] void refuseField(std::size_t line, const std::string& field, const Text& what,
                                const Text& remedy) const {
    refuse(what, Text::tr("%1, line %2, field \"%3\"", name_, line, field), remedy);
  }
  [[nodiscard]] double number(std::size_t line, std::size_t field, const std::string& named) const {
    const std::string& shown = this->field(line, field);
    double value = 0.0;
    const auto [end, error] = std::from_chars(shown.data(), shown.data() + shown.size(), value);
    if (error != std::errc() || end != shown.data() + shown.size() || !std::isfinite(value)) {
      refuseField(line, named, Text::tr("\"%1\" is not a finite number", shown),
                  Text::tr("Write a decimal number with a point, such as 7.5"));
    }
    return value;
  }

 private:
  std::string name_;
  std::vector<std::vector<std::string>> lines_;
};

/// Contents of the second and third line.
struct TrackHeader {
  double rate_Hz = 0.0;
  std::size_t frames = 0;
  std::size_t markers = 0;
  double unit_m = 1e-3;
};

TrackHeader headerOf(const TrackTable& table) {
  if (table.field(1, 1) != kFirstWord || table.field(1, 2) != "4" || table.field(1, 3) != "(X/Y/Z)") {
    table.refuseField(1, std::string(kFirstWord), Text::tr("The file is not a marker file of type 4 (X/Y/Z)"),
                      Text::tr("Export the places of markers as TRC"));
  }
  const std::vector<std::string>& names = table.fields(2);
  const auto column = [&](const std::string& name) {
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end()) {
      table.refuseField(2, name, Text::tr("The header lacks this field"),
                        Text::tr("Export the places of markers as TRC"));
    }
    return static_cast<std::size_t>(found - names.begin()) + 1;
  };
  const auto count = [&](const std::string& name) {
    const double value = table.number(3, column(name), name);
    if (!(value >= 1.0 && value <= 1e7 && value == std::floor(value))) {
      table.refuseField(3, name, Text::tr("A whole number from 1 on is needed"),
                        Text::tr("Export the file once more"));
    }
    return static_cast<std::size_t>(value);
  };
  TrackHeader header;
  header.rate_Hz = table.number(3, column("DataRate"), "DataRate");
  if (!(header.rate_Hz > 0.0)) {
    table.refuseField(3, "DataRate", Text::tr("The rate must be positive"),
                      Text::tr("Give frames a second, such as 100"));
  }
  header.frames = count("NumFrames");
  header.markers = count("NumMarkers");
  const std::string& unit = table.field(3, column("Units"));
  const std::optional<StatedUnit> stated = statedUnit(Stated::kMarkerWay, unit);
  if (!stated) {
    table.refuseField(3, "Units", Text::tr("'%1' is not a unit of length here", unit),
                      Text::tr("Use one of these: %1", unitWords(Stated::kMarkerWay)));
  }
  header.unit_m = stated->si;
  return header;
}

std::string inLowerCase(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

/// Returns the number of the organ's marker that a track name refers to; 0 if none.
int markerOfTrack(const std::string& track, const std::vector<OrganMarker>& markers) {
  const std::string name = inLowerCase(track);
  for (const OrganMarker& marker : markers) {
    const std::string number = std::to_string(marker.number);
    if (name == number || name == "m" + number || name == "marker" + number ||
        name == inLowerCase(marker.name)) {
      return marker.number;
    }
  }
  return 0;
}

/// Returns the marker of each track, as named in lines 4 and 5.
std::vector<int> tracksOf(const TrackTable& table, const TrackHeader& header,
                          const std::vector<OrganMarker>& markers) {
  if (table.field(4, 1) != "Frame#" || table.field(4, 2) != "Time") {
    table.refuseField(4, "Frame#", Text::tr("The line must begin with Frame# and Time"),
                      Text::tr("Export the places of markers as TRC"));
  }
  std::vector<int> tracks;
  for (std::size_t k = 0; k < header.markers; ++k) {
    const std::string& track = table.field(4, kFieldsBefore + 1 + 3 * k);
    const int marker = markerOfTrack(track, markers);
    if (marker == 0) {
      table.refuseField(4, track, Text::tr("The organ has no marker of this name"),
                        Text::tr("Call it by its number or its name, or leave it out of the export"));
    }
    if (std::find(tracks.begin(), tracks.end(), marker) != tracks.end()) {
      table.refuseField(4, track, Text::tr("Marker %1 is listed twice", marker),
                        Text::tr("Leave one of them out"));
    }
    tracks.push_back(marker);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const std::string wanted = std::string(1, "XYZ"[axis]) + std::to_string(k + 1);
      if (table.field(5, kFieldsBefore + 1 + 3 * k + axis) != wanted) {
        table.refuseField(5, wanted,
                          Text::tr("Each marker has three columns X, Y, Z with its place in the line"),
                          Text::tr("Export the places of markers as TRC"));
      }
    }
  }
  if (table.fields(4).size() > kFieldsBefore + 1 + 3 * (header.markers - 1)) {
    table.refuseField(4, "NumMarkers",
                      Text::tr("The header promises %1 {marker|markers}, the line has more", header.markers),
                      Text::tr("Export the file once more"));
  }
  return tracks;
}

void takeFrame(const TrackTable& table, std::size_t line, const TrackHeader& header,
               const std::vector<int>& tracks, MeasuredSubject& subject) {
  const double time_s = table.number(line, 2, "Time");
  for (std::size_t k = 0; k < tracks.size(); ++k) {
    const std::size_t first = kFieldsBefore + 1 + 3 * k;
    std::size_t given = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      given += table.field(line, first + axis).empty() ? 0 : 1;
    }
    if (given == 0) {
      continue;  // not seen by the cameras
    }
    std::array<double, 3> place{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      place[axis] = table.number(line, first + axis, std::string(1, "XYZ"[axis]) + std::to_string(k + 1));
    }
    subject.markers[tracks[k]].push_back({time_s, header.unit_m * Vec3{place[0], place[1], place[2]}});
  }
}

/// Frames may be missing, so the times may be further apart than the header's rate says; never nearer.
void requireStatedRate(const TrackTable& table, const TrackHeader& header, double duration_s,
                       std::size_t frames) {
  constexpr double kSlack = 0.01;
  const double apart_s = frames > 1 ? duration_s / static_cast<double>(frames - 1) : 0.0;
  if (apart_s > 0.0 && apart_s * header.rate_Hz < 1.0 - kSlack) {
    table.refuseField(3, "DataRate",
                      Text::tr("The header says %1 frames a second, the times say %2",
                               shortNumber(header.rate_Hz), shortNumber(1.0 / apart_s)),
                      Text::tr("Correct the rate, or write the times in seconds"));
  }
}

}  // namespace

bool isCameraMarkerFile(const std::filesystem::path& file) {
  return readFile(file).rfind(kFirstWord, 0) == 0;
}

MeasuredSubject readCameraMarkers(const std::filesystem::path& file,
                                  const std::vector<OrganMarker>& markers) {
  constexpr std::size_t kHeaderLines = 5;
  const TrackTable table(file);
  const TrackHeader header = headerOf(table);
  const std::vector<int> tracks = tracksOf(table, header, markers);
  MeasuredSubject subject{.name = file.stem().string(), .unit_m = header.unit_m};
  std::size_t frames = 0;
  double before_s = -1.0;
  double duration_s = 0.0;
  for (std::size_t line = kHeaderLines + 1; line <= table.lines(); ++line) {
    if (table.fields(line).empty()) {
      continue;
    }
    static_cast<void>(table.number(line, 1, "Frame#"));
    const double time_s = table.number(line, 2, "Time");
    if (time_s < 0.0 || (frames > 0 && time_s <= before_s)) {
      table.refuseField(line, "Time", Text::tr("Times are seconds from 0 that rise from frame to frame"),
                        Text::tr("Export the file once more"));
    }
    if (table.fields(line).size() > kFieldsBefore + 3 * header.markers) {
      table.refuseField(line, "NumMarkers",
                        Text::tr("The line has more columns than %1 {marker|markers}", header.markers),
                        Text::tr("Export the file once more"));
    }
    takeFrame(table, line, header, tracks, subject);
    duration_s += frames > 0 ? time_s - before_s : 0.0;
    before_s = time_s;
    ++frames;
  }
  requireStatedRate(table, header, duration_s, frames);
  if (frames != header.frames) {
    table.refuseField(
        3, "NumFrames",
        Text::tr("The header promises %1 {frame|frames}, the file has %2", header.frames, frames),
        Text::tr("Export the file once more"));
  }
  return subject;
}

}  // namespace torsio
