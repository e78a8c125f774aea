#include <catch2/catch.hpp>

#include "tests/cli/gratings.h"
#include "tests/cli/tables.h"

namespace {

/// A folder with a field of four pixels, for sweeps of which only the axes matter.
class Axes {
 public:
  Axes() { folder_.prepare("synth flat --size 0.4um,0.1um --pixels 4,1 -o g.gsf"); }

  std::string csv(const std::string& theta_r, const std::string& lambda) const {
    const Outcome outcome = folder_.shedlight("sweep g.gsf --theta-i 10deg --theta-r " + theta_r +
                                              " --lambda " + lambda);
    INFO("--theta-r " << theta_r << " --lambda " << lambda << "\n" << outcome.err);
    CHECK(outcome.exit_code == 0);
    CHECK(outcome.err == "");
    return outcome.out;
  }
  Cells angles(const std::string& range) const {
    Cells header = table_of(csv(range, "900nm")).front();
    header.erase(header.begin());
    return header;
  }
  Cells wavelengths(const std::string& range) const {
    Cells first;
    const std::vector<Cells> table = table_of(csv("0deg", range));
    for (std::size_t i = 1; i < table.size(); ++i) first.push_back(table[i].front());
    return first;
  }

 private:
  Scratch folder_;
};

}  // namespace

TEST_CASE("axes keep the decimals asked for", "[cli][range]") {
  const Axes axes;
  const Cells fine = axes.angles("-50:-25:0.05deg");
  CHECK(fine.size() == 501);
  CHECK(fine[0] == "-50.00");
  CHECK(fine[1] == "-49.95");
  CHECK(fine[2] == "-49.90");
  CHECK(fine.back() == "-25.00");
  CHECK(axes.angles("-50:-48:1deg") == Cells{"-50", "-49", "-48"});
  CHECK(axes.angles("-0.5:0.5:0.5deg") == Cells{"-0.5", "0.0", "0.5"});
  CHECK(axes.wavelengths("900.1:900.3:0.1nm") == Cells{"900.1", "900.2", "900.3"});
  CHECK(axes.wavelengths("900:902:1.00nm") == Cells{"900.00", "901.00", "902.00"});
  CHECK(axes.wavelengths("1e3:1.2e3:1e2nm") == Cells{"1000", "1100", "1200"});
}

TEST_CASE("a single value is an axis of one", "[cli][range]") {
  const Axes axes;
  CHECK(axes.wavelengths("950nm") == Cells{"950"});
  CHECK(axes.wavelengths("950.50nm") == Cells{"950.50"});
  CHECK(axes.wavelengths("0.95um") == Cells{"950"});
  CHECK(axes.angles("-12.5deg") == Cells{"-12.5"});
  CHECK(axes.angles("10:10:1deg") == Cells{"10"});
}

TEST_CASE("the number of values is that of the whole steps up to the stop", "[cli][range]") {
  const Axes axes;
  CHECK(axes.angles("0:1:0.3deg") == Cells{"0.0", "0.3", "0.6", "0.9"});
  // (0.3 - 0) / 0.1 is 2.9999999999999996 in doubles, and still three whole steps.
  CHECK(axes.angles("0:0.3:0.1deg") == Cells{"0.0", "0.1", "0.2", "0.3"});
  CHECK(axes.angles("0:0.29:0.1deg") == Cells{"0.00", "0.10", "0.20"});
  CHECK(axes.angles("0:5:10deg") == Cells{"0"});
  CHECK(axes.wavelengths("900:1300:1nm").size() == 401);
  CHECK(axes.angles("-15:0:0.01deg").size() == 1501);
}

TEST_CASE("an angle in radians has its whole steps too", "[cli][range]") {
  const Axes axes;
  CHECK(axes.angles("-0.3:0:0.1rad").size() == 4);
  const Cells one = axes.angles("0.5rad");
  REQUIRE(one.size() == 1);
  CHECK(value_of(one[0]) == Approx(28.64788975654116).epsilon(1e-14));
}

TEST_CASE("the unit of a range does not show in the file", "[cli][range]") {
  const Axes axes;
  const std::string nm = axes.csv("-5:5:1deg", "900:1300:1nm");
  CHECK(axes.csv("-5:5:1deg", "0.9:1.3:0.001um") == nm);
  CHECK(axes.csv("-5:5:1deg", "900nm:1300nm:1nm") == nm);
  CHECK(axes.csv("-5:5:1deg", "0.9um:1300nm:1nm") == nm);
  CHECK(axes.csv("-5deg:5deg:1deg", "0.0009:0.0013:0.000001mm") == nm);
  CHECK(axes.csv("-5:5:1deg", "900.1:900.3:0.1nm") ==
        axes.csv("-5:5:1deg", "0.9001:0.9003:0.0001um"));
}
