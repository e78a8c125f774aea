// Reflectances at normal incidence of everyday materials.
#pragma once

#include <algorithm>
#include <array>
#include <string>
#include <string_view>

#include "brdf/error.h"
#include "brdf/units.h"

namespace brdf {

enum class MaterialKind { dielectric, semiconductor, metal };

/// A material's reflectance at normal incidence in air, R_0, as linear sRGB (Rec. 709) values.
struct ReflectanceMaterial {
  std::string_view name;
  MaterialKind kind;
  double red, green, blue;
};

namespace detail {

constexpr ReflectanceMaterial grey(std::string_view name, double r0) {
  return {name, MaterialKind::dielectric, r0, r0, r0};
}

}  // namespace detail

/// The table of Hoffman's course, with the additions of Akenine-Moller et al., Real-Time Rendering,
/// 4th edition 2018, tables 9.1 to 9.3, whose digits these are. Where the tables give a range this
/// is its middle; gold's red is printed cut to 1 (the course has 1.022: outside of sRGB).
inline constexpr std::array reflectance_materials = {
    detail::grey("water", 0.02),          // 0.02
    detail::grey("living-tissue", 0.03),  // 0.02 to 0.04
    detail::grey("skin", 0.028),          // 0.028
    detail::grey("eye", 0.025),           // 0.025, a dry cornea
    detail::grey("hair", 0.046),          // 0.046
    detail::grey("tooth", 0.058),         // 0.058
    detail::grey("fabric", 0.048),        // 0.04 to 0.056
    detail::grey("stone", 0.0455),        // 0.035 to 0.056
    detail::grey("plastic", 0.045),       // 0.04 to 0.05
    detail::grey("glass", 0.045),         // 0.04 to 0.05
    detail::grey("crystal-glass", 0.06),  // 0.05 to 0.07
    detail::grey("gem", 0.065),           // 0.05 to 0.08
    ReflectanceMaterial{"diamond", MaterialKind::dielectric, 0.171, 0.172, 0.176},
    ReflectanceMaterial{"silicon", MaterialKind::semiconductor, 0.345, 0.369, 0.426},
    ReflectanceMaterial{"titanium", MaterialKind::metal, 0.542, 0.497, 0.449},
    ReflectanceMaterial{"chromium", MaterialKind::metal, 0.549, 0.556, 0.554},
    ReflectanceMaterial{"iron", MaterialKind::metal, 0.562, 0.565, 0.578},
    ReflectanceMaterial{"nickel", MaterialKind::metal, 0.660, 0.609, 0.526},
    ReflectanceMaterial{"platinum", MaterialKind::metal, 0.673, 0.637, 0.585},
    ReflectanceMaterial{"copper", MaterialKind::metal, 0.955, 0.638, 0.538},
    ReflectanceMaterial{"palladium", MaterialKind::metal, 0.733, 0.697, 0.652},
    ReflectanceMaterial{"mercury", MaterialKind::metal, 0.781, 0.780, 0.778},
    ReflectanceMaterial{"brass", MaterialKind::metal, 0.910, 0.778, 0.423},
    ReflectanceMaterial{"zinc", MaterialKind::metal, 0.664, 0.824, 0.850},
    ReflectanceMaterial{"gold", MaterialKind::metal, 1.000, 0.782, 0.344},
    ReflectanceMaterial{"aluminium", MaterialKind::metal, 0.913, 0.922, 0.924},
    ReflectanceMaterial{"silver", MaterialKind::metal, 0.972, 0.960, 0.915},
};

/// The material of that name. Throws Errc::invalid_argument naming all there are.
inline const ReflectanceMaterial& material_named(std::string_view name) {
  const auto found = std::ranges::find(reflectance_materials, name, &ReflectanceMaterial::name);
  if (found != reflectance_materials.end()) return *found;
  std::string names;
  for (const ReflectanceMaterial& material : reflectance_materials)
    names.append(names.empty() ? "" : ", ").append(material.name);
  throw Error(Errc::invalid_argument,
              "material \"" + std::string(name) + "\" must be one of " + names);
}

/// Wavelengths that the three values are taken to stand for: about the maxima of the sensitivities
/// behind the sRGB primaries.
inline const Length blue_wavelength = Length::nm(465), green_wavelength = Length::nm(550),
                    red_wavelength = Length::nm(610);

/// R_0 at a wavelength, 0 to 1: linear between the values of blue, green and red at 465, 550 and
/// 610 nm, constant outside. A stand-in for a spectrum: three numbers hold no more.
inline double normal_reflectance(const ReflectanceMaterial& material, Length wavelength) {
  const auto between = [wavelength](Length a, double at_a, Length b, double at_b) {
    const double t = std::clamp((wavelength.um() - a.um()) / (b.um() - a.um()), 0.0, 1.0);
    return (1 - t) * at_a + t * at_b;
  };
  if (wavelength < green_wavelength)
    return between(blue_wavelength, material.blue, green_wavelength, material.green);
  return between(green_wavelength, material.green, red_wavelength, material.red);
}

}  // namespace brdf
