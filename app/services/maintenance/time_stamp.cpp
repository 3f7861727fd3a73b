// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/maintenance/time_stamp.h"

#include <algorithm>
#include <array>
#include <ctime>
#include <memory>
#include <openssl/asn1.h>
#include <openssl/err.h>
#include <openssl/evp.h>
#include <openssl/pem.h>
#include <openssl/rand.h>
#include <openssl/ts.h>
#include <openssl/x509_vfy.h>

#include <climits>

#include "sim/core/error.h"
#include "sim/core/plain_text.h"
#include "sim/core/time_units.h"

namespace torsio {

namespace {

template <auto Free>
struct Freed {
  template <class Thing>
  void operator()(Thing* thing) const {
    Free(thing);
  }
};
template <class Thing, auto Free>
using Owned = std::unique_ptr<Thing, Freed<Free>>;

void freeList(STACK_OF(X509) * some) {  // OpenSSL's own names of these two are macros
  sk_X509_free(some);
}
void freeBytes(unsigned char* bytes) {
  OPENSSL_free(bytes);
}

using Request = Owned<TS_REQ, TS_REQ_free>;
using Response = Owned<TS_RESP, TS_RESP_free>;
using Certificates = Owned<X509_STORE, X509_STORE_free>;

constexpr int kHash_bytes = 32;
constexpr int kNonce_bytes = 16;
constexpr std::size_t kShown = 200;  // characters of what an authority says

[[noreturn]] void refuseStamp(const Text& what) {
  throw Error(ErrorCode::kVerifyFailed, what, Text::tr("time stamp"),
              Text::tr("Ask again, or ask whoever runs the time stamp authority"));
}

std::array<unsigned char, kHash_bytes> hashOf(const std::string& text) {
  std::array<unsigned char, kHash_bytes> digest{};
  if (EVP_Digest(text.data(), text.size(), digest.data(), nullptr, EVP_sha256(), nullptr) != 1) {
    throw ContractError("OpenSSL cannot compute SHA-256");
  }
  return digest;
}

/// Returns the question about a text, without a nonce.
Request requestFor(const std::string& text) {
  std::array<unsigned char, kHash_bytes> digest = hashOf(text);
  Request request(TS_REQ_new());
  const Owned<TS_MSG_IMPRINT, TS_MSG_IMPRINT_free> imprint(TS_MSG_IMPRINT_new());
  const Owned<X509_ALGOR, X509_ALGOR_free> algorithm(X509_ALGOR_new());
  const bool made = request && imprint && algorithm &&
                    X509_ALGOR_set0(algorithm.get(), OBJ_nid2obj(NID_sha256), V_ASN1_NULL, nullptr) == 1 &&
                    TS_MSG_IMPRINT_set_algo(imprint.get(), algorithm.get()) == 1 &&
                    TS_MSG_IMPRINT_set_msg(imprint.get(), digest.data(), kHash_bytes) == 1 &&
                    TS_REQ_set_version(request.get(), 1) == 1 &&
                    TS_REQ_set_msg_imprint(request.get(), imprint.get()) == 1 &&
                    TS_REQ_set_cert_req(request.get(), 1) == 1;
  if (!made) {
    throw ContractError("OpenSSL made no question for a time stamp");
  }
  return request;
}

Certificates storeOf(const std::string& pem) {
  Certificates store(X509_STORE_new());
  const Owned<BIO, BIO_free_all> in(BIO_new_mem_buf(pem.data(), static_cast<int>(pem.size())));
  int certificates = 0;
  while (store && in) {
    const Owned<X509, X509_free> one(PEM_read_bio_X509(in.get(), nullptr, nullptr, nullptr));
    if (!one || X509_STORE_add_cert(store.get(), one.get()) != 1) {
      break;
    }
    ++certificates;
  }
  ERR_clear_error();  // the end of the file is an error to OpenSSL
  return certificates > 0 ? std::move(store) : Certificates();
}

/// Empty if these bytes are no answer of an authority, or more than one.
Response responseOf(const std::string& answer) {
  const auto* bytes = reinterpret_cast<const unsigned char*>(answer.data());
  const unsigned char* const end = bytes + answer.size();
  Response response(d2i_TS_RESP(nullptr, &bytes, static_cast<long>(answer.size())));
  ERR_clear_error();
  return bytes == end ? std::move(response) : Response();
}

std::string utf8Of(const ASN1_STRING* words) {
  unsigned char* bytes = nullptr;
  const int size = words == nullptr ? -1 : ASN1_STRING_to_UTF8(&bytes, words);
  std::string text =
      size < 0 ? std::string() : std::string(reinterpret_cast<char*>(bytes), static_cast<std::size_t>(size));
  OPENSSL_free(bytes);
  return plainLine(text, kShown);
}

/// Throws unless the authority granted the stamp.
void requireGranted(TS_RESP* response) {
  const TS_STATUS_INFO* status = TS_RESP_get_status_info(response);
  const std::int64_t code = ASN1_INTEGER_get(TS_STATUS_INFO_get0_status(status));
  if (code == TS_STATUS_GRANTED || code == TS_STATUS_GRANTED_WITH_MODS) {
    if (TS_RESP_get_token(response) == nullptr || TS_RESP_get_tst_info(response) == nullptr) {
      refuseStamp(Text::tr("the answer contains no time stamp"));
    }
    return;
  }
  const STACK_OF(ASN1_UTF8STRING)* said = TS_STATUS_INFO_get0_text(status);
  const std::string words = said != nullptr && sk_ASN1_UTF8STRING_num(said) > 0
                                ? utf8Of(sk_ASN1_UTF8STRING_value(said, 0))
                                : std::string();
  refuseStamp(words.empty() ? Text::tr("the authority gave no time stamp")
                            : Text::tr("the authority gave no time stamp: %1", words));
}

std::int64_t timeOf(TS_RESP* response) {
  std::tm parts{};
  const ASN1_GENERALIZEDTIME* time = TS_TST_INFO_get_time(TS_RESP_get_tst_info(response));
  if (time == nullptr || ASN1_TIME_to_tm(time, &parts) != 1) {
    ERR_clear_error();
    refuseStamp(Text::tr("the time stamp has no time"));
  }
  const Owned<ASN1_TIME, ASN1_TIME_free> begin(ASN1_TIME_set(nullptr, 0));
  int days = 0;
  int seconds = 0;
  if (!begin || ASN1_TIME_diff(&days, &seconds, begin.get(), time) != 1) {
    refuseStamp(Text::tr("the time stamp has no time"));
  }
  return (static_cast<std::int64_t>(days) * 86'400 + seconds) * kSecond_us;
}

std::string signerOf(TS_RESP* response) {
  const Owned<STACK_OF(X509), freeList> signers(PKCS7_get0_signers(TS_RESP_get_token(response), nullptr, 0));
  if (!signers || sk_X509_num(signers.get()) == 0) {
    return {};
  }
  X509_NAME* name = X509_get_subject_name(sk_X509_value(signers.get(), 0));
  for (const int part : {NID_commonName, NID_organizationName}) {
    const int place = X509_NAME_get_index_by_NID(name, part, -1);
    if (place >= 0) {
      return utf8Of(X509_NAME_ENTRY_get_data(X509_NAME_get_entry(name, place)));
    }
  }
  return {};
}

/// Says in words what OpenSSL found wrong.
[[noreturn]] void refuseFlaw() {
  bool nonce = false;
  bool imprint = false;
  bool certificate = false;
  for (unsigned long code = ERR_get_error(); code != 0; code = ERR_get_error()) {
    const int reason = ERR_GET_LIB(code) == ERR_LIB_TS ? ERR_GET_REASON(code) : 0;
    nonce = nonce || reason == TS_R_NONCE_MISMATCH || reason == TS_R_NONCE_NOT_RETURNED;
    imprint = imprint || reason == TS_R_MESSAGE_IMPRINT_MISMATCH;
    certificate = certificate || reason == TS_R_CERTIFICATE_VERIFY_ERROR;
  }
  if (nonce) {
    refuseStamp(Text::tr("the time stamp answers another question"));
  }
  if (imprint) {
    refuseStamp(Text::tr("the time stamp is of another text"));
  }
  if (certificate) {
    refuseStamp(Text::tr("the time stamp is signed by an authority that this centre does not trust"));
  }
  refuseStamp(Text::tr("the signature of the time stamp is not genuine"));
}

TimeStamp checked(const std::string& answer, TS_REQ* request, bool nonce, const std::string& certificates) {
  const Response response = responseOf(answer);
  if (!response) {
    refuseStamp(Text::tr("the answer is no time stamp"));
  }
  requireGranted(response.get());
  const TimeStamp stamp{timeOf(response.get()), signerOf(response.get())};
  Certificates store = storeOf(certificates);
  if (!store) {
    requireCertificates(certificates, {});
  }
  // The certificates count as they were then: a stamp outlives them.
  X509_VERIFY_PARAM_set_time(X509_STORE_get0_param(store.get()),
                             static_cast<std::time_t>(stamp.utc_us / kSecond_us));
  const Owned<TS_VERIFY_CTX, TS_VERIFY_CTX_free> check(TS_REQ_to_TS_VERIFY_CTX(request, nullptr));
  if (!check) {
    throw ContractError("OpenSSL cannot check a time stamp");
  }
  TS_VERIFY_CTX_add_flags(check.get(), TS_VFY_SIGNATURE | (nonce ? TS_VFY_NONCE : 0));
  if (!nonce) {
    TS_VERIFY_CTX_set_flags(check.get(), TS_VFY_VERSION | TS_VFY_IMPRINT | TS_VFY_SIGNATURE);
  }
  TS_VERIFY_CTX_set_store(check.get(), store.release());  // owns it from here
  ERR_clear_error();
  if (TS_RESP_verify_response(check.get(), response.get()) != 1) {
    refuseFlaw();
  }
  return stamp;
}

}  // namespace

std::string stampQuery(const std::string& text) {
  const Request request = requestFor(text);
  std::array<unsigned char, kNonce_bytes> random{};
  const bool drawn = RAND_bytes(random.data(), kNonce_bytes) == 1;
  random.front() = static_cast<unsigned char>((random.front() & 0x7F) | 0x40);  // positive, full length
  const Owned<BIGNUM, BN_free> number(BN_bin2bn(random.data(), kNonce_bytes, nullptr));
  const Owned<ASN1_INTEGER, ASN1_INTEGER_free> nonce(number ? BN_to_ASN1_INTEGER(number.get(), nullptr)
                                                            : nullptr);
  if (!drawn || !nonce || TS_REQ_set_nonce(request.get(), nonce.get()) != 1) {
    throw ContractError("OpenSSL made no nonce for a time stamp");
  }
  unsigned char* bytes = nullptr;
  const int size = i2d_TS_REQ(request.get(), &bytes);
  const Owned<unsigned char, freeBytes> kept(bytes);
  if (size <= 0) {
    throw ContractError("OpenSSL wrote no question for a time stamp");
  }
  return {reinterpret_cast<char*>(bytes), static_cast<std::size_t>(size)};
}

std::string stampedHash(const std::string& text) {
  std::string hex;
  for (const unsigned char byte : hashOf(text)) {
    hex += "0123456789abcdef"[byte >> 4U];
    hex += "0123456789abcdef"[byte & 15U];
  }
  return hex;
}

bool isStampAnswer(const std::string& bytes) {
  return responseOf(bytes) != nullptr;
}

TimeStamp stampIn(const std::string& answer, const std::string& query, const std::string& certificates) {
  const auto* bytes = reinterpret_cast<const unsigned char*>(query.data());
  const Request request(d2i_TS_REQ(nullptr, &bytes, static_cast<long>(query.size())));
  if (!request) {
    throw ContractError("not a question for a time stamp");
  }
  return checked(answer, request.get(), true, certificates);
}

TimeStamp keptStamp(const std::string& answer, const std::string& text, const std::string& certificates) {
  return checked(answer, requestFor(text).get(), false, certificates);
}

void requireCertificates(const std::string& pem, const std::string& where) {
  if (!storeOf(pem)) {
    refuse(Text::tr("contains no certificate"), where,
           Text::tr("Give the certificate of the time stamp authority's root, as PEM"));
  }
}

}  // namespace torsio
