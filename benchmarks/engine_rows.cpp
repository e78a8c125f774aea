#include <cstdlib>
#include <functional>

#include "benchmarks/engine_runs.h"
#include "benchmarks/memory.h"
#include "benchmarks/rows.h"
#include "benchmarks/scenes.h"
#include "evaluation/readers/height_reader.h"

namespace benchmarks {

using brdf::SurfaceModel;

namespace {

constexpr SurfaceModel models[] = {SurfaceModel::periodic, SurfaceModel::isolated};

/// A scene, its surface model and what is said of them.
std::string label(const char* scene, SurfaceModel model, const char* what) {
  return format("%s %s %s", scene, model == SurfaceModel::periodic ? "periodic" : "isolated", what);
}

struct Compared {
  Samples plan_a, evaluate_a, total_a, plan_b, evaluate_b, total_b;
};

/// Times two runs in turn.
Compared in_turn(const std::function<EngineTimes()>& a, const std::function<EngineTimes()>& b,
                 int runs = repetitions) {
  Compared result;
  for (int i = 0; i < runs; ++i) {
    const EngineTimes of_a = a(), of_b = b();
    result.plan_a.add(of_a.plan_s);
    result.evaluate_a.add(of_a.evaluate_s);
    result.total_a.add(of_a.total_s());
    result.plan_b.add(of_b.plan_s);
    result.evaluate_b.add(of_b.evaluate_s);
    result.total_b.add(of_b.total_s());
  }
  return result;
}
}  // namespace

void memory_of_a_scan(RatioTable& table) {
  const std::string what = "memory of B in-plane above the input";
  const char* folder = std::getenv("SHEDLIGHT_REAL_DATA");
  if (folder == nullptr) return table.skipped(what, "SHEDLIGHT_REAL_DATA is not set");
  const auto before = resident_bytes();
  evaluation::HeightChoice choice;
  choice.scale.width = brdf::Length::um(patch_um);
  choice.scale.height_range = brdf::Length::nm(818.69);
  const auto scan = evaluation::read_heights(std::string(folder) + "/xenopeltis_65um.png", choice);
  const Queries queries = in_plane_sweep();
  Amplitudes amplitudes;
  const EngineTimes times =
      run_engine(lit(scan.field, SurfaceModel::isolated), queries, 1e-6, amplitudes);
  const auto peak = peak_resident_bytes();
  if (!before || !peak) return table.skipped(what, "no /proc/self/status");
  const double input = static_cast<double>(scan.field.heights_um().size()) * sizeof(double);
  table.at_most(
      what, (*peak - *before - input) / 1e6, (0.1 * input + 100e6) / 1e6, "MB",
      format("peak less start %.1f MB, input %.1f MB; plan %.1f ms, 144761 queries "
             "%.1f ms",
             (*peak - *before) / 1e6, input / 1e6, 1e3 * times.plan_s, 1e3 * times.evaluate_s));
}

void tolerances_and_threads(RatioTable& table) {
  const brdf::HeightField field = blazed(650);
  const Queries queries = in_plane_sweep();
  Amplitudes amplitudes;
  for (const SurfaceModel model : models) {
    const brdf::Surface surface = lit(field, model);
    const auto run = [&](double tolerance, Run how) {
      return
          [&, tolerance, how] { return run_engine(surface, queries, tolerance, amplitudes, how); };
    };
    const Compared fine = in_turn(run(1e-12, {}), run(1e-6, {}));
    table.at_most(label("A", model, "at 1e-12 against 1e-6, with the plan"),
                  fine.total_a.median() / fine.total_b.median(), 2.5, "x",
                  ms(fine.total_a) + " / " + ms(fine.total_b));
    // Others on the machine only ever make wall times longer: the least of many runs. Beside it the
    // processor time of plan and slower thread, which they hardly touch.
    const Compared wall =
        in_turn(run(1e-6, {1, Time::of_wall}), run(1e-6, {2, Time::of_wall}), 10 * repetitions);
    const Compared own = in_turn(run(1e-6, {1}), run(1e-6, {2}), 3 * repetitions);
    table.at_least(label("A", model, "with two threads against one, with the plan"),
                   wall.total_a.least() / wall.total_b.least(), 1.7, "x",
                   format("wall, least of %d: %.2f ms / %.2f ms, without the plan %.2f x; "
                          "processor time of the slower thread %.2f x, without the plan %.2f x",
                          10 * repetitions, 1e3 * wall.total_a.least(), 1e3 * wall.total_b.least(),
                          wall.evaluate_a.least() / wall.evaluate_b.least(),
                          own.total_a.median() / own.total_b.median(),
                          own.evaluate_a.median() / own.evaluate_b.median()));
  }
}

void query_rates(RatioTable& table) {
  const brdf::HeightField grating = blazed(650), small = blazed(256);
  const Queries in_plane = in_plane_sweep(), random = random_directions(1000000);
  Amplitudes amplitudes;
  for (const SurfaceModel model : models) {
    Samples plan_s, sweep_s, general_plan_s, general_s;
    for (int i = 0; i < repetitions; ++i) {
      const EngineTimes a = run_engine(lit(grating, model), in_plane, 1e-6, amplitudes);
      const EngineTimes c = run_engine(lit(small, model), random, 1e-6, amplitudes);
      plan_s.add(a.plan_s);
      sweep_s.add(a.evaluate_s);
      general_plan_s.add(c.plan_s);
      general_s.add(c.evaluate_s);
    }
    const auto millions = [](const Queries& queries, const Samples& times) {
      return static_cast<double>(queries.size()) / times.median() / 1e6;
    };
    table.at_least(label("A", model, "1e-6, queries per second and core, plan excluded"),
                   millions(in_plane, sweep_s), 25, "million/s",
                   ms(sweep_s) + ", plan " + ms(plan_s));
    table.at_least(label("C", model, "1e-6, the same, sorting included"),
                   millions(random, general_s), 10, "million/s",
                   ms(general_s) + ", plan " + ms(general_plan_s));
  }
}

void growth_with_the_patch(RatioTable& table) {
  const Queries in_plane = in_plane_sweep(), random = random_directions(1000000);
  struct Case {
    std::string name;
    Eigen::Index pixels;
    const Queries* queries;
  };
  Amplitudes amplitudes;
  for (const Case& scene : {Case{"A", 650, &in_plane}, Case{"C", 256, &random}}) {
    const brdf::HeightField once = blazed(scene.pixels);
    const brdf::HeightField twice = blazed(2 * scene.pixels, brdf::Length::nm(150), 2 * patch_um);
    const auto run = [&](const brdf::HeightField& field) {
      return [&] {
        return run_engine(lit(field, SurfaceModel::isolated), *scene.queries, 1e-6, amplitudes);
      };
    };
    const Compared times = in_turn(run(twice), run(once));
    table.at_most("patch side doubled, " + scene.name + ": plan",
                  times.plan_a.median() / times.plan_b.median(), 5, "x",
                  ms(times.plan_a) + " / " + ms(times.plan_b));
    table.at_most("patch side doubled, " + scene.name + ": time per query",
                  times.evaluate_a.median() / times.evaluate_b.median(), 1.2, "x",
                  ms(times.evaluate_a) + " / " + ms(times.evaluate_b));
  }
}

void growth_with_the_depth(RatioTable& table) {
  const brdf::HeightField shallow = blazed(650), deep = blazed(650, brdf::Length::um(1.5));
  const Queries queries = in_plane_sweep();
  const brdf::QueryBounds bounds = brdf::bounds_of(queries, 1e-6);
  Amplitudes amplitudes;
  const auto terms = [&](const brdf::HeightField& field) {
    return engine().explain(lit(field, SurfaceModel::periodic), bounds).terms;
  };
  const auto run = [&](const brdf::HeightField& field) {
    return
        [&] { return run_engine(lit(field, SurfaceModel::periodic), queries, 1e-6, amplitudes); };
  };
  const Compared times = in_turn(run(deep), run(shallow));
  const int of_deep = terms(deep), of_shallow = terms(shallow);
  table.at_most("A periodic, 1.5 um deep against 150 nm",
                times.total_a.median() / times.total_b.median(),
                static_cast<double>(of_deep) / of_shallow, "x",
                format("%d / %d terms; ", of_deep, of_shallow) + ms(times.total_a) + " / " +
                    ms(times.total_b));
}

}  // namespace benchmarks
