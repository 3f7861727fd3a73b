// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/imaging/apart/scan_mail.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <cstring>

#include "sim/core/error.h"
#include "sim/core/text_packing.h"
#include "sim/geometry/apart/helper_process.h"
#include "sim/geometry/apart/mesh_mail.h"

namespace torsio {

namespace {

constexpr std::uint32_t kScanMail = 0x5343414e;     // "SCAN"
constexpr std::uint32_t kToolMail = 0x544f4f4c;     // "TOOL"
constexpr std::uint32_t kPreviewMail = 0x534c4943;  // "SLIC"
constexpr std::size_t kMaxRemarks = 64;
constexpr std::size_t kRequestWords = 9;
constexpr std::size_t kDabsInWord = 1000;
constexpr std::size_t kDabNumbers = 5;

struct ScanMailHead {
  std::uint32_t kind = kScanMail;
  std::uint32_t facts = 0;  ///< bytes of them; the mesh follows
};

/// Numbers in one word, or "-" for none.
std::string wordOf(const std::vector<double>& numbers) {
  std::string word;
  for (const double number : numbers) {
    if (!word.empty()) {
      word += ',';
    }
    word += hexadecimal(number);
  }
  return word.empty() ? "-" : word;
}

/// As many numbers as are wanted; none for "-" or anything else.
std::vector<double> numbersOf(const char* word, std::size_t wanted) {
  std::vector<double> numbers;
  while (numbers.size() < wanted) {
    char* end = nullptr;
    const double number = std::strtod(word, &end);
    if (end == word) {
      return {};
    }
    numbers.push_back(number);
    word = *end == ',' ? end + 1 : end;
  }
  return numbers;
}

std::string wordOf(const std::optional<Vec3>& v) {
  return v ? wordOf(std::vector<double>{v->x, v->y, v->z}) : "-";
}

std::optional<Vec3> vectorOf(const char* word) {
  const std::vector<double> numbers = numbersOf(word, 3);
  return numbers.empty() ? std::nullopt : std::optional(Vec3{numbers[0], numbers[1], numbers[2]});
}

/// Reads the dabs in a word; false if it is malformed.
bool addDabs(const char* word, std::vector<BrushDab>& dabs) {
  const auto numbers = static_cast<std::size_t>(std::count(word, word + std::strlen(word), ',')) + 1;
  const std::vector<double> read = numbersOf(word, numbers);
  if (read.empty() || numbers % kDabNumbers != 0 || numbers > kDabNumbers * kDabsInWord) {
    return false;
  }
  for (std::size_t n = 0; n < numbers; n += kDabNumbers) {
    dabs.push_back({{read[n], read[n + 1], read[n + 2]}, read[n + 3], read[n + 4] != 0.0});
  }
  return true;
}

/// The facts of an answer and what follows them.
struct OpenedMail {
  std::string facts;
  std::span<const char> rest;
};

void packRemarks(const std::vector<ScanRemark>& remarks, TextPacker& facts) {
  const std::size_t told = std::min(remarks.size(), kMaxRemarks);
  facts.number(static_cast<double>(told));
  for (std::size_t i = 0; i < told; ++i) {
    facts.text(remarks[i].code);
    facts.number(remarks[i].warning ? 1.0 : 0.0);
    facts.text(remarks[i].what);
    facts.text(remarks[i].remedy);
    facts.number(remarks[i].value ? 1.0 : 0.0);
    facts.number(remarks[i].value.value_or(0.0));
  }
}

void unpackRemarks(TextUnpacker& facts, std::vector<ScanRemark>& remarks) {
  remarks.resize(facts.count(kMaxRemarks));
  for (ScanRemark& remark : remarks) {
    facts.text(remark.code);
    remark.warning = facts.number() != 0.0;
    facts.text(remark.what);
    facts.text(remark.remedy);
    const bool measured = facts.number() != 0.0;
    const double value = facts.number();
    remark.value = measured ? std::optional(value) : std::nullopt;
  }
}

[[noreturn]] void refuseAnswer(const std::string& where) {
  throw Error(ErrorCode::kFileUnreadable, Text::tr("D04 the reader gave no answer to this scan"), where,
              Text::tr("Copy or export the scan again"));
}

/// Takes an answer of this kind apart; throws the refusal that was written in place of it.
OpenedMail openedMail(std::span<const char> bytes, std::uint32_t kind, const std::string& where) {
  ScanMailHead head;
  if (bytes.size() < sizeof(head)) {
    refuseAnswer(where);
  }
  std::memcpy(&head, bytes.data(), sizeof(head));
  if (head.kind != kind) {
    static_cast<void>(meshOfMail(bytes, where));  // a refusal, which it throws
  }
  const std::span<const char> rest = bytes.subspan(sizeof(head));
  if (head.kind != kind || rest.size() < head.facts) {
    refuseAnswer(where);
  }
  return {std::string(rest.begin(), rest.begin() + head.facts), rest.subspan(head.facts)};
}

std::string mailHead(std::uint32_t kind, const TextPacker& facts) {
  const ScanMailHead head{kind, static_cast<std::uint32_t>(facts.bytes().size())};
  return std::string(reinterpret_cast<const char*>(&head), sizeof(head)) + facts.bytes();
}

void packVector(const Vec3& v, TextPacker& facts) {
  for (const double number : {v.x, v.y, v.z}) {
    facts.number(number);
  }
}

Vec3 unpackVector(TextUnpacker& facts) {
  const double x = facts.number();
  const double y = facts.number();
  return {x, y, facts.number()};
}

}  // namespace

std::vector<std::string> wordsOf(const ScanRequest& request) {
  std::vector<double> box;
  if (request.box_mm) {
    for (const Vec3& corner : *request.box_mm) {
      box.insert(box.end(), {corner.x, corner.y, corner.z});
    }
  }
  std::vector<std::string> words{request.source.string(),
                                 std::to_string(static_cast<int>(request.tissue)),
                                 std::to_string(request.label),
                                 std::to_string(request.series),
                                 request.resample ? "1" : "0",
                                 wordOf(request.seed_mm),
                                 wordOf(box),
                                 request.wall_mm ? hexadecimal(*request.wall_mm) : "-",
                                 request.fluid ? "1" : "0"};
  for (std::size_t first = 0; first < request.brush.size(); first += kDabsInWord) {
    std::vector<double> dabs;
    for (std::size_t n = first; n < std::min(first + kDabsInWord, request.brush.size()); ++n) {
      const BrushDab& dab = request.brush[n];
      dabs.insert(dabs.end(),
                  {dab.centre_mm.x, dab.centre_mm.y, dab.centre_mm.z, dab.radius_mm, dab.adds ? 1.0 : 0.0});
    }
    words.push_back(wordOf(dabs));
  }
  return words;
}

std::optional<ScanRequest> requestOfWords(std::span<const char* const> words) {
  if (words.size() < kRequestWords || words.size() > kRequestWords + kMaxDabs / kDabsInWord) {
    return std::nullopt;
  }
  ScanRequest request;
  request.source = words[0];
  const long tissue = std::strtol(words[1], nullptr, 10);
  if (tissue < 0 || tissue > static_cast<long>(ScanTissue::kLabel)) {
    return std::nullopt;
  }
  request.tissue = static_cast<ScanTissue>(tissue);
  request.label = static_cast<int>(std::strtol(words[2], nullptr, 10));
  request.series = static_cast<int>(std::strtol(words[3], nullptr, 10));
  request.resample = std::string(words[4]) == "1";
  request.seed_mm = vectorOf(words[5]);
  if (const auto box = numbersOf(words[6], 6); !box.empty()) {
    request.box_mm = ScanBox{Vec3{box[0], box[1], box[2]}, Vec3{box[3], box[4], box[5]}};
  }
  if (const auto wall = numbersOf(words[7], 1); !wall.empty()) {
    request.wall_mm = wall[0];
  }
  request.fluid = std::string(words[8]) == "1";
  for (const char* const word : words.subspan(kRequestWords)) {
    if (!addDabs(word, request.brush)) {
      return std::nullopt;
    }
  }
  return request;
}

std::vector<std::string> wordsOf(const ToolRequest& request) {
  return {request.source.string(),       hexadecimal(request.threshold_HU),
          wordOf(request.seed_mm),       wordOf(request.tip_mm),
          wordOf(request.shaft),         wordOf(request.jawAxis),
          hexadecimal(request.pivot_mm), std::to_string(request.series),
          request.resample ? "1" : "0"};
}

std::optional<ToolRequest> toolRequestOfWords(std::span<const char* const> words) {
  constexpr std::size_t kToolWords = 9;
  if (words.size() != kToolWords) {
    return std::nullopt;
  }
  ToolRequest request;
  request.source = words[0];
  request.threshold_HU = std::strtod(words[1], nullptr);
  request.seed_mm = vectorOf(words[2]);
  request.tip_mm = vectorOf(words[3]);
  request.shaft = vectorOf(words[4]);
  request.jawAxis = vectorOf(words[5]);
  request.pivot_mm = std::strtod(words[6], nullptr);
  request.series = static_cast<int>(std::strtol(words[7], nullptr, 10));
  request.resample = std::string(words[8]) == "1";
  return request;
}

std::string mailOf(const ScanSurface& surface) {
  TextPacker facts;
  facts.text(surface.kind);
  for (const std::size_t side : surface.count) {
    facts.number(static_cast<double>(side));
  }
  for (const double number : {surface.voxel_mm.x, surface.voxel_mm.y, surface.voxel_mm.z, surface.step_mm,
                              surface.level_HU ? 1.0 : 0.0, surface.level_HU.value_or(0.0),
                              static_cast<double>(surface.rawTriangles), surface.ownWall_mm.value_or(0.0),
                              surface.wall ? 1.0 : 0.0}) {
    facts.number(number);
  }
  const WallThickness wall = surface.wall.value_or(WallThickness{});
  for (const double number : {wall.median_mm, wall.tenth_mm, wall.ninety_mm, wall.seen}) {
    facts.number(number);
  }
  packRemarks(surface.remarks, facts);
  facts.number(static_cast<double>(surface.wallRays.size()));
  for (const WallRay& ray : surface.wallRays) {
    packVector(ray.place_mm, facts);
    facts.number(ray.thickness_mm);
  }
  return mailHead(kScanMail, facts) + mailOf(RawMesh{surface.mesh, {}});
}

std::string mailOf(const ScanPreview& preview) {
  const ScanVolume& volume = preview.volume;
  TextPacker facts;
  facts.text(preview.kind);
  packVector(volume.origin_mm, facts);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    facts.number(static_cast<double>(volume.count[axis]));
    packVector(volume.step_mm[axis], facts);
  }
  facts.number(preview.volume_ml.value_or(-1.0));
  packRemarks(preview.remarks, facts);
  std::string mail = mailHead(kPreviewMail, facts);
  mail.append(reinterpret_cast<const char*>(volume.values.data()),
              volume.values.size() * sizeof(std::int16_t));
  mail.append(reinterpret_cast<const char*>(preview.within.data()), preview.within.size());
  return mail;
}

