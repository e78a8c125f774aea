#include "evaluation/stability.h"

#include <array>

#include "evaluation/stability/groups.h"

namespace evaluation {

std::span<const StabilityGroup> stability_groups() {
  static constexpr std::array groups{StabilityGroup{"orders", stability::order_rows},
                                     StabilityGroup{"phase series", stability::series_rows},
                                     StabilityGroup{"bare series", stability::bare_series_rows},
                                     StabilityGroup{"grazing", stability::grazing_rows},
                                     StabilityGroup{"long patches", stability::long_patch_rows},
                                     StabilityGroup{"heights", stability::height_rows},
                                     StabilityGroup{"wavelengths", stability::wavelength_rows},
                                     StabilityGroup{"small patches", stability::small_patch_rows},
                                     StabilityGroup{"replicas", stability::replica_rows}};
  return groups;
}

std::vector<CheckRow> stability_rows() {
  std::vector<CheckRow> rows;
  for (const StabilityGroup& group : stability_groups())
    for (CheckRow& row : group.measure()) rows.push_back(std::move(row));
  return rows;
}

}  // namespace evaluation
