#include <catch2/catch.hpp>

#include "tests/cli/refusal.h"

namespace {

const std::string csv = "lambda_nm,-50,-49\n500,1,2\n510,3,4\n";

Outcome validate(const Scratch& folder, const std::string& max_error) {
  return folder.shedlight("validate a.csv b.csv --max-error " + max_error);
}

}  // namespace

TEST_CASE("a validation passes up to its limit and fails above it", "[cli][validate]") {
  const Scratch folder;
  folder.write("a.csv", csv);
  folder.write("b.csv", "lambda_nm,-50,-49\n500,1,2\n510,3.5,4\n");
  for (const std::string limit : {"0.5", "0.51", "1e9"}) {
    const Outcome outcome = validate(folder, limit);
    INFO(limit << ": " << outcome.out << outcome.err);
    CHECK(outcome.exit_code == 0);
    CHECK_THAT(outcome.out, Catch::Contains("passed"));
  }
  for (const std::string limit : {"0.49", "1e-9", "0"}) {
    const Outcome outcome = validate(folder, limit);
    INFO(limit << ": " << outcome.out << outcome.err);
    CHECK(outcome.exit_code == 1);
    // Where, what and how much was allowed.
    CHECK_THAT(outcome.out, Catch::Contains("FAILED") && Catch::Contains("510") &&
                                Catch::Contains("-50") && Catch::Contains("0.5") &&
                                Catch::Contains("3.5"));
  }
}

TEST_CASE("equal responses pass with a limit of zero", "[cli][validate]") {
  const Scratch folder;
  folder.write("a.csv", csv);
  folder.write("b.csv", csv);
  CHECK(validate(folder, "0").exit_code == 0);
}

TEST_CASE("a deviation of either sign fails", "[cli][validate]") {
  const Scratch folder;
  folder.write("a.csv", csv);
  for (const std::string value : {"2.9", "3.1"}) {
    folder.write("b.csv", "lambda_nm,-50,-49\n500,1,2\n510," + value + ",4\n");
    CHECK(validate(folder, "0.01").exit_code == 1);
  }
}

TEST_CASE("a cell that is no number fails a validation, and is named", "[cli][validate]") {
  const Scratch folder;
  folder.write("good.csv", csv);
  for (const std::string nan : {"nan", "NaN", "-nan", "inf", "-inf"}) {
    folder.write("bad.csv", "lambda_nm,-50,-49\n500,1,2\n510," + nan + ",4\n");
    const Outcome outcome = folder.shedlight("validate bad.csv good.csv --max-error 1e300");
    INFO(nan << ": " << outcome.out << outcome.err);
    CHECK(outcome.exit_code == 1);
    CHECK_THAT(outcome.out, Catch::Contains("FAILED") && Catch::Contains("at 510 nm, -50 deg"));
    // A reference must be sound.
    check_refused(folder, "validate good.csv bad.csv --max-error 1e300", 3,
                  {"bad.csv", "line 3", "column 2", nan});
    check_refused(folder, "validate bad.csv bad.csv --max-error 1e300", 3, {"bad.csv"});
  }
}

TEST_CASE("one cell of a sweep changed by 1 % fails, and is named", "[cli][validate]") {
  const Scratch folder;
  folder.write("good.csv", "lambda_nm,-50,-49\n500,1,2\n510,0.3,4\n");
  folder.write("bad.csv", "lambda_nm,-50,-49\n500,1,2\n510,0.303,4\n");
  const Outcome outcome = folder.shedlight("validate bad.csv good.csv --max-error 1e-6");
  INFO(outcome.out << outcome.err);
  CHECK(outcome.exit_code == 1);
  CHECK_THAT(outcome.out, Catch::Contains("at 510 nm, -50 deg (0.303 against 0.3)"));
}

TEST_CASE("two rows swapped fail a validation, with and without their labels", "[cli][validate]") {
  const Scratch folder;
  folder.write("good.csv", csv);
  folder.write("values.csv", "lambda_nm,-50,-49\n500,3,4\n510,1,2\n");
  folder.write("rows.csv", "lambda_nm,-50,-49\n510,3,4\n500,1,2\n");
  folder.write("long.csv",
               "lambda_nm,theta_r_deg,value\n510,-50,3\n510,-49,4\n500,-50,1\n500,-49,2\n");
  for (const auto& [file, named] :
       {std::pair("values.csv", "at 500 nm, -50 deg"),
        std::pair("rows.csv", "lambda_nm 510 stands where good.csv has 500"),
        std::pair("long.csv", "lambda_nm 510 stands where good.csv has 500")}) {
    const Outcome outcome =
        folder.shedlight(std::string("validate ") + file + " good.csv --max-error 1.5");
    INFO(file << ": " << outcome.out << outcome.err);
    CHECK(outcome.exit_code == 1);
    CHECK_THAT(outcome.out, Catch::Contains("FAILED") && Catch::Contains(named));
  }
}