ScanSurface scanOfMail(std::span<const char> bytes, const std::string& where) {
  const OpenedMail mail = openedMail(bytes, kScanMail, where);
  ScanSurface surface;
  TextUnpacker facts(mail.facts);
  facts.text(surface.kind);
  constexpr std::size_t kMaxSide = 100'000;
  for (std::size_t& side : surface.count) {
    side = facts.count(kMaxSide);
  }
  surface.voxel_mm.x = facts.number();
  surface.voxel_mm.y = facts.number();
  surface.voxel_mm.z = facts.number();
  surface.step_mm = facts.number();
  const bool levelled = facts.number() != 0.0;
  const double level_HU = facts.number();
  surface.level_HU = levelled ? std::optional(level_HU) : std::nullopt;
  surface.rawTriangles = facts.count(kMaxAnswerBytes);
  const double ownWall_mm = facts.number();
  surface.ownWall_mm = ownWall_mm > 0.0 ? std::optional(ownWall_mm) : std::nullopt;
  const bool walled = facts.number() != 0.0;
  WallThickness wall;
  wall.median_mm = facts.number();
  wall.tenth_mm = facts.number();
  wall.ninety_mm = facts.number();
  wall.seen = facts.number();
  surface.wall = walled ? std::optional(wall) : std::nullopt;
  unpackRemarks(facts, surface.remarks);
  surface.wallRays.resize(facts.count(mail.facts.size() / sizeof(WallRay)));
  for (WallRay& ray : surface.wallRays) {
    ray.place_mm = unpackVector(facts);
    ray.thickness_mm = facts.number();
  }
  surface.mesh = meshOfMail(mail.rest, where).mesh;
  return surface;
}

