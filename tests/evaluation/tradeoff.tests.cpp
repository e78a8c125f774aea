#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "evaluation/peak_memory.h"
#include "evaluation/tradeoff/tradeoff.h"
#include "tests/support/is_error.h"
#include "tests/support/surfaces.h"
#include "tests/support/worst_error.h"

using brdf::Angle;
using brdf::Length;
using brdf::SurfaceModel;
using evaluation::TradeoffRow;
using evaluation::Trial;

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

/// 8 periods of 2.5 um in one row.
brdf::HeightField blaze() {
  return sampled(1, 80, 0.25, 0.25, [](double x, double) {
    const double turns = x / 2.5 + 0.013;
    return 0.4 * (turns - std::floor(turns));
  });
}

evaluation::Axis axis(double first, double last, double step) {
  evaluation::Axis axis;
  for (int i = 0; first + i * step <= last + 1e-9; ++i) axis.values.push_back(first + i * step);
  return axis;
}

evaluation::TradeoffRequest request_of(const brdf::HeightField& field) {
  const evaluation::SweepRequest sweep{Angle::deg(75), Angle{}, Angle{}, axis(400, 700, 5),
                                       axis(-55, -35, 0.25)};
  return {sweep, &field, brdf::GaussianWindow(Length::um(5)), Length::um(2.5), 1, {}};
}

TradeoffRow row_of(double seconds, double error, SurfaceModel model = SurfaceModel::isolated) {
  TradeoffRow row;
  row.trial = {.method = "chebyshev", .model = model};
  row.time = {seconds / 4, 3 * seconds / 4};
  row.errors.worst = error;
  return row;
}

std::vector<std::string> sources_of(const std::vector<Trial>& trials) {
  std::vector<std::string> names;
  for (const Trial& trial : trials)
    if (!trial.sources.empty()) names.push_back(trial.sources);
  std::ranges::sort(names);
  return names;
}

}  // namespace

TEST_CASE("the settings of the sources are tried, each once and under its name", "[tradeoff]") {
  const brdf::HeightField field = blaze();
  evaluation::TradeoffRequest request = request_of(field);
  request.sweep.lambda_nm = axis(400, 700, 1);
  CHECK(sources_of(trials(request.scope(SurfaceModel::periodic, {}))) ==
        std::vector<std::string>{"20 terms", "25 terms", "3 x 3", "30 terms", "5 nm", "Nmin/Nmax"});
  CHECK(sources_of(trials(request.scope(SurfaceModel::replicated, {8, 8}))) ==
        std::vector<std::string>{"PQ linear", "PQ sinc"});
  CHECK(sources_of(trials(request.scope(SurfaceModel::isolated, {}))).empty());
  for (const Trial& trial : trials(request.scope(SurfaceModel::periodic, {}))) {
    if (trial.sources == "20 terms") {
      CHECK(trial.terms == 20);
      CHECK(trial.radius_sigma_f == 4);
    }
    // One and a half bins of 1 / 20 um, the longer side, at sigma_f = 1 / (2 pi 5 um).
    if (trial.sources == "3 x 3")
      CHECK(*trial.radius_sigma_f == Approx(1.5 / 20 * 2 * brdf::pi * 5));
    if (trial.sources == "5 nm") CHECK(trial.lambda_step_nm == 5);
    if (trial.sources == "Nmin/Nmax") CHECK(trial.cells == evaluation::Cells::orders);
  }
}

TEST_CASE("every method that has a surface model is tried on it", "[tradeoff]") {
  const brdf::HeightField field = blaze();
  const evaluation::TradeoffRequest request = request_of(field);
  for (const SurfaceModel model :
       {SurfaceModel::isolated, SurfaceModel::periodic, SurfaceModel::replicated})
    for (const evaluation::Method& method : evaluation::methods()) {
      const bool has_model = std::ranges::find(method.models, model) != method.models.end();
      const std::vector<Trial> all = trials(request.scope(model, {}));
      INFO(method.name);
      CHECK(has_model == std::ranges::any_of(
                             all, [&](const Trial& trial) { return trial.method == method.name; }));
    }
}

TEST_CASE("coarser wavelengths are tried only where they are coarser", "[tradeoff]") {
  const auto steps = [](const evaluation::Axis& lambda_nm) {
    std::vector<double> found;
    for (const Trial& trial : evaluation::trials({SurfaceModel::isolated, {}, 2, lambda_nm, {}}))
      if (trial.lambda_step_nm) found.push_back(*trial.lambda_step_nm);
    return found;
  };
  CHECK(steps(axis(400, 700, 1)) == std::vector<double>{5, 10, 25, 100});
  CHECK(steps(axis(400, 700, 5)) == std::vector<double>{10, 25, 100});
  CHECK(steps(axis(400, 424, 1)) == std::vector<double>{5, 10});
  CHECK(steps(axis(400, 400, 1)).empty());
  const evaluation::SweepRequest thin =
      evaluation::thinned({Angle{}, Angle{}, Angle{}, axis(400.3, 430.3, 0.1), axis(0, 1, 1)}, 10);
  REQUIRE(thin.lambda_nm.size() == 4);
  CHECK(thin.lambda_nm[3] == Approx(430.3));
}

