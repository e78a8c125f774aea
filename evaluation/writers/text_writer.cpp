#include "evaluation/writers/text_writer.h"

#include "evaluation/writers/title.h"

namespace evaluation {

std::string to_text(const brdf::HeightField& field, const std::string& title) {
  std::string text = "# Channel: " + in_one_line(title) +
                     "\n# Width: " + brdf::text(field.width_um()) +
                     " µm\n# Height: " + brdf::text(field.height_um()) + " µm\n# Value units: µm\n";
  const brdf::HeightArray& heights = field.heights_um();
  for (Eigen::Index row = 0; row < heights.rows(); ++row)
    for (Eigen::Index col = 0; col < heights.cols(); ++col)
      text.append(brdf::text(heights(row, col))).append(col + 1 < heights.cols() ? "\t" : "\n");
  return text;
}

}  // namespace evaluation