ScanPreview previewOfMail(std::span<const char> bytes, const std::string& where) {
  const OpenedMail mail = openedMail(bytes, kPreviewMail, where);
  TextUnpacker facts(mail.facts);
  ScanPreview preview;
  facts.text(preview.kind);
  ScanVolume& volume = preview.volume;
  volume.origin_mm = unpackVector(facts);
  double voxels = 1.0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    volume.count[axis] = facts.count(static_cast<std::size_t>(kPreviewVoxels));
    volume.step_mm[axis] = unpackVector(facts);
    voxels *= static_cast<double>(volume.count[axis]);
  }
  const double volume_ml = facts.number();
  unpackRemarks(facts, preview.remarks);
  const bool sized = voxels > 0.0 && voxels <= kPreviewVoxels;
  const std::size_t all = sized ? static_cast<std::size_t>(voxels) : 0;
  const std::size_t plain = all * sizeof(std::int16_t);
  const bool found = mail.rest.size() == plain + all;
  if (!sized || (mail.rest.size() != plain && !found)) {
    refuseAnswer(where);
  }
  volume.values.resize(all);
  std::memcpy(volume.values.data(), mail.rest.data(), plain);
  if (found) {
    preview.within.assign(mail.rest.begin() + static_cast<std::ptrdiff_t>(plain), mail.rest.end());
    preview.volume_ml = volume_ml;
  }
  return preview;
}

