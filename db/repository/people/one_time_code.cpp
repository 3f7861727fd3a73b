// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/repository/people/one_time_code.h"

#include <array>
#include <cstddef>
#include <openssl/evp.h>
#include <openssl/hmac.h>
#include <vector>

#include <sodium.h>

#include "db/repository/people/stored_password.h"
#include "sim/core/contracts.h"

namespace torsio {

namespace {

using Bytes = std::vector<unsigned char>;

constexpr std::size_t kSecretBytes = 20;  // as long as SHA-1, as RFC 4226 recommends
constexpr std::size_t kSecretLetters = 32;
constexpr std::int64_t kStep_us = 30'000'000;
constexpr std::string_view kBase32 = "ABCDEFGHIJKLMNOPQRSTUVWXYZ234567";
constexpr unsigned kBitsOfALetter = 5;
constexpr unsigned kBitsOfAByte = 8;

std::string inBase32(const Bytes& bytes) {
  std::string letters;
  unsigned held = 0;
  unsigned bits = 0;
  for (const unsigned char byte : bytes) {
    held = (held << kBitsOfAByte) | byte;
    bits += kBitsOfAByte;
    while (bits >= kBitsOfALetter) {
      bits -= kBitsOfALetter;
      letters += kBase32[(held >> bits) & 31U];
    }
  }
  return letters;
}

Bytes fromBase32(std::string_view letters) {
  Bytes bytes;
  unsigned held = 0;
  unsigned bits = 0;
  for (const char letter : letters) {
    held = (held << kBitsOfALetter) | static_cast<unsigned>(kBase32.find(letter));
    bits += kBitsOfALetter;
    if (bits >= kBitsOfAByte) {
      bits -= kBitsOfAByte;
      bytes.push_back(static_cast<unsigned char>((held >> bits) & 255U));
    }
  }
  return bytes;
}

/// The 32 bytes behind the last $ of an Argon2id hash; empty: it has another form.
Bytes keyOf(const std::string& hash) {
  Bytes key(crypto_aead_xchacha20poly1305_ietf_KEYBYTES);
  const std::string text = hash.substr(hash.rfind('$') + 1);
  std::size_t length = 0;
  if (sodium_base642bin(key.data(), key.size(), text.data(), text.size(), nullptr, &length, nullptr,
                        sodium_base64_VARIANT_ORIGINAL_NO_PADDING) != 0 ||
      length != key.size()) {
    key.clear();
  }
  return key;
}

const unsigned char* bytesOf(const std::string& text) {
  return reinterpret_cast<const unsigned char*>(text.data());
}

std::string inBase64(const Bytes& bytes) {
  std::vector<char> text(sodium_base64_encoded_len(bytes.size(), sodium_base64_VARIANT_ORIGINAL_NO_PADDING));
  sodium_bin2base64(text.data(), text.size(), bytes.data(), bytes.size(),
                    sodium_base64_VARIANT_ORIGINAL_NO_PADDING);
  return text.data();
}

}  // namespace

std::string newCodeSecret() {
  TORSIO_EXPECTS(sodium_init() >= 0);
  Bytes bytes(kSecretBytes);
  randombytes_buf(bytes.data(), bytes.size());
  return inBase32(bytes);
}

bool isCodeSecret(std::string_view secret) {
  return secret.size() == kSecretLetters && secret.find_first_not_of(kBase32) == std::string_view::npos;
}

std::int64_t codeStepAt(std::int64_t utc_us) {
  return utc_us / kStep_us;
}

std::string oneTimeCode(const std::string& secret, std::int64_t step) {
  TORSIO_EXPECTS(isCodeSecret(secret));
  constexpr std::size_t kCounterBytes = 8;
  constexpr std::size_t kDigits = 6;
  constexpr std::uint32_t kMillion = 1'000'000;
  const Bytes key = fromBase32(secret);
  std::array<unsigned char, kCounterBytes> counter{};
  auto rest = static_cast<std::uint64_t>(step);
  for (std::size_t i = kCounterBytes; i-- > 0; rest >>= kBitsOfAByte) {
    counter[i] = static_cast<unsigned char>(rest & 255U);
  }
  std::array<unsigned char, EVP_MAX_MD_SIZE> mac{};
  unsigned length = 0;
  TORSIO_EXPECTS(HMAC(EVP_sha1(), key.data(), static_cast<int>(key.size()), counter.data(), counter.size(),
                      mac.data(), &length) != nullptr &&
                 length == kSecretBytes);
  const std::size_t from = mac[length - 1] & 15U;  // RFC 4226, 5.3
  const std::uint32_t number = ((mac[from] & 127U) << 24U) |
                               (static_cast<std::uint32_t>(mac[from + 1]) << 16U) |
                               (static_cast<std::uint32_t>(mac[from + 2]) << 8U) | mac[from + 3];
  std::string digits = std::to_string(number % kMillion);
  return digits.insert(0, kDigits - digits.size(), '0');
}

std::optional<std::int64_t> stepOfCode(const std::string& secret, const std::string& code,
                                       std::int64_t utc_us) {
  const std::int64_t now = codeStepAt(utc_us);
  std::optional<std::int64_t> found;
  for (const std::int64_t step : {now - 1, now, now + 1}) {
    const std::string right = oneTimeCode(secret, step);
    if (code.size() == right.size() && sodium_memcmp(code.data(), right.data(), right.size()) == 0) {
      found = step;
    }
  }
  return found;
}

std::string sealedCodeSecret(const std::string& secret, const std::string& password, const UserId& userId,
                             PasswordCost cost) {
  const std::string hash = hashPassword(password, cost);  // with a salt of its own: another key than any hash
  const Bytes key = keyOf(hash);
  TORSIO_EXPECTS(!key.empty());
  const std::string& owner = userId.text();
  constexpr std::size_t kNonceBytes = crypto_aead_xchacha20poly1305_ietf_NPUBBYTES;
  Bytes box(kNonceBytes + secret.size() + crypto_aead_xchacha20poly1305_ietf_ABYTES);
  randombytes_buf(box.data(), kNonceBytes);
  crypto_aead_xchacha20poly1305_ietf_encrypt(box.data() + kNonceBytes, nullptr, bytesOf(secret),
                                             secret.size(), bytesOf(owner), owner.size(), nullptr, box.data(),
                                             key.data());
  return hash.substr(0, hash.rfind('$') + 1) + inBase64(box);  // what made the key, then what it closes
}

std::string openedCodeSecret(const std::string& sealed, const std::string& password, const UserId& userId) {
  constexpr std::size_t kNonceBytes = crypto_aead_xchacha20poly1305_ietf_NPUBBYTES;
  constexpr std::size_t kTagBytes = crypto_aead_xchacha20poly1305_ietf_ABYTES;
  const std::string text = sealed.substr(sealed.rfind('$') + 1);
  Bytes box(text.size());
  std::size_t length = 0;
  if (sodium_base642bin(box.data(), box.size(), text.data(), text.size(), nullptr, &length, nullptr,
                        sodium_base64_VARIANT_ORIGINAL_NO_PADDING) != 0 ||
      length != kNonceBytes + kSecretLetters + kTagBytes) {
    return {};
  }
  const Bytes key = keyOf(hashLike(sealed, password));
  const std::string& owner = userId.text();
  Bytes secret(kSecretLetters);
  if (key.empty() || crypto_aead_xchacha20poly1305_ietf_decrypt(
                         secret.data(), nullptr, nullptr, box.data() + kNonceBytes, length - kNonceBytes,
                         bytesOf(owner), owner.size(), box.data(), key.data()) != 0) {
    return {};
  }
  std::string opened(secret.begin(), secret.end());
  return isCodeSecret(opened) ? opened : std::string();
}

}  // namespace torsio
