#include <cmath>

#include "evaluation/period/ridges.h"
#include "evaluation/period_fit.h"

namespace evaluation {
namespace {

std::string text_of(const std::optional<double>& value) {
  return value ? number_text(*value) : "";
}

template <class List, class Text>
std::string joined(const List& list, Text text) {
  std::string all;
  for (const auto& item : list) all.append(all.empty() ? "" : ";").append(text(item));
  return all;
}

}  // namespace

std::string to_csv(const std::vector<Ridge>& ridges) {
  std::string csv =
      "number,order,side,period_nm,f_per_um,f_spread_per_um,strength,relative,contrast,"
      "width_per_um,window_widths,present,brightest,spans_nm,merged_with\n";
  for (std::size_t i = 0; i < ridges.size(); ++i) {
    const Ridge& ridge = ridges[i];
    const std::string spans = joined(ridge.spans, [](const WavelengthSpan& span) {
      return number_text(span.first_nm) + "-" + number_text(span.last_nm);
    });
    const std::string merged = joined(
        ridge.merged_with, [](const RidgeMerge& merge) { return std::to_string(merge.with + 1); });
    const std::string cells[] = {std::to_string(i + 1),
                                 ridge.order ? std::to_string(*ridge.order) : "",
                                 std::string(side_of(ridge.f_per_um > 0 ? 1 : -1)),
                                 number_text(ridge.period_nm),
                                 number_text(ridge.f_per_um),
                                 number_text(ridge.f_spread_per_um),
                                 number_text(ridge.strength),
                                 number_text(ridge.relative),
                                 std::isfinite(ridge.contrast) ? number_text(ridge.contrast) : "",
                                 text_of(ridge.width_per_um),
                                 text_of(ridge.window_widths),
                                 number_text(ridge.present),
                                 number_text(ridge.brightest),
                                 spans,
                                 merged};
    std::string row;
    for (const std::string& cell : cells) row.append(&cell == cells ? "" : ",").append(cell);
    csv.append(row).append("\n");
  }
  return csv;
}

}  // namespace evaluation