std::string mailOf(const ToolSurface& tool) {
  std::string meshes;
  TextPacker facts;
  for (const TriangleMesh* const part : {&tool.shaft, &tool.upperJaw, &tool.lowerJaw}) {
    const std::string mesh = mailOf(RawMesh{*part, {}});
    facts.number(static_cast<double>(mesh.size()));
    meshes += mesh;
  }
  for (const double number : {tool.length_mm, tool.pivot_mm, tool.shaftRadius_mm, tool.tipRadius_mm}) {
    facts.number(number);
  }
  packVector(tool.tip_mm, facts);
  for (const Vec3& axis : tool.axes) {
    packVector(axis, facts);
  }
  packRemarks(tool.remarks, facts);
  return mailHead(kToolMail, facts) + meshes;
}

ToolSurface toolOfMail(std::span<const char> bytes, const std::string& where) {
  const OpenedMail mail = openedMail(bytes, kToolMail, where);
  TextUnpacker facts(mail.facts);
  ToolSurface tool;
  std::array<std::size_t, 3> sizes{};
  for (std::size_t& size : sizes) {
    size = facts.count(mail.rest.size());
  }
  tool.length_mm = facts.number();
  tool.pivot_mm = facts.number();
  tool.shaftRadius_mm = facts.number();
  tool.tipRadius_mm = facts.number();
  tool.tip_mm = unpackVector(facts);
  for (Vec3& axis : tool.axes) {
    axis = unpackVector(facts);
  }
  unpackRemarks(facts, tool.remarks);
  std::span<const char> rest = mail.rest;
  const std::array<TriangleMesh*, 3> parts{&tool.shaft, &tool.upperJaw, &tool.lowerJaw};
  for (std::size_t n = 0; n < parts.size(); ++n) {
    if (sizes[n] > rest.size()) {
      refuseAnswer(where);
    }
    *parts[n] = meshOfMail(rest.first(sizes[n]), where).mesh;
    rest = rest.subspan(sizes[n]);
  }
  return tool;
}

}  // namespace torsio
