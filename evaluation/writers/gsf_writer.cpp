#include "evaluation/writers/gsf_writer.h"

#include <bit>
#include <cstdint>

#include "brdf/error.h"
#include "evaluation/writers/title.h"

namespace evaluation {

std::string to_gsf(const brdf::HeightField& field, const std::string& title) {
  std::string gsf = "Gwyddion Simple Field 1.0\nXRes = " + std::to_string(field.cols()) +
                    "\nYRes = " + std::to_string(field.rows()) +
                    "\nXReal = " + brdf::text(brdf::Length::um(field.width_um()).m()) +
                    "\nYReal = " + brdf::text(brdf::Length::um(field.height_um()).m()) +
                    "\nXYUnits = m\nZUnits = m\nTitle = " + in_one_line(title) + "\n";
  gsf.append(4 - gsf.size() % 4, '\0');
  gsf.reserve(gsf.size() + 4 * static_cast<std::size_t>(field.heights_um().size()));
  for (const double height_um : field.heights_um().reshaped<Eigen::RowMajor>()) {
    const auto bits =
        std::bit_cast<std::uint32_t>(static_cast<float>(brdf::Length::um(height_um).m()));
    for (int shift = 0; shift < 32; shift += 8) gsf += static_cast<char>(bits >> shift & 0xFF);
  }
  return gsf;
}

}  // namespace evaluation
