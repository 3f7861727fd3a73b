// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/recording/recording_spec.h"

#include <algorithm>
#include <fstream>
#include <string>
#include <system_error>
#include <thread>
#include <vector>

#include <QString>
#include <QSysInfo>
#include <QtGlobal>

#include "app/services/access/station_name.h"
#include "app/services/base/build_info.h"
#include "sim/servo/servo_loop.h"

namespace torsio {

TrialHeader headerFor(const Scene& scene, const DeviceCapabilities& device, const RecordingSpec& spec) {
  TrialHeader header;
  header.trialId = spec.trialId;
  header.traineeCode = spec.traineeCode;
  header.phaseLabel = spec.phaseLabel;
  header.startedUtc_us = spec.startedUtc_us;
  header.demonstration = spec.demonstration;
  header.targetAngle_rad = spec.targetAngle_rad.value_or(scene.pattern.targetAngle_rad);

  header.sceneId = scene.id;
  header.patternId = scene.pattern.id;
  header.organHash = scene.organHash;
  header.parameterHash = scene.parameterHash;
  header.parametersJson = scene.parametersJson;
  header.model = scene.tissue;

  header.deviceModel = device.model;
  header.deviceLimits = deviceLimits(device);
  header.drive = device.drive;

  header.softwareVersion = softwareVersion();
  return header;
}

namespace {

namespace fs = std::filesystem;

/// Reads system files with "key : value" or "KEY=value". Empty if the file or key is missing.
std::string valueOf(const fs::path& file, const std::string& key, char separator) {
  std::ifstream in(file);
  for (std::string line; std::getline(in, line);) {
    const std::size_t at = line.find(separator);
    if (at == std::string::npos || line.compare(0, key.size(), key) != 0) {
      continue;
    }
    const std::size_t begin = line.find_first_not_of(" \t", at + 1);
    return begin == std::string::npos ? std::string() : line.substr(begin);
  }
  return {};
}

std::string processor(const fs::path& root) {
  std::string name = valueOf(root / "proc/cpuinfo", "model name", ':');
  if (name.empty()) {
    name = qEnvironmentVariable("PROCESSOR_IDENTIFIER").toStdString();  // Windows
  }
  if (name.empty()) {
    name = QSysInfo::currentCpuArchitecture().toStdString();
  }
  const unsigned threads = std::thread::hardware_concurrency();
  return threads == 0 ? name : name + ", " + std::to_string(threads) + " threads";
}

std::vector<fs::path> entriesOf(const fs::path& folder) {
  std::vector<fs::path> entries;
  std::error_code missing;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, missing)) {
    entries.push_back(entry.path());
  }
  std::sort(entries.begin(), entries.end());
  return entries;
}

/// Returns the vendor's name if the driver provides it, else driver and PCI number.
std::string graphicsCard(const fs::path& root) {
  for (const fs::path& card : entriesOf(root / "proc/driver/nvidia/gpus")) {
    if (std::string name = valueOf(card / "information", "Model", ':'); !name.empty()) {
      return name;
    }
  }
  for (const fs::path& card : entriesOf(root / "sys/class/drm")) {
    const fs::path about = card / "device/uevent";
    const std::string driver = valueOf(about, "DRIVER", '=');
    if (!driver.empty()) {
      return driver + " " + valueOf(about, "PCI_ID", '=');
    }
  }
  return {};
}

}  // namespace

RecordingHost thisHost(const fs::path& root) {
  return {.name = stationSign().computer,
          .os = QSysInfo::prettyProductName().toStdString() + ", " + QSysInfo::kernelType().toStdString() +
                " " + QSysInfo::kernelVersion().toStdString(),
          .cpu = processor(root),
          .gpu = graphicsCard(root)};
}

TrialContext stationContext() {
  return {.station = stationName(), .host = thisHost()};
}

}  // namespace torsio
