// SPDX-License-Identifier: GPL-3.0-or-later
// mutate_apart SECONDS: reads randomly mutated DICOM series and meshes like users' files, in separate
// processes (TORSIO_SCAN_PROGRAM, TORSIO_MESH_PROGRAM). The result must be a surface or an Error, whatever
// happens to the process: anything else, or exceeding a time limit, exits with 1.
#include <chrono>
#include <cstdint>
#include <filesystem>
#include <iostream>
#include <map>
#include <string>
#include <unistd.h>
#include <vector>

#include "sim/core/error.h"
#include "sim/core/file_io.h"
#include "sim/geometry/apart/mesh_process.h"
#include "sim/imaging/apart/scan_process.h"
#include "tests/support/dicom_files.h"
#include "tests/support/mesh_formats.h"
#include "tests/support/procedural_mesh.h"
#include "tests/support/scan_files.h"

namespace {

namespace fs = std::filesystem;
using namespace torsio;

constexpr HelperLimits kLimits{4'000, 20, 30};
constexpr auto kMaxAnswer = std::chrono::seconds(40);

/// Reproducible pseudo-random numbers.
class Dice {
 public:
  explicit Dice(std::uint64_t seed) : state_(seed * 2 + 1) {}
  std::size_t below(std::size_t most) {
    state_ = state_ * 6364136223846793005U + 1442695040888963407U;
    return most == 0 ? 0 : static_cast<std::size_t>(state_ >> 33U) % most;
  }

 private:
  std::uint64_t state_;
};

/// Mutates bytes: flips some, replaces part of the head, removes a piece, or truncates.
std::string changed(std::string bytes, Dice& dice) {
  switch (dice.below(4)) {
    case 0:
      bytes.resize(dice.below(bytes.size()));
      break;
    case 1:
      bytes.erase(dice.below(bytes.size()), 1 + dice.below(64));
      break;
    case 2:
      for (std::size_t n = 0; n < 1 + dice.below(8) && !bytes.empty(); ++n) {
        bytes[dice.below(std::min<std::size_t>(bytes.size(), 1500))] = static_cast<char>(dice.below(256));
      }
      break;
    default:
      for (std::size_t n = 0; n < 1 + dice.below(32) && !bytes.empty(); ++n) {
        char& byte = bytes[dice.below(bytes.size())];
        byte = static_cast<char>(byte ^ (1 << dice.below(8)));
      }
  }
  return bytes;
}

/// Summarises an answer in a few words.
template <typename Read>
std::string answerOf(const Read& read) {
  const auto begun = std::chrono::steady_clock::now();
  std::string answer = "a surface";
  try {
    read();
  } catch (const Error& error) {
    const std::string happened = error.happened();
    answer = happened.find("crashed") != std::string::npos ? "refused: the reader crashed"
                                                           : "refused: " + happened.substr(0, 3);
  }
  if (std::chrono::steady_clock::now() - begun > kMaxAnswer) {
    std::cerr << "no answer within the limits\n";
    std::exit(1);
  }
  return answer;
}

std::vector<std::string> filesOf(const fs::path& folder) {
  std::vector<std::string> all;
  for (const auto& entry : fs::directory_iterator(folder)) {
    all.push_back(entry.path().string());
  }
  return all;
}

}  // namespace

int main(int argc, char** argv) {
  const long seconds = argc > 1 ? std::strtol(argv[1], nullptr, 10) : 10;
  const fs::path folder = fs::temp_directory_path() / ("torsio-mutate-" + std::to_string(getpid()));
  const TriangleMesh bar = torsio::testing::capsule(0.02, 0.06, 16, 6);
  ScanVolume scan = torsio::testing::blankScanAround(bar, {4, 4, 5}, 16.0);
  torsio::testing::fillWith(scan, bar, 40);
  std::vector<fs::path> series;
  for (const std::string syntax : {"plain", "rle", "jpeg", "jpeg-ls", "deflated", "implicit"}) {
    series.push_back(folder / syntax);
    torsio::testing::writeDicomSeries(series.back(), scan, {.syntax = syntax});
  }
  const std::vector<std::pair<std::string, std::string>> meshes = torsio::testing::everyFormat(bar);
  std::map<std::string, std::size_t> answers;
  const auto until = std::chrono::steady_clock::now() + std::chrono::seconds(seconds);
  for (std::uint64_t n = 1; std::chrono::steady_clock::now() < until; ++n) {
    Dice dice(n);
    if (n % 2 == 0) {
      const auto& [ending, bytes] = meshes[dice.below(meshes.size())];
      const fs::path file = folder / ("mesh" + ending);
      writeFileAtomically(file, changed(bytes, dice));
      ++answers["mesh, " + answerOf([&] { static_cast<void>(readMeshApart(file, 0.001, kLimits)); })];
      continue;
    }
    const std::vector<std::string> slices = filesOf(series[dice.below(series.size())]);
    const fs::path slice = slices[dice.below(slices.size())];
    const std::string good = readFile(slice);
    writeFileAtomically(slice, changed(good, dice));
    ScanRequest request;
    request.source = slice.parent_path();
    ++answers["DICOM, " + answerOf([&] { static_cast<void>(scanApart(request, {}, kLimits)); })];
    writeFileAtomically(slice, good);
  }
  fs::remove_all(folder);
  for (const auto& [answer, count] : answers) {
    std::cout << count << '\t' << answer << '\n';
  }
  return 0;
}
