// shedlight period: the grating period from the peak angles.
#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "apps/commands/commands.h"
#include "apps/console.h"
#include "apps/response_input.h"

namespace apps {
namespace {

struct PeriodOptions {
  ResponseOptions response;
  bool json = false;
};

/// "none", all of a few, or the number and the span of many.
std::string outliers_text(const evaluation::Json& lambdas_nm) {
  constexpr std::size_t few = 8;
  if (lambdas_nm.empty()) return "none";
  if (lambdas_nm.size() > few)
    return fmt::format("{} wavelengths between {} and {} nm; --json names them", lambdas_nm.size(),
                       lambdas_nm.front().get<double>(), lambdas_nm.back().get<double>());
  std::string names;
  for (const auto& lambda : lambdas_nm)
    names += (names.empty() ? "" : ", ") + evaluation::number_text(lambda.get<double>());
  return names + " nm";
}

std::string for_people(const evaluation::Json& result) {
  const auto number = [&](const char* key) { return result[key].get<double>(); };
  std::string text = fmt::format(
      "period          {:.3f} nm, standard error of the fit {:.3f} nm ({})\n"
      "order           {:+d}, {}; {} of {} wavelengths have a peak\n"
      "sources' way    {:.3f} nm mean, {:.3f} nm standard deviation over the wavelengths\n",
      number("period_nm"), number("std_error_nm"), result["status"].get<std::string>(),
      result["order"].get<int>(), result["side"].get<std::string>(),
      result["wavelengths_with_peak"].get<std::size_t>(), result["wavelengths"].get<std::size_t>(),
      number("source_mean_nm"), number("source_std_nm"));
  return text + "outliers        " + outliers_text(result["outliers"]) + "\n";
}

void run(const PeriodOptions& options) {
  const ResponseInput input = options.response.read();
  const std::vector<evaluation::Peak> peaks = input.peaks();
  const int order = input.search.order;
  const evaluation::PeriodFit fit = brdf::at_place(options.response.file, [&] {
    return fit_period(peaks, input.plane, order, input.angle_step_deg());
  });
  const evaluation::PeriodSpread spread = period_spread(peaks, input.plane, order);
  const bool converged = fit.status == evaluation::FitStatus::converged;

  evaluation::Json result;
  result["period_nm"] = fit.period_nm;
  result["std_error_nm"] = fit.std_error_nm;
  result["order"] = order;
  result["side"] = evaluation::side_of(order);
  result["outliers"] = fit.outlier_lambdas_nm;
  result["status"] = converged ? "converged" : "not converged: " + fit.message;
  result["source_mean_nm"] = spread.mean_nm;
  result["source_std_nm"] = spread.std_nm;
  result["wavelengths"] = peaks.size();
  result["wavelengths_with_peak"] = fit.residuals_deg.size();
  print(options.json ? result.dump(2) + "\n" : for_people(result));
  if (!converged)
    throw brdf::Error(brdf::Errc::not_attainable,
                      options.response.file + ": the fit did not converge: " + fit.message);
}

}  // namespace

void add_period(CLI::App& app) {
  auto options = std::make_shared<PeriodOptions>();
  CLI::App* period = app.add_subcommand("period", "Grating period fitted to the peak angles");
  period->footer(
      "The standard error is that of the fit: it does not hold the bias of the peaks nor the\n"
      "drift of a scan. Printed beside it: the sources' own estimate, the mean and standard\n"
      "deviation over the wavelengths of the period that each brightest angle gives.\n"
      "Example:\n  shedlight period R.csv --order 1 --json");
  options->response.add_to(period);
  period->add_flag("--json", options->json, "as JSON");
  period->callback([options] { run(*options); });
}

}  // namespace apps
