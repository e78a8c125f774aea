#include "apps/plot.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <gnuplot-iostream.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <sstream>
#include <tuple>

#include "brdf/error.h"
#include "brdf/grating_equation.h"
#include "evaluation/readers/file_bytes.h"

extern char** environ;

namespace apps {
namespace {

namespace fs = std::filesystem;
using brdf::Errc;
using brdf::Error;
using evaluation::Peak;

/// A folder of its own for script and data, removed at the end.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::string name = (fs::temp_directory_path() / "shedlight-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr)
      throw Error(Errc::cannot_write, name + ": cannot be made: " + std::strerror(errno));
    path_ = name;
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  ~TemporaryFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  std::string file(const std::string& name) const { return (path_ / name).string(); }

 private:
  fs::path path_;
};

/// Text as a gnuplot string expression. In single quotes nothing is special but the quote itself;
/// gnuplot 5.4 misreads runs of doubled quotes, so each is joined on in double quotes.
std::string quoted(const std::string& text) {
  std::string result = "'";
  for (const char c : text) {
    if (c == '\'')
      result += "'.\"'\".'";
    else
      result += c == '\n' ? ' ' : c;
  }
  return result + "'";
}

void run_gnuplot(const std::string& script, const std::string& log) {
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, log.c_str(),
                                   O_WRONLY | O_CREAT | O_TRUNC, 0600);
  posix_spawn_file_actions_adddup2(&actions, STDOUT_FILENO, STDERR_FILENO);
  std::string name = "gnuplot", defaults = "-d", file = script;
  char* arguments[] = {name.data(), defaults.data(), file.data(), nullptr};
  pid_t child = 0;
  const int failed = posix_spawnp(&child, "gnuplot", &actions, nullptr, arguments, environ);
  posix_spawn_file_actions_destroy(&actions);
  if (failed != 0)
    throw Error(Errc::cannot_write, std::string("gnuplot cannot be started (") +
                                        std::strerror(failed) +
                                        "); pictures need it: apt-get install gnuplot-nox");
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  if (WIFEXITED(status) && WEXITSTATUS(status) == 0) return;
  std::stringstream said;
  said << std::ifstream(log).rdbuf();
  throw Error(Errc::cannot_write, "gnuplot failed: " + said.str());
}

/// The heat map on a logarithmic scale: four decades below the maximum, darker cells at its end.
std::vector<std::vector<double>> logarithmic(const evaluation::ResponseMatrix& response,
                                             double floor) {
  std::vector<std::vector<double>> rows;
  for (const auto& row : response.values.rowwise()) {
    std::vector<double>& values = rows.emplace_back();
    for (const double value : row) values.push_back(std::log10(std::max(value, floor)));
  }
  return rows;
}

/// The angles of the fitted period, per wavelength where the order is visible.
std::vector<std::pair<double, double>> fitted_curve(const ResponsePicture& picture) {
  std::vector<std::pair<double, double>> curve;
  for (const double lambda_nm : picture.response->lambda_nm.values)
    if (const auto angle =
            brdf::viewing_angle(picture.order, brdf::Length::nm(picture.fit->period_nm),
                                brdf::Length::nm(lambda_nm), picture.plane.theta_i))
      curve.emplace_back(picture.plane.light_side * angle->deg(), lambda_nm);
  return curve;
}

/// First value and step of an axis for gnuplot, which wants a step even for one value.
std::pair<double, double> grid(const evaluation::Axis& axis) {
  if (axis.size() < 2) return {axis.front(), 1.0};
  return {axis.front(), (axis.back() - axis.front()) / static_cast<double>(axis.size() - 1)};
}

/// Points for a plot command, in binary: as text they would keep six digits.
std::string series(Gnuplot& gp, const std::vector<std::pair<double, double>>& points,
                   const std::string& file) {
  return gp.binFile1d(points, "record", file);
}

void set_range(Gnuplot& gp, const char* name, const evaluation::Axis& axis) {
  const auto [first, step] = grid(axis);
  const double half = std::abs(step) / 2;
  gp << fmt::format("set {} [{:.17g}:{:.17g}]\n", name, first - half, axis.back() + half);
}

