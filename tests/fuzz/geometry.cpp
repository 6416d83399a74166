// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/setup/mesh.hpp>
#include <scree/setup/terrain.hpp>

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <stdexcept>
#include <string>

// Any bytes as a file of geometry; the first byte selects its kind. The file is rejected with std::runtime_error or
// std::invalid_argument, or it becomes a shape with finite bounds and distances.
namespace {

using namespace scree;

template <Shape S>
void try_out(S const& shape, Box<S::dim> const& box) {
  if (!box.low.allFinite() || !box.high.allFinite()) std::abort();
  for (double const part : {-0.3, 0.1, 0.5, 1.2}) {
    double const distance = shape.signed_distance(Vec<S::dim, double>(box.low + part * (box.high - box.low)));
    if (std::isnan(distance)) std::abort();
  }
}

void read(unsigned kind, std::string const& bytes) {
  if (kind == 0 || kind == 1) {
    Mesh const mesh(kind == 0 ? read_stl(bytes, "a.stl") : read_obj(bytes, "a.obj"));
    try_out(mesh, mesh.bounds());
  } else if (kind == 2) {
    Polygon const polygon = polygon_from_obj(bytes, "a.obj");
    try_out(polygon, polygon.bounds());
  } else {
    HeightField const field(read_asc(bytes, "a.asc"));
    try_out(field, field.extent());
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size) {
  if (size == 0) return 0;
  try {
    read(data[0] % 4U, std::string(reinterpret_cast<char const*>(data) + 1, size - 1));
  } catch (std::runtime_error const&) {
  } catch (std::invalid_argument const&) {
  }
  return 0;
}
