// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/imaging/apart/scan_mail.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <cstring>

#include "sim/base/error.h"
#include "sim/base/text_packing.h"
#include "sim/geometry/apart/helper_process.h"
#include "sim/geometry/apart/mesh_mail.h"

namespace torsio {

namespace {

constexpr std::uint32_t kScanMail = 0x5343414e;  // "SCAN"
constexpr std::size_t kMostRemarks = 64;
constexpr std::size_t kRequestWords = 8;

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

void packRemarks(const std::vector<ScanRemark>& remarks, TextPacker& facts) {
  const std::size_t told = std::min(remarks.size(), kMostRemarks);
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
  remarks.resize(facts.count(kMostRemarks));
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

}  // namespace

std::vector<std::string> wordsOf(const ScanRequest& request) {
  std::vector<double> seed;
  if (request.seed_mm) {
    seed = {request.seed_mm->x, request.seed_mm->y, request.seed_mm->z};
  }
  std::vector<double> box;
  if (request.box_mm) {
    for (const Vec3& corner : *request.box_mm) {
      box.insert(box.end(), {corner.x, corner.y, corner.z});
    }
  }
  return {request.source.string(),
          std::to_string(static_cast<int>(request.tissue)),
          std::to_string(request.label),
          std::to_string(request.series),
          request.resample ? "1" : "0",
          wordOf(seed),
          wordOf(box),
          request.wall_mm ? hexadecimal(*request.wall_mm) : "-"};
}

std::optional<ScanRequest> requestOfWords(std::span<const char* const> words) {
  if (words.size() != kRequestWords) {
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
  if (const auto seed = numbersOf(words[5], 3); !seed.empty()) {
    request.seed_mm = Vec3{seed[0], seed[1], seed[2]};
  }
  if (const auto box = numbersOf(words[6], 6); !box.empty()) {
    request.box_mm = ScanBox{Vec3{box[0], box[1], box[2]}, Vec3{box[3], box[4], box[5]}};
  }
  if (const auto wall = numbersOf(words[7], 1); !wall.empty()) {
    request.wall_mm = wall[0];
  }
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
  const ScanMailHead head{kScanMail, static_cast<std::uint32_t>(facts.bytes().size())};
  return std::string(reinterpret_cast<const char*>(&head), sizeof(head)) + facts.bytes() +
         mailOf(RawMesh{surface.mesh, {}});
}

ScanSurface scanOfMail(std::span<const char> bytes, const std::string& where) {
  ScanMailHead head;
  if (bytes.size() >= sizeof(head)) {
    std::memcpy(&head, bytes.data(), sizeof(head));
  }
  if (bytes.size() < sizeof(head) || (head.kind == kScanMail && bytes.size() - sizeof(head) < head.facts)) {
    throw Error(ErrorCode::kFileUnreadable, Text::tr("D04 the reader gave no answer to this scan"), where,
                Text::tr("Copy or export the scan again"));
  }
  if (head.kind != kScanMail) {
    static_cast<void>(meshOfMail(bytes, where));  // a refusal, which it throws
    return scanOfMail({}, where);
  }
  ScanSurface surface;
  const std::span<const char> rest = bytes.subspan(sizeof(head));
  const std::string packed(rest.begin(), rest.begin() + head.facts);
  TextUnpacker facts(packed);
  facts.text(surface.kind);
  constexpr std::size_t kMostSide = 100'000;
  for (std::size_t& side : surface.count) {
    side = facts.count(kMostSide);
  }
  surface.voxel_mm.x = facts.number();
  surface.voxel_mm.y = facts.number();
  surface.voxel_mm.z = facts.number();
  surface.step_mm = facts.number();
  const bool levelled = facts.number() != 0.0;
  const double level_HU = facts.number();
  surface.level_HU = levelled ? std::optional(level_HU) : std::nullopt;
  surface.rawTriangles = facts.count(kMostAnswerBytes);
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
  surface.mesh = meshOfMail(rest.subspan(head.facts), where).mesh;
  return surface;
}

}  // namespace torsio
