// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/web/own_certificate.h"

#include <algorithm>
#include <arpa/inet.h>
#include <array>
#include <cstddef>
#include <gnutls/crypto.h>
#include <gnutls/gnutls.h>
#include <gnutls/x509.h>
#include <ifaddrs.h>
#include <memory>
#include <net/if.h>
#include <netinet/in.h>
#include <optional>
#include <sys/socket.h>
#include <unistd.h>

#include "sim/core/error.h"
#include "sim/core/file_io.h"

namespace torsio::web {

namespace {

constexpr const char* kFileName = "review-desk.pem";
constexpr std::int64_t kDay_s = 86'400;
constexpr std::int64_t kLife_s = 365 * kDay_s;
constexpr std::int64_t kLeastLeft_s = 14 * kDay_s;
constexpr std::int64_t kClockSlack_s = kDay_s;
constexpr std::size_t kSerialBytes = 16;
const std::array<std::string, 3> kOwnNames{"localhost", "127.0.0.1", "::1"};

void require(int answer) {
  if (answer < 0) {
    throw Error(ErrorCode::kFileUnwritable, Text::verbatim("no certificate can be made"),
                std::string(gnutls_strerror(answer)), Text::verbatim("Give one by --certificate and --key"));
  }
}

struct FreeCertificate {
  void operator()(gnutls_x509_crt_t one) const noexcept { gnutls_x509_crt_deinit(one); }
};
struct FreeKey {
  void operator()(gnutls_x509_privkey_t one) const noexcept { gnutls_x509_privkey_deinit(one); }
};
using Certificate = std::unique_ptr<std::remove_pointer_t<gnutls_x509_crt_t>, FreeCertificate>;
using Key = std::unique_ptr<std::remove_pointer_t<gnutls_x509_privkey_t>, FreeKey>;

/// Returns the first certificate of a PEM text; null if there is none.
Certificate certificateIn(const std::string& pem) {
  gnutls_x509_crt_t raw = nullptr;
  require(gnutls_x509_crt_init(&raw));
  Certificate certificate(raw);
  std::string bytes = pem;
  const gnutls_datum_t data{reinterpret_cast<unsigned char*>(bytes.data()),
                            static_cast<unsigned>(bytes.size())};
  return gnutls_x509_crt_import(raw, &data, GNUTLS_X509_FMT_PEM) < 0 ? nullptr : std::move(certificate);
}

/// Returns the four or sixteen bytes of an IP address; empty for a name.
std::string addressBytes(const std::string& name) {
  std::array<unsigned char, sizeof(in6_addr)> bytes{};
  for (const auto& [family, length] : {std::pair{AF_INET, sizeof(in_addr)}, {AF_INET6, sizeof(in6_addr)}}) {
    if (inet_pton(family, name.c_str(), bytes.data()) == 1) {
      return {reinterpret_cast<const char*>(bytes.data()), length};
    }
  }
  return {};
}

bool servesFor(const Certificate& certificate, const std::vector<std::string>& names, std::int64_t now_s) {
  return certificate != nullptr &&
         gnutls_x509_crt_get_expiration_time(certificate.get()) - now_s > kLeastLeft_s &&
         std::all_of(names.begin(), names.end(), [&](const std::string& name) {
           const std::string address = addressBytes(name);
           return address.empty()
                      ? gnutls_x509_crt_check_hostname(certificate.get(), name.c_str()) != 0
                      : gnutls_x509_crt_check_ip(certificate.get(),
                                                 reinterpret_cast<const unsigned char*>(address.data()),
                                                 static_cast<unsigned>(address.size()), 0) != 0;
         });
}

std::string pemOf(gnutls_datum_t& data) {
  std::string pem(reinterpret_cast<const char*>(data.data), data.size);
  gnutls_free(data.data);
  return pem;
}

TlsMaterial madeFor(const std::vector<std::string>& names, std::int64_t now_s) {
  gnutls_x509_privkey_t rawKey = nullptr;
  require(gnutls_x509_privkey_init(&rawKey));
  const Key key(rawKey);
  require(gnutls_x509_privkey_generate(rawKey, GNUTLS_PK_ECDSA,
                                       GNUTLS_CURVE_TO_BITS(GNUTLS_ECC_CURVE_SECP256R1), 0));
  gnutls_x509_crt_t raw = nullptr;
  require(gnutls_x509_crt_init(&raw));
  const Certificate certificate(raw);
  std::array<unsigned char, kSerialBytes> serial{};
  require(gnutls_rnd(GNUTLS_RND_NONCE, serial.data(), serial.size()));
  serial[0] &= 0x7F;  // positive
  require(gnutls_x509_crt_set_version(raw, 3));
  require(gnutls_x509_crt_set_serial(raw, serial.data(), serial.size()));
  require(gnutls_x509_crt_set_activation_time(raw, now_s - kClockSlack_s));
  require(gnutls_x509_crt_set_expiration_time(raw, now_s + kLife_s));
  const std::string about = "Torsio review desk";
  require(gnutls_x509_crt_set_dn_by_oid(raw, GNUTLS_OID_X520_COMMON_NAME, 0, about.data(),
                                        static_cast<unsigned>(about.size())));
  for (const std::string& name : names) {
    const std::string address = addressBytes(name);
    const std::string& said = address.empty() ? name : address;
    require(gnutls_x509_crt_set_subject_alt_name(
        raw, address.empty() ? GNUTLS_SAN_DNSNAME : GNUTLS_SAN_IPADDRESS, said.data(),
        static_cast<unsigned>(said.size()), GNUTLS_FSAN_APPEND));
  }
  require(gnutls_x509_crt_set_basic_constraints(raw, 0, -1));
  require(gnutls_x509_crt_set_key_usage(raw, GNUTLS_KEY_DIGITAL_SIGNATURE));
  require(gnutls_x509_crt_set_key_purpose_oid(raw, GNUTLS_KP_TLS_WWW_SERVER, 0));
  require(gnutls_x509_crt_set_key(raw, rawKey));
  require(gnutls_x509_crt_sign2(raw, raw, rawKey, GNUTLS_DIG_SHA256, 0));
  gnutls_datum_t pem{};
  TlsMaterial made;
  require(gnutls_x509_crt_export2(raw, GNUTLS_X509_FMT_PEM, &pem));
  made.certificate = pemOf(pem);
  require(gnutls_x509_privkey_export2(rawKey, GNUTLS_X509_FMT_PEM, &pem));
  made.key = pemOf(pem);
  return made;
}

/// Reads a file written by madeFor(): certificate and key.
std::optional<TlsMaterial> readMaterial(const std::filesystem::path& file) {
  if (!std::filesystem::exists(file)) {
    return std::nullopt;
  }
  const std::string pem = readFile(file);
  const std::size_t key = pem.find("-----BEGIN", 1);
  if (key == std::string::npos) {
    return std::nullopt;
  }
  return TlsMaterial{pem.substr(0, key), pem.substr(key)};
}

}  // namespace

std::vector<std::string> machineNames() {
  std::vector<std::string> names;
  ifaddrs* all = nullptr;
  if (getifaddrs(&all) == 0) {
    const std::unique_ptr<ifaddrs, void (*)(ifaddrs*)> owner(all, freeifaddrs);
    for (const ifaddrs* one = all; one != nullptr; one = one->ifa_next) {
      if (one->ifa_addr == nullptr || one->ifa_addr->sa_family != AF_INET ||
          (one->ifa_flags & (IFF_LOOPBACK | IFF_UP)) != IFF_UP) {
        continue;
      }
      std::array<char, INET_ADDRSTRLEN> text{};
      const auto* address = reinterpret_cast<const sockaddr_in*>(one->ifa_addr);
      if (inet_ntop(AF_INET, &address->sin_addr, text.data(), text.size()) != nullptr) {
        names.emplace_back(text.data());
      }
    }
  }
  std::array<char, 256> name{};
  if (gethostname(name.data(), name.size() - 1) == 0 && name[0] != '\0') {
    names.emplace_back(name.data());
  }
  return names;
}

std::vector<std::string> namesIn(const std::string& certificate) {
  std::vector<std::string> names;
  const Certificate one = certificateIn(certificate);
  for (unsigned at = 0; one != nullptr; ++at) {
    std::array<char, 256> text{};
    std::size_t size = text.size();
    const int kind = gnutls_x509_crt_get_subject_alt_name(one.get(), at, text.data(), &size, nullptr);
    if (kind == GNUTLS_E_REQUESTED_DATA_NOT_AVAILABLE) {
      break;
    }
    if (kind == GNUTLS_SAN_DNSNAME) {
      names.emplace_back(text.data(), size);
    }
  }
  return names;
}

std::string fingerprintOf(const std::string& certificate) {
  const Certificate one = certificateIn(certificate);
  std::array<unsigned char, 32> bytes{};
  std::size_t size = bytes.size();
  if (one == nullptr ||
      gnutls_x509_crt_get_fingerprint(one.get(), GNUTLS_DIG_SHA256, bytes.data(), &size) < 0) {
    return {};
  }
  static constexpr const char* kDigits = "0123456789ABCDEF";
  std::string text;
  for (const unsigned char byte : bytes) {
    text += (text.empty() ? "" : ":") + std::string{kDigits[byte >> 4U], kDigits[byte & 15U]};
  }
  return text;
}

OwnCertificate ownCertificate(const std::filesystem::path& folder, const std::vector<std::string>& names,
                              std::int64_t now_s) {
  std::vector<std::string> wanted = names;
  wanted.insert(wanted.end(), kOwnNames.begin(), kOwnNames.end());
  const std::filesystem::path file = folder / kFileName;
  std::optional<TlsMaterial> kept = readMaterial(file);
  if (!kept || !servesFor(certificateIn(kept->certificate), wanted, now_s)) {
    kept = madeFor(wanted, now_s);
    ensureFolder(folder);
    writeFileAtomically(file, kept->certificate + kept->key);
    makePrivate(file);
  }
  return {*kept, fingerprintOf(kept->certificate)};
}

}  // namespace torsio::web
