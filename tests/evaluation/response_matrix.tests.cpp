#include "evaluation/response_matrix.h"

#include <catch2/catch.hpp>
#include <string>

#include "brdf/error.h"

namespace {

using evaluation::CsvLayout;
using evaluation::ResponseMatrix;

ResponseMatrix small_response() {
  ResponseMatrix response{{{380, 381.5}, 1}, {{-50, -49.95, -49.9}, 2}, {}};
  response.values.resize(2, 3);
  response.values << 0.1, 1.0 / 3, 1e-300, 2, 5e20, 0;
  return response;
}

/// The message with which a text is refused; empty where it is read.
std::string refusal(const std::string& csv) {
  try {
    evaluation::response_from_csv(csv, "R.csv");
  } catch (const brdf::Error& error) {
    CHECK(error.code() == brdf::Errc::bad_input);
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("a response survives both CSV layouts to the last bit", "[invariant]") {
  const ResponseMatrix response = small_response();
  for (const CsvLayout layout : {CsvLayout::matrix, CsvLayout::long_table}) {
    const std::string csv = to_csv(response, layout);
    const ResponseMatrix back = evaluation::response_from_csv(csv, "R.csv");
    CHECK(back.lambda_nm.values == response.lambda_nm.values);
    CHECK(back.theta_r_deg.values == response.theta_r_deg.values);
    CHECK((back.values == response.values).all());
    CHECK(to_csv(back, layout) == csv);
  }
}

TEST_CASE("the matrix layout is a row per wavelength with its axes as asked", "[golden]") {
  const std::string csv = to_csv(small_response(), CsvLayout::matrix);
  CHECK(csv ==
        "lambda_nm,-50.00,-49.95,-49.90\n"
        "380.0,0.1,0.3333333333333333,1e-300\n"
        "381.5,2,5e+20,0\n");
}

TEST_CASE("the long layout is a row per cell", "[golden]") {
  const std::string csv = to_csv(small_response(), CsvLayout::long_table);
  CHECK(csv.substr(0, csv.find("380.0,-49.95")) ==
        "lambda_nm,theta_r_deg,value\n380.0,-50.00,0.1\n");
}

TEST_CASE("carriage returns at the ends of lines are read", "[invariant]") {
  CHECK(refusal("lambda_nm,1,2\r\n380,0.5,0.25\r\n").empty());
}

TEST_CASE("a damaged CSV is refused with its place", "[invariant]") {
  using Catch::Matchers::Contains;
  CHECK_THAT(refusal("lambda,1,2\n380,1,2\n"), Contains("R.csv: line 1"));
  CHECK_THAT(refusal("lambda_nm\n380\n"), Contains("line 1"));
  CHECK_THAT(refusal("lambda_nm,1,2\n380,1\n"), Contains("line 2: 2 fields, the header has 3"));
  CHECK_THAT(refusal("lambda_nm,1,2\n380,1,nan\n"), Contains("line 2: column 3: \"nan\""));
  CHECK_THAT(refusal("lambda_nm,1,2\n380,1,inf\n"), Contains("not a finite number"));
  CHECK_THAT(refusal("lambda_nm,1,2\n380,1,0x1\n"), Contains("0x1"));
  CHECK_THAT(refusal("lambda_nm,1,2\n380,1,\n"), Contains("column 3"));
  CHECK_THAT(refusal("lambda_nm,2,1\n380,1,2\n"), Contains("does not increase"));
  CHECK_THAT(refusal("lambda_nm,1,2\n381,1,2\n380,1,2\n"), Contains("line 3"));
  CHECK_THAT(refusal("lambda_nm,1,2\n"), Contains("holds no rows"));
  const std::string head = "lambda_nm,theta_r_deg,value\n";
  CHECK_THAT(refusal(head + "380,1,5\n380,2,5\n381,1,5\n"), Contains("not complete"));
  CHECK_THAT(refusal(head + "380,1,5\n380,2,5\n381,1,5\n381,3,5\n"), Contains("not on the grid"));
  CHECK_THAT(refusal(head + "380,1,5\n380,2,5\n381,1,5\n382,1,5\n"), Contains("not complete"));
  CHECK_THAT(refusal(head + "380,1,5\n380,2,5\n381,1,5\n381,2,5\n381,3,5\n"),
             Contains("not on the grid"));
  CHECK_THAT(refusal(head + "380,1\n"), Contains("not 3"));
}