void heat_map(Gnuplot& gp, const ResponsePicture& picture, const TemporaryFolder& folder) {
  const evaluation::ResponseMatrix& response = *picture.response;
  const double brightest = response.values.maxCoeff();
  const double floor = brightest > 0 ? brightest * 1e-4 : 1e-300;
  const auto [x0, dx] = grid(response.theta_r_deg);
  const auto [y0, dy] = grid(response.lambda_nm);
  set_range(gp, "xrange", response.theta_r_deg);
  set_range(gp, "yrange", response.lambda_nm);
  gp << "set xlabel 'viewing angle theta_r [deg], positive on the "
     << (picture.plane.light_side > 0 ? "light''s side" : "side opposite to the light")
     << "'\nset ylabel 'wavelength [nm]'\n";
  gp << "set cblabel " << quoted("log10 of " + picture.value_label) << "\n";
  gp << fmt::format("set cbrange [{:.17g}:{:.17g}]\n", std::log10(floor),
                    std::log10(std::max(brightest, floor * 10)));
  gp << "plot " << gp.binFile2d(logarithmic(response, floor), "array", folder.file("map.bin"))
     << fmt::format(" origin=({:.17g},{:.17g}) dx={:.17g} dy={:.17g} with image notitle", x0, y0,
                    dx, dy);
  std::vector<std::pair<double, double>> points;
  for (const Peak& peak : picture.peaks)
    if (peak.theta_r_deg) points.emplace_back(*peak.theta_r_deg, peak.lambda_nm);
  if (!points.empty())
    gp << ", " << series(gp, points, folder.file("peaks.bin"))
       << " with points pt 7 ps 0.35 lc rgb 'black' title 'peak of each wavelength'";
  if (picture.fit) {
    const auto curve = fitted_curve(picture);
    if (!curve.empty())
      gp << ", " << series(gp, curve, folder.file("fit.bin"))
         << " with lines lw 2 dt 2 lc rgb '#0060ff' title "
         << quoted(fmt::format("grating equation, order {:+d}, d = {:.2f} nm", picture.order,
                               picture.fit->period_nm));
  }
  gp << "\n";
}

/// Period of each peak, with the fit and its outliers.
void period_panel(Gnuplot& gp, const ResponsePicture& picture, const TemporaryFolder& folder) {
  std::vector<std::pair<double, double>> periods;
  for (const Peak& peak : picture.peaks)
    if (peak.theta_r_deg)
      if (const auto d = period_nm(picture.plane, picture.order, peak.lambda_nm, *peak.theta_r_deg))
        periods.emplace_back(peak.lambda_nm, *d);
  const double d = picture.fit->period_nm, error = picture.fit->std_error_nm;
  gp << "set autoscale y\nset ylabel 'period of each peak [nm]'\nset xlabel 'wavelength [nm]'\n";
  set_range(gp, "xrange", picture.response->lambda_nm);
  gp << fmt::format("plot {:.17g} with lines lw 2 lc rgb '#0080c0' title ", d)
     << quoted(fmt::format("fit {:.2f} nm, standard error {:.2g} nm", d, error)) << ", "
     << series(gp, periods, folder.file("periods.bin"))
     << " with points pt 7 ps 0.5 lc rgb '#c04000' title 'period of each peak'\n";
}

}  // namespace

std::string draw_png(const ResponsePicture& picture) {
  const TemporaryFolder folder;
  const std::string png = folder.file("picture.png");
  const std::string script = folder.file("plot.gp");
  {
    Gnuplot gp(">" + script);
    gp << "set terminal pngcairo noenhanced size 1200," << (picture.fit ? 1150 : 800)
       << " font 'sans,13'\n";
    gp << "set output " << quoted(png) << "\n";
    // Perceptually ordered, dark to light; points and curve stand out on it.
    gp << "set palette defined (0 '#000004', 1 '#2c115f', 2 '#721f81', 3 '#b73779', 4 '#f1605d', "
          "5 '#feb078', 6 '#fcfdbf')\n";
    gp << "set key outside top center horizontal\nset tics out\n";
    if (picture.fit) gp << "set multiplot\nset origin 0,0.3\nset size 1,0.7\n";
    gp << "set title " << quoted(picture.title) << "\n";
    heat_map(gp, picture, folder);
    if (picture.fit) {
      gp << "set origin 0,0\nset size 1,0.3\nunset title\nunset colorbox\n";
      period_panel(gp, picture, folder);
      gp << "unset multiplot\n";
    }
    gp << "set output\n";
  }
  run_gnuplot(script, folder.file("gnuplot.log"));
  std::error_code ec;
  if (const auto size = fs::file_size(png, ec); ec || size == 0)
    throw Error(Errc::cannot_write, "gnuplot drew no picture");
  return evaluation::read_file_bytes(png);
}

}  // namespace apps
