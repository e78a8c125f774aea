#include "brdf/reflectance_materials.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <set>

#include "tests/support/is_error.h"

using brdf::Errc;
using brdf::Length;
using brdf::material_named;
using brdf::MaterialKind;
using brdf::normal_reflectance;
using brdf::reflectance_materials;
using brdf::ReflectanceMaterial;

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();

}  // namespace

TEST_CASE("a material is found by its name, and each name stands once", "[material]") {
  std::set<std::string_view> names;
  for (const ReflectanceMaterial& material : reflectance_materials) {
    names.insert(material.name);
    CHECK(&material_named(material.name) == &material);
  }
  CHECK(names.size() == reflectance_materials.size());
  CHECK(material_named("gold").blue == 0.344);
  CHECK_ERROR(material_named("Gold"), Errc::invalid_argument, "material \"Gold\" must be one of");
  CHECK_ERROR(material_named(""), Errc::invalid_argument, "copper, palladium");
}

TEST_CASE("the table has the digits that its 8-bit sRGB column has", "[material][golden]") {
  // The same table prints each value a second time, through the sRGB curve as 8 bits.
  struct Row {
    std::string_view name;
    int red, green, blue;
  };
  const auto srgb = [](double linear) {
    return static_cast<int>(std::lround(
        255 * (linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055)));
  };
  for (const Row& row : {Row{"water", 39, 39, 39},        Row{"skin", 47, 47, 47},
                         Row{"eye", 44, 44, 44},          Row{"hair", 61, 61, 61},
                         Row{"tooth", 68, 68, 68},        Row{"diamond", 115, 115, 116},
                         Row{"silicon", 159, 164, 174},   Row{"titanium", 194, 187, 179},
                         Row{"chromium", 196, 197, 196},  Row{"iron", 198, 198, 200},
                         Row{"nickel", 212, 205, 192},    Row{"platinum", 214, 209, 201},
                         Row{"copper", 250, 209, 194},    Row{"palladium", 222, 217, 211},
                         Row{"mercury", 229, 228, 228},   Row{"brass", 245, 228, 174},
                         Row{"zinc", 213, 234, 237},      Row{"gold", 255, 229, 158},
                         Row{"aluminium", 245, 246, 246}, Row{"silver", 252, 250, 245}}) {
    CAPTURE(std::string(row.name));
    const ReflectanceMaterial& material = material_named(row.name);
    // Both columns are rounded from the same spectrum: a last digit of 0.001 is up to one step.
    CHECK(std::abs(srgb(material.red) - row.red) <= 1);
    CHECK(std::abs(srgb(material.green) - row.green) <= 1);
    CHECK(std::abs(srgb(material.blue) - row.blue) <= 1);
  }
}

TEST_CASE("kinds of material differ as physics says", "[material][invariant]") {
  for (const ReflectanceMaterial& material : reflectance_materials)
    for (const double r0 : {material.red, material.green, material.blue}) {
      CAPTURE(std::string(material.name), r0);
      switch (material.kind) {
        case MaterialKind::dielectric:
          CHECK(r0 >= 0.02);
          CHECK(r0 <= 0.2);
          break;
        case MaterialKind::semiconductor:
          CHECK(r0 >= 0.2);
          CHECK(r0 <= 0.5);
          break;
        case MaterialKind::metal:
          CHECK(r0 >= 0.3);
          CHECK(r0 <= 1);
          break;
      }
    }
  // Diamond's index of 2.42: ((1 - n) / (1 + n))^2.
  CHECK(std::abs(material_named("diamond").green - std::pow(1.42 / 3.42, 2)) <= 1e-3);
}

TEST_CASE("a material at a wavelength lies on the lines between its three values",
          "[material][oracle]") {
  const ReflectanceMaterial& copper = material_named("copper");
  for (const double nm : {380.0, 464.0, 465.0})
    CHECK(normal_reflectance(copper, Length::nm(nm)) == 0.538);
  for (const double nm : {610.0, 611.0, 780.0})
    CHECK(normal_reflectance(copper, Length::nm(nm)) == 0.955);
  CHECK(std::abs(normal_reflectance(copper, Length::nm(550)) - 0.638) <= eps);
  CHECK(std::abs(normal_reflectance(copper, Length::nm(507.5)) - (0.538 + 0.638) / 2) <= 4 * eps);
  CHECK(std::abs(normal_reflectance(copper, Length::nm(580)) - (0.638 + 0.955) / 2) <= 4 * eps);
  // No step where the lines meet.
  CHECK(std::abs(normal_reflectance(copper, Length::nm(550 - 1e-9)) -
                 normal_reflectance(copper, Length::nm(550 + 1e-9))) <= 1e-11);
}
