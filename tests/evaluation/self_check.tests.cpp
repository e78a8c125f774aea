#include "evaluation/self_check.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <functional>
#include <set>

using evaluation::Amplitude;
using evaluation::CheckRow;
using evaluation::Method;
using evaluation::Verdict;

namespace {

using Change = std::function<std::complex<double>(std::complex<double>)>;

class ChangedAmplitude final : public Amplitude {
 public:
  ChangedAmplitude(std::unique_ptr<Amplitude> right, Change change)
      : right_(std::move(right)), change_(std::move(change)) {}
  void evaluate(std::span<const brdf::Query> queries,
                std::span<std::complex<double>> amplitudes) const override {
    right_->evaluate(queries, amplitudes);
    std::transform(amplitudes.begin(), amplitudes.end(), amplitudes.begin(), change_);
  }
  brdf::PlanReport report() const override { return right_->report(); }

 private:
  std::unique_ptr<Amplitude> right_;
  Change change_;
};

/// A method whose amplitudes are changed.
Method changed(const char* name, const Change& change) {
  Method method = evaluation::method_named(name);
  method.plan = [plan = method.plan, change](
                    const brdf::Surface& surface, const brdf::QueryBounds& bounds,
                    const evaluation::MethodSettings& settings) -> std::unique_ptr<Amplitude> {
    return std::make_unique<ChangedAmplitude>(plan(surface, bounds, settings), change);
  };
  return method;
}

std::set<std::string> failed(const Method& method) {
  std::set<std::string> names;
  for (const CheckRow& row : self_check(method))
    if (row.verdict == Verdict::failed) names.insert(row.subject);
  return names;
}

}  // namespace

TEST_CASE("every self-check of every method passes", "[self_check][oracle]") {
  for (const Method& method : evaluation::methods()) {
    const std::vector<CheckRow> rows = self_check(method);
    CHECK(rows.size() >= 10);
    for (const CheckRow& row : rows) {
      INFO(row.subject << ", " << row.range << ": " << row.worst << " against " << row.limit
                       << " at " << row.where);
      CHECK(row.verdict == Verdict::passed);
    }
  }
}

TEST_CASE("amplitudes a thousandth too large fail every closed form and the energy",
          "[self_check][invariant]") {
  const auto too_large = [](std::complex<double> a) { return 1.001 * a; };
  const std::set<std::string> names = failed(changed("direct", too_large));
  for (const char* name :
       {"flat patch: Gaussian lobe", "orders of a sinusoid: J_m(c H / 2)^2",
        "orders of a sawtooth: sampled sinc^2", "orders of a lamellar grating",
        "slits: sin(N x) / (N sin x)", "energy: sum over the frequencies of a tile",
        "energy: sum over the orders of a sinusoid", "a tilted plane is a tilted mirror"}) {
    INFO(name);
    CHECK(names.contains(name));
  }
}

TEST_CASE("conjugate amplitudes fail the identities of the phase", "[self_check][invariant]") {
  const auto conjugate = [](std::complex<double> a) { return std::conj(a); };
  const std::set<std::string> names = failed(changed("chebyshev", conjugate));
  CHECK(names == std::set<std::string>{"a constant height only turns the phase",
                                       "a translation only turns the phase"});
}

TEST_CASE("amplitudes that depend on the order of the queries fail reciprocity",
          "[self_check][invariant]") {
  int calls = 0;
  const auto drifting = [&calls](std::complex<double> a) { return a * (1 + 1e-6 * ++calls); };
  CHECK(failed(changed("taylor", drifting)).contains("reciprocity of abs(a)^2 and of f_r"));
}

TEST_CASE("amplitudes that are no numbers fail every check", "[self_check][invariant]") {
  const auto nothing = [](std::complex<double>) {
    return std::complex<double>(std::numeric_limits<double>::quiet_NaN());
  };
  const Method method = changed("pq", nothing);
  CHECK(failed(method).size() == self_check(method).size());
}