TEST_CASE("the error of a trial is that of its amplitude against the direct sum", "[tradeoff]") {
  const brdf::HeightField field = blaze();
  const evaluation::TradeoffRequest request = request_of(field);
  const evaluation::TradeoffReference reference(request, SurfaceModel::periodic, {});
  // The reference is held to 1e-12 by its own bound; its audit may say no more than that.
  CHECK(reference.audited_error() <= 1e-12);
  Trial trial{.method = "taylor", .model = SurfaceModel::periodic};
  trial.terms = 12;
  trial.radius_sigma_f = 4;
  const evaluation::TrialRun run = reference.run(trial);
  const evaluation::TrialErrors errors = reference.errors(trial, run);

  const brdf::Surface surface = request.surface(SurfaceModel::periodic, {});
  const auto bounds = evaluation::bounds_of(request.sweep, 1e-6);
  const auto exact = evaluation::method_named("direct").plan(surface, bounds, {});
  const auto tried = evaluation::method_named("taylor").plan(surface, bounds, trial.settings(1));
  double worst = 0, squares = 0;
  for (std::size_t row = 0; row < request.sweep.lambda_nm.size(); ++row) {
    const std::vector<brdf::Query> queries = queries_of_row(request.sweep, row);
    std::vector<std::complex<double>> a(queries.size()), b(queries.size());
    exact->evaluate(queries, a);
    tried->evaluate(queries, b);
    for (std::size_t i = 0; i < a.size(); ++i) {
      const double error = std::abs(a[i] - b[i]);
      REQUIRE(std::isfinite(error));
      worst = std::max(worst, error);
      squares += error * error;
    }
  }
  CHECK(worst > 1e-6);  // there is something to find
  // Two references that differ by 1e-12.
  CHECK(std::abs(errors.worst - worst) <= 2e-12);
  CHECK(errors.rms ==
        Approx(std::sqrt(squares / static_cast<double>(request.sweep.cells()))).epsilon(1e-6));
  CHECK(errors.findings.peak_angle_deg.value() < 0.1);
  CHECK(errors.findings.period_relative.value() < 1e-2);
  CHECK(errors.findings.ciede2000.value() < 1);
}

TEST_CASE("a method that goes through every pixel is timed on a sample", "[tradeoff]") {
  // 1e6 pixels: some hundred queries of the direct sum take half a second.
  const brdf::HeightField field = sampled(
      1000, 1000, 0.05, 0.05, [](double x, double) { return 0.1 * std::sin(2 * brdf::pi * x); });
  const evaluation::TradeoffRequest request = request_of(field);
  const evaluation::TradeoffReference reference(request, SurfaceModel::isolated, {});
  for (const evaluation::Method& method : evaluation::methods()) {
    if (std::ranges::find(method.models, SurfaceModel::isolated) == method.models.end()) continue;
    Trial trial{.method = std::string(method.name)};
    trial.tolerance = 1e-6;
    const evaluation::TrialRun run = reference.run(trial);
    INFO(method.name << ": " << run.timed_cells);
    CHECK((run.timed_cells < request.sweep.cells()) == (method.name == "direct"));
    CHECK(run.timed_cells > 100);
    CHECK(run.amplitudes.size() == run.timed_cells);
    // The direct sum's own rounding, and the reference's bound.
    CHECK(reference.errors(trial, run).worst <= (method.name == "direct" ? 3e-12 : 1.1e-6));
  }
}

