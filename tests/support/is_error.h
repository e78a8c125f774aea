// Matches a brdf::Error by its code and by what its message must name.
#pragma once

#include <catch2/catch.hpp>
#include <string>

#include "brdf/error.h"

class IsError : public Catch::MatcherBase<brdf::Error> {
 public:
  IsError(brdf::Errc code, std::string part) : code_(code), part_(std::move(part)) {}

  bool match(const brdf::Error& error) const override {
    return error.code() == code_ && std::string(error.what()).find(part_) != std::string::npos;
  }
  std::string describe() const override {
    return "has code " + std::to_string(static_cast<int>(code_)) + " and names '" + part_ + "'";
  }

 private:
  brdf::Errc code_;
  std::string part_;
};

#define CHECK_ERROR(expression, code, part) \
  CHECK_THROWS_MATCHES(expression, brdf::Error, IsError(code, part))
