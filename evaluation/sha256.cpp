#include "evaluation/sha256.h"

#include <openssl/evp.h>

#include <array>
#include <stdexcept>

namespace evaluation {

struct Sha256::Context {
  EVP_MD_CTX* of_openssl = EVP_MD_CTX_new();
  ~Context() { EVP_MD_CTX_free(of_openssl); }
};

namespace {

void require(int succeeded) {
  if (succeeded != 1) throw std::runtime_error("SHA-256 is not available from libcrypto");
}

}  // namespace

Sha256::Sha256() : context_(std::make_unique<Context>()) {
  require(EVP_DigestInit_ex(context_->of_openssl, EVP_sha256(), nullptr));
}
Sha256::Sha256(Sha256&&) noexcept = default;
Sha256& Sha256::operator=(Sha256&&) noexcept = default;
Sha256::~Sha256() = default;

void Sha256::update(std::string_view bytes) {
  require(EVP_DigestUpdate(context_->of_openssl, bytes.data(), bytes.size()));
}

std::string Sha256::hex() {
  std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
  unsigned length = 0;
  require(EVP_DigestFinal_ex(context_->of_openssl, digest.data(), &length));
  static constexpr char digits[] = "0123456789abcdef";
  std::string hex;
  for (unsigned i = 0; i < length; ++i) {
    hex += digits[digest[i] >> 4];
    hex += digits[digest[i] & 15];
  }
  return hex;
}

std::string sha256_hex(std::string_view bytes) {
  Sha256 hash;
  hash.update(bytes);
  return hash.hex();
}

}  // namespace evaluation