TEST_CASE("rows between coarser wavelengths are taken linearly", "[tradeoff]") {
  const brdf::HeightField field = blaze();
  evaluation::TradeoffRequest request = request_of(field);
  request.sweep.lambda_nm = axis(500, 520, 5);
  const evaluation::TradeoffReference reference(request, SurfaceModel::isolated, {});
  Trial trial{.method = "chebyshev"};
  trial.tolerance = 1e-9;
  trial.lambda_step_nm = 10;
  const double found = reference.errors(trial, reference.run(trial)).worst;

  const auto exact = evaluation::method_named("direct").plan(
      request.surface(SurfaceModel::isolated, {}), bounds_of(request.sweep, 1e-6), {});
  std::vector<std::vector<double>> power;
  for (std::size_t row = 0; row < 5; ++row) {
    const std::vector<brdf::Query> queries = queries_of_row(request.sweep, row);
    std::vector<std::complex<double>> a(queries.size());
    exact->evaluate(queries, a);
    power.emplace_back();
    for (const auto& value : a) power.back().push_back(std::norm(value));
  }
  WorstError worst;
  for (const std::size_t row : {1u, 3u})
    for (std::size_t i = 0; i < power[row].size(); ++i)
      worst.see(std::abs(std::sqrt((power[row - 1][i] + power[row + 1][i]) / 2) -
                         std::sqrt(power[row][i])));
  CHECK(worst.value() > 1e-3);
  // The trial's own tolerance, 1e-9, times a slope of the root that is at most some hundreds here.
  CHECK(std::abs(found - worst.value()) <= 1e-6);
}

TEST_CASE("cells beside the orders are an error as large as they are", "[tradeoff]") {
  const brdf::HeightField field = blaze();
  const evaluation::TradeoffRequest request = request_of(field);
  const evaluation::TradeoffReference reference(request, SurfaceModel::isolated, {});
  Trial all{.method = "chebyshev"};
  all.tolerance = 1e-6;
  Trial orders = all;
  orders.cells = evaluation::Cells::orders;
  const evaluation::TrialRun run = reference.run(orders);
  CHECK(run.timed_cells < request.sweep.cells());
  CHECK(reference.errors(orders, run).worst > 10 * reference.errors(all, reference.run(all)).worst);
}

TEST_CASE("rows that none beats in both time and error are the frontier", "[tradeoff]") {
  std::vector<TradeoffRow> rows{row_of(1, 1e-3),       row_of(2, 1e-6),
                                row_of(2, 1e-5),       row_of(3, 1e-5),
                                row_of(0.5, infinite), row_of(9, 1e-2, SurfaceModel::periodic),
                                row_of(0.1, 0)};
  rows[6].refused = "will not";
  mark_frontier(rows);
  std::vector<bool> marked;
  for (const TradeoffRow& row : rows) marked.push_back(row.on_frontier);
  CHECK(marked == std::vector<bool>{true, true, false, false, true, true, false});
}

TEST_CASE("a budget names the fastest that is accurate, the most accurate that is fast",
          "[tradeoff]") {
  std::vector<TradeoffRow> rows{row_of(1, 1e-3), row_of(2, 1e-6), row_of(4, 1e-9),
                                row_of(0.1, 1e-12, SurfaceModel::periodic), row_of(0.1, infinite)};
  const SurfaceModel isolated = SurfaceModel::isolated;
  CHECK(fastest_within(rows, isolated, {}, 1e-6) == 1u);
  CHECK(fastest_within(rows, isolated, {}, 0.9e-6) == 2u);
  CHECK(fastest_within(rows, isolated, {}, 1) == 0u);
  CHECK_FALSE(fastest_within(rows, isolated, {}, 1e-10));
  CHECK(most_accurate_within(rows, isolated, {}, 3) == 1u);
  CHECK(most_accurate_within(rows, isolated, {}, 4) == 2u);
  CHECK_FALSE(most_accurate_within(rows, isolated, {}, 0.01));
  CHECK(fastest_within(rows, SurfaceModel::periodic, {}, 1e-6) == 3u);
  rows[1].refused = "will not";
  CHECK(fastest_within(rows, isolated, {}, 1e-6) == 2u);
}

TEST_CASE("the errors of a trade-off do not depend on seed and threads", "[tradeoff]") {
  const brdf::HeightField field = blaze();
  evaluation::TradeoffRequest request = request_of(field);
  const std::vector models{SurfaceModel::isolated, SurfaceModel::periodic,
                           SurfaceModel::replicated};
  evaluation::TradeoffSchedule schedule;
  schedule.repeats = 1;
  const evaluation::Tradeoff first = tradeoff(request, models, {3, 3}, schedule);
  schedule.seed = 77;
  request.limits.threads = 2;
  const evaluation::Tradeoff second = tradeoff(request, models, {3, 3}, schedule);
  REQUIRE(first.rows.size() == second.rows.size());
  REQUIRE(first.references.size() == 5);  // the replicated surface also with 1 and 12 copies
  for (std::size_t i = 0; i < first.rows.size(); ++i) {
    INFO(i << " " << first.rows[i].trial.method);
    CHECK(first.rows[i].trial == second.rows[i].trial);
    CHECK(first.rows[i].errors.worst == second.rows[i].errors.worst);
    CHECK(first.rows[i].errors.rms == second.rows[i].errors.rms);
    CHECK(first.rows[i].refused == second.rows[i].refused);
  }
}