TEST_CASE("what is no response is refused, not judged", "[cli][validate]") {
  const Scratch folder;
  folder.write("good.csv", csv);
  for (const std::string text :
       {"", "wavelength,1\n", "lambda_nm,-50,-49\n500,1\n510,3,4\n",
        "lambda_nm,-50,-49\n500,1,abc\n510,3,4\n", "lambda_nm,-50,-49\nnan,1,2\n510,3,4\n"}) {
    folder.write("bad.csv", text);
    check_refused(folder, "validate bad.csv good.csv --max-error 1e9", 3, {"bad.csv"});
  }
}

TEST_CASE("axes written with fewer digits are the same axes", "[cli][validate]") {
  const Scratch folder;
  folder.write("a.csv", "lambda_nm,-50.1,-49.1\n500,1,2\n510,3,4\n");
  folder.write("b.csv", "lambda_nm,-50.1000001,-49.1\n500.000001,1,2\n510,3,4\n");
  CHECK(validate(folder, "0").exit_code == 0);
  folder.write("b.csv", "lambda_nm,-50.10001,-49.1\n500,1,2\n510,3,4\n");
  check_refused(folder, "validate a.csv b.csv --max-error 1e9", 3, {"a.csv", "b.csv", "axes"});
}

TEST_CASE("responses on different axes are not compared", "[cli][validate]") {
  const Scratch folder;
  folder.write("a.csv", csv);
  for (const std::string other :
       {"lambda_nm,-50,-48\n500,1,2\n510,3,4\n", "lambda_nm,-50,-49\n500,1,2\n511,3,4\n",
        "lambda_nm,-50,-49\n500,1,2\n", "lambda_nm,-50\n500,1\n510,3\n"}) {
    folder.write("b.csv", other);
    check_refused(folder, "validate a.csv b.csv --max-error 1e9", 3, {"a.csv", "b.csv", "axes"});
  }
}

TEST_CASE("a limit that is negative or no number is refused", "[cli][validate]") {
  const Scratch folder;
  folder.write("a.csv", csv);
  folder.write("b.csv", csv);
  for (const std::string limit : {"-1", "nan", "inf", "one", "1nm"})
    check_refused(folder, "validate a.csv b.csv --max-error " + limit, 2, {"--max-error", limit});
}

TEST_CASE("the layouts of a response are valid against each other", "[cli][validate]") {
  const Scratch folder;
  folder.write("a.csv", csv);
  folder.write("b.csv",
               "lambda_nm,theta_r_deg,value\n500,-50,1\n500,-49,2\n510,-50,3\n510,-49,4\n");
  CHECK(validate(folder, "0").exit_code == 0);
}

TEST_CASE("the program checks itself", "[cli][validate]") {
  const Scratch folder;
  const Outcome outcome = folder.shedlight("validate --self");
  INFO(outcome.out << outcome.err);
  CHECK(outcome.exit_code == 0);
  CHECK(outcome.err == "");
  for (const std::string method : {"direct", "auto", "chebyshev", "taylor", "pq"})
    CHECK_THAT(outcome.out, Catch::Contains(" " + method + " "));
  CHECK_THAT(outcome.out, Catch::Contains("Gaussian") && Catch::Contains("energy") &&
                              Catch::Contains("reciprocity") && Catch::Contains(" 0 FAILED"));
  CHECK_THAT(folder.shedlight("validate --self --json").out,
             Catch::StartsWith("[") && Catch::Contains("\"verdict\": \"ok\""));
}

TEST_CASE("what belongs to a comparison of files is refused beside --self", "[cli][validate]") {
  const Scratch folder;
  folder.write("a.csv", csv);
  check_refused(folder, "validate a.csv --self", 2, {"response", "--self"});
  check_refused(folder, "validate a.csv a.csv --self", 2, {"response", "--self"});
  check_refused(folder, "validate --self --max-error 1", 2, {"--max-error", "--self"});
  check_refused(folder, "validate --self --exposure 1", 2, {"--exposure", "--self"});
  check_refused(folder, "validate a.csv a.csv --max-error 1 --json", 2, {"--json", "--self"});
}
