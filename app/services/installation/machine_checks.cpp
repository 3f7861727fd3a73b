// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <cstdlib>
#include <thread>

#include <QDateTime>
#include <QList>
#include <QSslCertificate>
#ifdef __linux__
#include <sys/timex.h>
#endif

#include "app/services/devices/device_choice.h"
#include "app/services/devices/device_readiness.h"
#include "app/services/installation/computer_settings.h"
#include "app/services/installation/installation_checks.h"
#include "app/services/maintenance/anchor.h"
#include "app/services/maintenance/station_anchor.h"
#include "assessment/results/number_format.h"
#include "sim/core/deadline.h"
#include "sim/core/time_units.h"

namespace torsio {

namespace {

bool isSet(const char* variable) {
  const char* value = std::getenv(variable);
  return value != nullptr && *value != '\0';
}

bool hasDisplay() {
#if defined(_WIN32) || defined(__APPLE__)
  return true;
#else
  return isSet("DISPLAY") || isSet("WAYLAND_DISPLAY");
#endif
}

}  // namespace

InstallationCheck displayCheck() {
  return hasDisplay() ? good("display", Text::tr("found"))
                      : InstallationCheck{"display",
                                          CheckState::kSkipped,
                                          Text::tr("no display: a server, or a session without a desktop"),
                                          {}};
}

InstallationCheck graphicsCheck() {
  if (!hasDisplay()) {
    return {"graphics", CheckState::kSkipped, Text::tr("no display"), {}};
  }
#ifdef __linux__
  std::error_code failed;
  for (const auto& entry : std::filesystem::directory_iterator("/dev/dri", failed)) {
    if (entry.path().filename().string().starts_with("renderD")) {
      return good("graphics", Text::tr("found: %1", entry.path().string()));
    }
  }
  return {"graphics", CheckState::kWarning,
          Text::tr("no graphics card: the processor draws, and the picture moves less smoothly"),
          Text::tr("Use a computer with a graphics card for training stations; for anything else this is "
                   "enough")};
#else
  return {"graphics", CheckState::kSkipped, Text::tr("not checked on this system"), {}};
#endif
}

InstallationCheck configurationCheck() {
  const std::filesystem::path file = configurationFile();
  if (file.empty()) {
    return good("configuration", Text::tr("this computer has none; each account has its own settings"));
  }
  requireUsable(Configuration::read(file));
  return good("configuration", Text::tr("%1 can be used", file.string()));
}

InstallationCheck deviceCheck() {
  const DeviceChoice choice = rememberedDevice();
  if (choice.driver.empty()) {
    return good("device", Text::tr("no haptic device is chosen; mouse and keyboard are used"));
  }
  const DeviceDriver& driver = chosenDriver(choice);
  return good("device", Text::tr("%1 is chosen; torsio device check tests it", driver.id));
}

InstallationCheck realTimeCheck() {
  bool granted = false;
  std::thread([&granted] { granted = requestRealTime(); }).join();  // leaves this thread as it is
  return granted ? good("real_time", Text::tr("the system grants real-time priority"))
                 : InstallationCheck{"real_time", CheckState::kWarning, refusedToServo(false, true),
                                     grantRealTime()};
}

InstallationCheck memoryCheck() {
  const std::array<char, 1> page{};
  return LockedMemory(page.data(), page.size()).locked()
             ? good("memory", Text::tr("the system allows the servo's memory to be locked"))
             : InstallationCheck{"memory", CheckState::kWarning, refusedToServo(true, false),
                                 grantRealTime()};
}

InstallationCheck clockCheck() {
#ifdef __linux__
  timex state{};
  if (adjtimex(&state) == -1) {
    return {"clock", CheckState::kSkipped, Text::tr("the system does not say whether the clock is set"), {}};
  }
  return (state.status & STA_UNSYNC) == 0
             ? good("clock", Text::tr("set by a time server"))
             : InstallationCheck{
                   "clock", CheckState::kWarning,
                   Text::tr("not set by a time server: times of runs, marks and audit entries may "
                            "be wrong"),
                   Text::tr("Turn time synchronisation on: timedatectl set-ntp true")};
#else
  return {"clock", CheckState::kSkipped, Text::tr("not checked on this system"), {}};
#endif
}

InstallationCheck diskCheck(const std::filesystem::path& folder) {
  const double free_gb = static_cast<double>(std::filesystem::space(folder).available) / 1e9;
  const Text finding = Text::tr("%1 GB free in %2", formatFixed(free_gb, 1), folder.string());
  if (free_gb >= kDiskTight_gb) {
    return good("disk", finding);
  }
  return {"disk", free_gb < kDiskFull_gb ? CheckState::kFailed : CheckState::kWarning, finding,
          Text::tr("Free at least %1 GB: a run takes up to 10 MB, a backup as much as the record",
                   formatFixed(kDiskTight_gb, 0))};
}

InstallationCheck certificateCheck(const Installation& installation) {
  if (installation.certificate.empty()) {
    return {
        "certificate", CheckState::kSkipped, Text::tr("no certificate was named (--certificate FILE)"), {}};
  }
  const QList<QSslCertificate> chain =
      QSslCertificate::fromPath(QString::fromStdString(installation.certificate.string()));
  if (chain.isEmpty()) {
    return {"certificate", CheckState::kFailed,
            std::filesystem::is_regular_file(installation.certificate)
                ? Text::tr("no certificate in %1", installation.certificate.string())
                : Text::tr("no such file: %1", installation.certificate.string()),
            Text::tr("Name the PEM file that torsio serve uses")};
  }
  const std::int64_t from_us = chain.front().effectiveDate().toMSecsSinceEpoch() * 1000;
  if (from_us > installation.now_us) {
    return {"certificate", CheckState::kFailed, Text::tr("not valid before %1", formatUtc(from_us)),
            Text::tr("Check the clock, or get another certificate")};
  }
  const std::int64_t until_us = chain.front().expiryDate().toMSecsSinceEpoch() * 1000;
  const std::int64_t days = (until_us - installation.now_us) / kDay_us;
  if (until_us > installation.now_us && days > kCertificateSoon_days) {
    return good("certificate", Text::tr("valid for another %1 {day|days}", days));
  }
  const Text remedy = Text::tr("Renew it and start torsio serve again");
  if (until_us <= installation.now_us) {
    return {"certificate", CheckState::kFailed, Text::tr("expired on %1", formatUtc(until_us)), remedy};
  }
  return {"certificate", CheckState::kWarning, Text::tr("expires within %1 {day|days}", days + 1), remedy};
}

InstallationCheck keyCheck(const std::filesystem::path& record) {
  const std::filesystem::path key = stationAnchor().key;
  if (key.empty()) {
    return {"key", CheckState::kWarning,
            Text::tr("this station has no signing key: nothing shows that an export or the audit trail comes "
                     "from here"),
            Text::tr("Make one on the page Audit trail, in a place outside the record's folder")};
  }
  const std::string known = publicAnchorKey(key);
  if (key.parent_path() == std::filesystem::absolute(record).parent_path()) {
    return {"key", CheckState::kWarning, Text::tr("the key %1 lies beside the record", known.substr(0, 16)),
            Text::tr("Keep it elsewhere: whoever copies the record must not get the key")};
  }
  return good("key", Text::tr("the key %1 can be used", known.substr(0, 16)));
}

InstallationCheck witnessCheck() {
  const std::filesystem::path witness = stationAnchor().witness;
  if (witness.empty()) {
    return {"witness", CheckState::kWarning,
            Text::tr("no witness file: a record that was cut short or exchanged cannot be recognised"),
            Text::tr("Choose one on the page Audit trail, on another disk")};
  }
  const std::vector<std::string> heads = headsOf(witness);
  static_cast<void>(readHead(heads.back()));  // throws for anything else
  return good("witness", Text::tr("%1 {line|lines} in %2", heads.size(), witness.string()));
}

}  // namespace torsio
