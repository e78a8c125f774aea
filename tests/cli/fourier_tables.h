// Tables made by `precompute`, taken apart by the tests themselves.
#pragma once

#include <complex>
#include <cstring>
#include <string>
#include <vector>

#include "tests/cli/program.h"

struct FourierTables {
  std::string header;
  std::vector<std::complex<double>> values;
};

/// NPY: magic and version in 8 bytes, the length of the header in 2, the header, the numbers.
inline FourierTables read_tables(const Scratch& folder, const std::string& file) {
  const std::string bytes = folder.read(file);
  const std::size_t header_size =
      static_cast<unsigned char>(bytes.at(8)) + 256u * static_cast<unsigned char>(bytes.at(9));
  FourierTables tables{bytes.substr(10, header_size), {}};
  const std::string numbers = bytes.substr(10 + header_size);
  tables.values.resize(numbers.size() / sizeof(tables.values[0]));
  std::memcpy(static_cast<void*>(tables.values.data()), numbers.data(),
              tables.values.size() * sizeof(tables.values[0]));
  return tables;
}