TEST_CASE("a tolerance asked for is met, or refused", "[tradeoff]") {
  const brdf::HeightField field = blaze();
  const evaluation::TradeoffRequest request = request_of(field);
  const std::vector models{SurfaceModel::isolated, SurfaceModel::periodic,
                           SurfaceModel::replicated};
  evaluation::TradeoffSchedule schedule;
  schedule.repeats = 1;
  std::size_t met = 0;
  for (const TradeoffRow& row : tradeoff(request, models, {2, 1}, schedule).rows) {
    if (!row.refused.empty() || !row.trial.tolerance || row.trial.lambda_step_nm ||
        row.trial.cells != evaluation::Cells::all)
      continue;
    INFO(row.trial.method << " " << *row.trial.tolerance);
    CHECK(row.errors.worst <= *row.trial.tolerance + 1e-12);
    ++met;
  }
  CHECK(met > 60);
}

TEST_CASE("a row of the table makes its trial again", "[tradeoff]") {
  const brdf::HeightField field = blaze();
  evaluation::TradeoffRequest request = request_of(field);
  std::vector<TradeoffRow> rows;
  for (const SurfaceModel model :
       {SurfaceModel::isolated, SurfaceModel::periodic, SurfaceModel::replicated})
    for (const Trial& trial : trials(request.scope(
             model, model == SurfaceModel::replicated ? brdf::Replicas{8, 3} : brdf::Replicas{}))) {
      TradeoffRow& row = rows.emplace_back();
      row.trial = trial;
    }
  rows.back().refused = "the tolerance, 1e-10,\nis too small";
  const std::string csv = to_csv(rows);
  for (std::size_t i = 0; i + 1 < rows.size(); ++i) {
    Trial expected = rows[i].trial;
    expected.sources = {};
    INFO(i << " " << expected.method);
    CHECK(evaluation::trial_from_csv(csv, "frontier.csv", i + 1) == expected);
  }
  CHECK_ERROR(evaluation::trial_from_csv(csv, "frontier.csv", rows.size()), brdf::Errc::bad_input,
              "was refused: the tolerance; 1e-10; is too small");
  CHECK_ERROR(evaluation::trial_from_csv(csv, "frontier.csv", rows.size() + 1),
              brdf::Errc::invalid_argument, "frontier.csv: row");
}

TEST_CASE("a table of a trade-off that was changed is refused", "[tradeoff]") {
  const std::string csv = to_csv(std::vector{row_of(1, 1e-3), row_of(2, 1e-6)});
  const auto changed = [&](const std::string& from, const std::string& to) {
    std::string text = csv;
    const std::size_t at = text.find(from);
    REQUIRE(at != std::string::npos);
    return text.replace(at, from.size(), to);
  };
  const auto refused = [](const std::string& text, const std::vector<std::string>& named) {
    INFO(text);
    for (const std::string& part : named)
      CHECK_ERROR(evaluation::trial_from_csv(text, "f.csv", 1), brdf::Errc::bad_input, part);
  };
  refused("", {"f.csv", "line 1"});
  refused(changed("row,", "line,"), {"f.csv", "line 1"});
  refused(changed("\n1,", "\n2,"), {"f.csv", "line 2"});
  refused(changed("chebyshev,", "magic,"), {"line 2", "magic"});
  refused(changed("isolated,", "flat,"), {"line 2", "flat"});
  refused(changed("isolated,,,,", "isolated,,,1.5,"), {"line 2", "column 6", "1.5"});
  refused(changed("isolated,,,,", "isolated,,,1e99,"), {"line 2", "column 6"});
  refused(changed("isolated,,,,,,", "isolated,,,,,cubic,"), {"line 2", "cubic"});
  refused(changed("isolated,,,,,,", "isolated,,,,,,nan"), {"line 2", "column 9", "nan"});
  refused(changed("isolated,,,,,,,", "isolated,,,,,,,-5"), {"line 2", "-5"});
  refused(changed(",all,", ",some,"), {"line 2", "some"});
  refused(changed(",all,", ",all"), {"line 2", "fields"});
}

TEST_CASE("memory that is touched is seen at its peak", "[tradeoff]") {
  const evaluation::PeakMemory memory;
  {
    std::vector<char> held(64 << 20, 'x');
    REQUIRE(held[held.size() / 2] == 'x');
  }
  if (!memory.bytes()) {
    WARN("this system does not tell its memory");
    return;
  }
  // Some pages of the allocator may have been resident before.
  CHECK(*memory.bytes() >= std::size_t{60} << 20);
  // Under sanitizers freed memory and shadow stay resident.
  CHECK(*memory.bytes() < std::size_t{256} << 20);
}
