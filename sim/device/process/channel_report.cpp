// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cstring>

#include "sim/device/process/device_channel.h"

namespace torsio {

namespace {

constexpr std::uint32_t kMostParts = 64;
constexpr int kDeepestText = 6;
constexpr std::size_t kLongestText = 8'192;

class Packer {
 public:
  void number(double value) { bytes_.append(reinterpret_cast<const char*>(&value), sizeof(value)); }
  void text(const std::string& value) {
    number(static_cast<double>(value.size()));
    bytes_ += value;
  }
  void text(const Text& value) {
    text(value.pattern());
    number(static_cast<double>(value.arguments().size()));
    for (const Text& argument : value.arguments()) {
      text(argument);
    }
  }
  template <typename Part>
  void list(const std::vector<Part>& parts) {
    number(static_cast<double>(parts.size()));
    for (const Part& part : parts) {
      text(part);
    }
  }
  [[nodiscard]] const std::string& bytes() const { return bytes_; }

 private:
  std::string bytes_;
};

class Unpacker {
 public:
  explicit Unpacker(const std::string& bytes) : bytes_(bytes) {}
  double number() {
    double value = 0.0;
    if (bytes_.size() - at_ >= sizeof(value)) {
      std::memcpy(&value, bytes_.data() + at_, sizeof(value));
      at_ += sizeof(value);
    }
    return value;
  }
  std::size_t count(std::size_t most) {
    const double value = number();
    return value > 0.0 && value <= static_cast<double>(most) ? static_cast<std::size_t>(value) : 0;
  }
  void text(std::string& value) {
    const std::size_t wanted = count(kLongestText);
    const std::size_t size = std::min(wanted, bytes_.size() - at_);
    value = bytes_.substr(at_, size);
    at_ += size;
  }
  void text(Text& value, int depth = 0) {
    std::string pattern;
    text(pattern);
    const std::size_t size = depth < kDeepestText ? count(kMostParts) : 0;
    std::vector<Text> arguments(size);
    for (Text& argument : arguments) {
      text(argument, depth + 1);
    }
    value = Text::restored(pattern, std::move(arguments));
  }
  template <typename Part>
  void list(std::vector<Part>& parts) {
    parts.resize(count(kMostParts));
    for (Part& part : parts) {
      text(part);
    }
  }

 private:
  const std::string& bytes_;
  std::size_t at_ = 0;
};

/// One order of fields for both ways.
template <typename Way, typename Report>
void texts(Way& way, Report& report) {
  way.text(report.library.path);
  way.list(report.library.searched);
  way.list(report.library.missingSymbols);
  way.list(report.library.absentOptionals);
  way.text(report.library.sentence);
  way.text(report.library.remedy);
  way.text(report.finding.sentence);
  way.text(report.finding.remedy);
  way.list(report.finding.notes);
  way.text(report.happened);
  way.text(report.where);
  way.text(report.remedy);
  way.text(report.capabilities.model);
  way.text(report.identity.model);
  way.text(report.identity.vendor);
  way.text(report.identity.serial);
  way.text(report.identity.driverVersion);
  way.text(report.identity.libraryVersion);
  way.text(report.identity.openedAs);
  way.list(report.identity.assumed);
  way.list(report.identity.notes);
}

}  // namespace

std::string packed(const ChannelReport& report) {
  Packer way;
  const DeviceCapabilities& c = report.capabilities;
  way.number(static_cast<double>(report.library.status));
  way.number(report.finding.available ? 1.0 : 0.0);
  for (const double value :
       {c.maxForce_N, c.continuousForce_N, c.maxStiffness_N_per_m, c.workspaceMin_m.x, c.workspaceMin_m.y,
        c.workspaceMin_m.z, c.workspaceMax_m.x, c.workspaceMax_m.y, c.workspaceMax_m.z}) {
    way.number(value);
  }
  way.number(report.identity.inputDof);
  way.number(report.identity.outputDof);
  texts(way, report);
  return way.bytes();
}

ChannelReport unpacked(const std::string& bytes) {
  ChannelReport report;
  Unpacker way(bytes);
  const std::size_t status = way.count(static_cast<std::size_t>(HdapiLoadStatus::kSymbolMissing));
  report.library.status = static_cast<HdapiLoadStatus>(status);
  report.finding.available = way.number() == 1.0;
  DeviceCapabilities& c = report.capabilities;
  for (double* value : {&c.maxForce_N, &c.continuousForce_N, &c.maxStiffness_N_per_m, &c.workspaceMin_m.x,
                        &c.workspaceMin_m.y, &c.workspaceMin_m.z, &c.workspaceMax_m.x, &c.workspaceMax_m.y,
                        &c.workspaceMax_m.z}) {
    *value = way.number();
  }
  report.identity.inputDof = static_cast<int>(way.number());
  report.identity.outputDof = static_cast<int>(way.number());
  texts(way, report);
  c.rendersForce = true;
  c.realTime = true;
  return report;
}

}  // namespace torsio
