// Properties held against ten thousand generated cases; a case that breaks one is made smaller.
#pragma once

#include <rapidcheck.h>

#include <catch2/catch.hpp>
#include <sstream>
#include <string>
#include <utility>

/// Fails with the smallest case found, and the seed that repeats it.
template <class Testable>
void check_property(const std::string& description, Testable testable) {
  rc::detail::TestMetadata metadata;
  metadata.id = metadata.description = description;
  rc::detail::TestParams parameters;
  parameters.seed = 20261129;
  parameters.maxSuccess = 10000;
  const auto result = rc::detail::checkTestable(std::move(testable), metadata, parameters);
  std::ostringstream said;
  rc::detail::printResultMessage(result, said);
  INFO(description << "\n" << said.str());
  REQUIRE(result.template is<rc::detail::SuccessResult>());
  CHECK(result.template get<rc::detail::SuccessResult>().numSuccess == parameters.maxSuccess);
}
