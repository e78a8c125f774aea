// What the tests of text readers share: numbers that are heights in micrometres.
#pragma once

#include <catch2/catch.hpp>

#include "tests/support/damaged_files.h"

/// A pixel and a unit of a micrometre: heights are the numbers.
inline evaluation::HeightChoice plain(
    evaluation::MissingHeights missing = evaluation::MissingHeights::refuse) {
  evaluation::HeightChoice choice;
  choice.scale.pixel = {brdf::Length::um(1), brdf::Length::um(1)};
  choice.scale.height_unit = brdf::Length::um(1);
  choice.missing = missing;
  return choice;
}

inline brdf::HeightArray heights(const std::string& text,
                                 const evaluation::HeightChoice& choice = plain()) {
  return read_bytes(text, choice).field.heights_um();
}

inline brdf::HeightArray array(int rows, int cols, std::initializer_list<double> values) {
  brdf::HeightArray result(rows, cols);
  std::copy(values.begin(), values.end(), result.data());
  return result;
}

inline void check_heights(const std::string& text, const brdf::HeightArray& expected,
                          const evaluation::HeightChoice& choice = plain()) {
  INFO(text);
  const brdf::HeightArray read = heights(text, choice);
  REQUIRE(read.rows() == expected.rows());
  REQUIRE(read.cols() == expected.cols());
  CHECK((read == expected).all());
}
