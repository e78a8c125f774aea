// CIE 1931 2-degree colour-matching functions and the illuminant D65, as tables.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

#include "brdf/units.h"

namespace brdf {

/// Tristimulus values X, Y, Z of the CIE 1931 2-degree observer; Y is the luminance.
struct Xyz {
  double x = 0, y = 0, z = 0;

  constexpr Xyz operator+(const Xyz& other) const {
    return {x + other.x, y + other.y, z + other.z};
  }
  constexpr bool operator==(const Xyz&) const = default;
};

constexpr Xyz operator*(double factor, const Xyz& colour) {
  return {factor * colour.x, factor * colour.y, factor * colour.z};
}

/// Values at 360, 365, ..., 830 nm.
using SpectralTable = std::array<double, 95>;
inline constexpr double table_first_nm = 360, table_step_nm = 5, table_last_nm = 830;

// The tables of CIE 015 as the Debian package colord-data 1.4.6 carries them, digit by digit:
// cmf/CIE1931-2deg-XYZ.cmf and, from 360 nm on, illuminant/CIE-D65.sp, where D65 is 1 at 560 nm.
// clang-format off
inline constexpr SpectralTable cie_1931_x = {
    0.0001299, 0.0002321, 0.0004149, 0.0007416, 0.001368, 0.002236, 0.004243, 0.00765, 0.01431,
    0.02319, 0.04351, 0.07763, 0.13438, 0.21477, 0.2839, 0.3285, 0.34828, 0.34806, 0.3362, 0.3187,
    0.2908, 0.2511, 0.19536, 0.1421, 0.09564, 0.05795001, 0.03201, 0.0147, 0.0049, 0.0024, 0.0093,
    0.0291, 0.06327, 0.1096, 0.1655, 0.2257499, 0.2904, 0.3597, 0.4334499, 0.5120501, 0.5945,
    0.6784, 0.7621, 0.8425, 0.9163, 0.9786, 1.0263, 1.0567, 1.0622, 1.0456, 1.0026, 0.9384,
    0.8544499, 0.7514, 0.6424, 0.5419, 0.4479, 0.3608, 0.2835, 0.2187, 0.1649, 0.1212, 0.0874,
    0.0636, 0.04677, 0.0329, 0.0227, 0.01584, 0.01135916, 0.008110916, 0.005790346, 0.004109457,
    0.002899327, 0.00204919, 0.001439971, 0.0009999493, 0.0006900786, 0.0004760213, 0.0003323011,
    0.0002348261, 0.0001661505, 0.000117413, 8.307527e-5, 5.870652e-5, 4.150994e-5, 2.935326e-5,
    2.067383e-5, 1.455977e-5, 1.025398e-5, 7.221456e-6, 5.085868e-6, 3.581652e-6, 2.522525e-6,
    1.776509e-6, 1.251141e-6};

inline constexpr SpectralTable cie_1931_y = {
    3.917e-6, 6.965e-6, 1.239e-5, 2.202e-5, 3.9e-5, 6.4e-5, 0.00012, 0.000217, 0.000396, 0.00064,
    0.00121, 0.00218, 0.004, 0.0073, 0.0116, 0.01684, 0.023, 0.0298, 0.038, 0.048, 0.06, 0.0739,
    0.09098, 0.1126, 0.13902, 0.1693, 0.20802, 0.2586, 0.323, 0.4073, 0.503, 0.6082, 0.71, 0.7932,
    0.862, 0.9148501, 0.954, 0.9803, 0.9949501, 1, 0.995, 0.9786, 0.952, 0.9154, 0.87, 0.8163,
    0.757, 0.6949, 0.631, 0.5668, 0.503, 0.4412, 0.381, 0.321, 0.265, 0.217, 0.175, 0.1382, 0.107,
    0.0816, 0.061, 0.04458, 0.032, 0.0232, 0.017, 0.01192, 0.00821, 0.005723, 0.004102, 0.002929,
    0.002091, 0.001484, 0.001047, 0.00074, 0.00052, 0.0003611, 0.0002492, 0.0001719, 0.00012,
    8.48e-5, 6e-5, 4.24e-5, 3e-5, 2.12e-5, 1.499e-5, 1.06e-5, 7.4657e-6, 5.2578e-6, 3.7029e-6,
    2.6078e-6, 1.8366e-6, 1.2934e-6, 9.1093e-7, 6.4153e-7, 4.5181e-7};

inline constexpr SpectralTable cie_1931_z = {
    0.0006061, 0.001086, 0.001946, 0.003486, 0.006450001, 0.01054999, 0.02005001, 0.03621,
    0.06785001, 0.1102, 0.2074, 0.3713, 0.6456, 1.0390501, 1.3856, 1.62296, 1.74706, 1.7826,
    1.77211, 1.7441, 1.6692, 1.5281, 1.28764, 1.0419, 0.8129501, 0.6162, 0.46518, 0.3533, 0.272,
    0.2123, 0.1582, 0.1117, 0.07824999, 0.05725001, 0.04216, 0.02984, 0.0203, 0.0134, 0.008749999,
    0.005749999, 0.0039, 0.002749999, 0.0021, 0.0018, 0.001650001, 0.0014, 0.0011, 0.001, 0.0008,
    0.0006, 0.00034, 0.00024, 0.00019, 0.0001, 4.999999e-5, 3e-5, 2e-5, 1e-5, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0};

inline constexpr SpectralTable cie_d65 = {
    0.466383, 0.493637, 0.520891, 0.510323, 0.499755, 0.523118, 0.546482, 0.687015, 0.827549,
    0.871204, 0.91486, 0.924589, 0.934318, 0.90057, 0.866823, 0.957736, 1.04865, 1.10936, 1.17008,
    1.1741, 1.17812, 1.16336, 1.14861, 1.15392, 1.15923, 1.12367, 1.08811, 1.09082, 1.09354,
    1.08578, 1.07802, 1.06296, 1.0479, 1.06239, 1.07689, 1.06047, 1.04405, 1.04225, 1.04046,
    1.02023, 1, 0.981671, 0.963342, 0.960611, 0.95788, 0.922368, 0.886856, 0.893459, 0.900062,
    0.898026, 0.895991, 0.886489, 0.876987, 0.854936, 0.832886, 0.834939, 0.836992, 0.81863,
    0.800268, 0.801207, 0.802146, 0.812462, 0.822778, 0.80281, 0.782842, 0.740027, 0.697213,
    0.706652, 0.716091, 0.72979, 0.74349, 0.679765, 0.61604, 0.657448, 0.698856, 0.724863, 0.75087,
    0.693398, 0.635927, 0.550054, 0.464182, 0.566118, 0.668054, 0.650941, 0.633828, 0.638434,
    0.64304, 0.618779, 0.594519, 0.557054, 0.51959, 0.546998, 0.574406, 0.588765, 0.603125};
// clang-format on

/// A table at a wavelength: linear between entries, 0 outside 360 to 830 nm.
constexpr double table_value(const SpectralTable& table, Length wavelength) {
  const double position = (wavelength.nm() - table_first_nm) / table_step_nm;
  constexpr std::size_t last_interval = std::tuple_size_v<SpectralTable> - 2;
  if (!(position >= 0 && position <= static_cast<double>(last_interval + 1))) return 0;
  const std::size_t i = std::min(static_cast<std::size_t>(position), last_interval);
  const double t = position - static_cast<double>(i);
  return (1 - t) * table[i] + t * table[i + 1];
}

/// xbar, ybar, zbar: the tristimulus values of light of one wavelength and unit power.
///
/// wavelength: any; 0 outside 360 to 830 nm, where the table ends at 1e-3 of its peaks or less.
/// Linear between the table's 5 nm, by which D65 in steps of 1 nm differs from the sum over the
/// CIE's own table of 1 nm by at most 3e-5 in x and y (colour.tests.cpp).
constexpr Xyz colour_matching(Length wavelength) {
  return {table_value(cie_1931_x, wavelength), table_value(cie_1931_y, wavelength),
          table_value(cie_1931_z, wavelength)};
}

/// Relative spectral power S of the illuminant D65, 1 at 560 nm; linear in between, 0 outside 360
/// to 830 nm.
constexpr double illuminant_d65(Length wavelength) {
  return table_value(cie_d65, wavelength);
}

}  // namespace brdf
