// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <io/crafted_file.hpp>
#include <scree/formulation/formulation.hpp>
#include <scree/neighbours/verlet_list.hpp>
#include <scree/passes/run_passes.hpp>
#include <scree/setup/lattice.hpp>
#include <scree/snapshots/snapshot_of.hpp>
#include <scree/terms/kernel_sums.hpp>

#include <fuzzer/FuzzedDataProvider.h>

#include <cstdlib>

// A good checkpoint whose entries are changed as the input says: replaced by others of any type, rank, size, storage
// and value, removed, linked. After it is sealed again, it is rejected with std::runtime_error, or a system continues
// from it.
namespace {

using namespace checkpoint_test;
using Input = FuzzedDataProvider;

std::string const entries[] = {"signature",
                               "time",
                               "steps",
                               "counters",
                               "notes",
                               "notes/case",
                               "arrays",
                               "arrays/material",
                               "arrays/material/position",
                               "arrays/material/volume",
                               "arrays/wall/volume",
                               "arrays/neighbours/material",
                               "arrays/neighbours/wall",
                               "arrays/neighbours/crossed"};

Handle copy_of(hid_t type) { return {H5Tcopy(type), H5Tclose}; }
Handle any_type(Input& input) {
  hid_t const plain[] = {H5T_IEEE_F64LE, H5T_IEEE_F32LE, H5T_STD_I32LE,   H5T_STD_I64LE, H5T_IEEE_F64BE,
                         H5T_STD_U8LE,   H5T_STD_I64BE,  H5T_STD_REF_OBJ, H5T_STD_B16LE, H5T_UNIX_D32LE};
  hsize_t const four = 4;
  switch (input.ConsumeIntegralInRange(0, 4)) {
    case 0: {
      Handle text = copy_of(H5T_C_S1);
      H5Tset_size(text, input.ConsumeBool() ? H5T_VARIABLE : input.ConsumeIntegralInRange(1, 300));
      return text;
    }
    case 1:
      return {H5Tarray_create2(H5T_IEEE_F64LE, 1, &four), H5Tclose};
    case 2:
      return {H5Tvlen_create(H5T_IEEE_F64LE), H5Tclose};
    default:
      return copy_of(input.PickValueInArray(plain));
  }
}
Handle any_space(Input& input) {
  int const rank = input.ConsumeBool() ? input.ConsumeIntegralInRange(1, 2) : input.ConsumeIntegralInRange(-1, 32);
  if (rank < 0) return {H5Screate(H5S_NULL), H5Sclose};
  if (rank == 0) return scree::hdf5::scalar_space();
  std::vector<hsize_t> size;
  for (int k = 0; k < rank; ++k)
    size.push_back(input.ConsumeIntegralInRange(0, 9) == 0 ? input.ConsumeIntegral<hsize_t>() >> 1
                                                           : input.ConsumeIntegralInRange(0, rank > 4 ? 1 : 300));
  return Content::simple(size);
}
void any_storage(Input& input, hid_t creation, hid_t space) {
  int const rank = std::max(H5Sget_simple_extent_ndims(space), 0);
  std::vector<hsize_t> const piece(std::size_t(rank), 1);
  switch (input.ConsumeIntegralInRange(0, 9)) {
    case 0:
      H5Pset_layout(creation, H5D_COMPACT);
      break;
    case 1:
      H5Pset_external(creation, "/etc/passwd", 0, H5F_UNLIMITED);
      break;
    case 2:
      H5Pset_chunk(creation, rank, piece.data()), H5Pset_deflate(creation, 1);
      break;
    case 3:
      H5Pset_virtual(creation, space, "/etc/passwd", "/x", space);
      break;
    default:
      break;
  }
}
/// Memory for the values of a space, if these are few and stored in the file.
std::vector<std::uint8_t> any_values(Input& input, hid_t type, hid_t space) {
  auto const count = H5Sget_simple_extent_npoints(space);
  bool const plain = H5Tdetect_class(type, H5T_VLEN) <= 0 && H5Tis_variable_str(type) <= 0;
  if (!plain || count <= 0 || count > 4000) return {};
  auto values = input.ConsumeBytes<std::uint8_t>(std::size_t(input.ConsumeIntegralInRange(0, 64)));
  values.resize(std::size_t(count) * H5Tget_size(type));
  return values;
}
std::string any_of(Input& input) {
  return entries[input.ConsumeIntegralInRange<std::size_t>(0, std::size(entries) - 1)];
}

void replace(Input& input, Content const& content, std::string const& name) {
  char const* const units[] = {"m", "m/s", "m^dim", "of the skin"};
  auto const type = any_type(input), space = any_space(input), creation = Content::in_one_piece();
  any_storage(input, creation, space);
  auto const dataset = content.replace(name, type, space, creation, false);
  if (dataset < 0) return;
  scree::hdf5::write_text(dataset, "unit", input.PickValueInArray(units));
  scree::hdf5::write_text(dataset, "names", input.ConsumeRandomLengthString(100));
  auto const values = any_values(input, type, space);
  if (!values.empty()) H5Dwrite(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data());
}
/// Other values of the correct type.
void overwrite(Input& input, Content const& content, std::string const& name) {
  Handle const dataset{H5Dopen2(content.file, name.c_str(), H5P_DEFAULT), H5Dclose};
  if (dataset < 0) return;
  Handle const type{H5Dget_type(dataset), H5Tclose}, space{H5Dget_space(dataset), H5Sclose};
  auto const values = any_values(input, type, space);
  if (!values.empty()) H5Dwrite(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data());
}
void change_attribute(Input& input, Content const& content, std::string const& name) {
  char const* const attribute = input.ConsumeBool() ? "names" : "unit";
  if (H5Aexists_by_name(content.file, name.c_str(), attribute, H5P_DEFAULT) <= 0) return;
  auto const type = any_type(input), space = any_space(input);
  if (input.ConsumeBool())
    content.text_attribute(name, attribute, input.ConsumeRandomLengthString(200));
  else if (auto const count = H5Sget_simple_extent_npoints(space); count >= 0 && count < 4000)
    content.attribute(name, attribute, type, space);
}
void change(Input& input, Content const& content) {
  auto const name = any_of(input), other = any_of(input);
  switch (input.ConsumeIntegralInRange(0, 9)) {
    case 0:
      return content.remove(name);
    case 1:
      content.remove(name), H5Lcreate_soft(other.c_str(), content.file, name.c_str(), H5P_DEFAULT, H5P_DEFAULT);
      return;
    case 2:
      content.remove(name),
          H5Lcreate_external("/etc/passwd", "/x", content.file, name.c_str(), H5P_DEFAULT, H5P_DEFAULT);
      return;
    case 3:
      content.remove(name),
          H5Lcreate_hard(content.file, other.c_str(), content.file, name.c_str(), H5P_DEFAULT, H5P_DEFAULT);
      return;
    case 4:
    case 5:
      return change_attribute(input, content, name);
    case 6:
    case 7:
      return overwrite(input, content, name);
    default:
      return replace(input, content, name);
  }
}

using P = scree::Formulation<2>;
using scree::Material, scree::Wall;
using Small =
    scree::System<P, scree::VerletList<P>, scree::PeriodicImages<P>,
                  scree::BodyWith<Material, scree::Fields<scree::Position, scree::Volume, scree::KernelSum<Material>,
                                                          scree::KernelGradient<Material>>>,
                  scree::BodyWith<Wall, scree::Fields<scree::Position, scree::Volume>>>;

Small small_system(bool periodic) {
  using namespace scree::fields;
  double const spacing = 0.25;
  Small system(1.2 * spacing, periodic ? std::vector<scree::Period>{{0, 0, 2}} : std::vector<scree::Period>{});
  auto const place = [&](auto& body, scree::Box<2> const& box) {
    auto const points = scree::fill_lattice(box, spacing);
    body.resize(static_cast<int>(points.size()));
    body.from_host(position, points);
    body.fill(volume, spacing * spacing);
  };
  place(system.body<Material>(), {{0, 0}, {2, 0.5}});
  place(system.body<Wall>(), {{0, -0.25}, {2, 0}});
  system.positions_changed();
  return system;
}
void step(Small& system) {
  system.begin_step();
  scree::run_passes(
      system, std::tuple(scree::pair_pass<Material>("sums", scree::over<Material>(scree::KernelSums<Material>{}))));
  system.positions_changed();
}
/// The file of a run after `steps` steps.
std::string good_file(fs::path const& path, bool periodic, int steps) {
  auto system = small_system(periodic);
  for (int k = 0; k < steps; ++k) step(system);
  auto snapshot = scree::snapshot_of(system);
  snapshot.notes["case"] = "spacing = 0.25\n";
  scree::write_checkpoint(path, snapshot);
  return content_of(path);
}
struct Files {
  Folder folder;
  fs::path path = folder / "checkpoint.h5";
  std::string good[2][2] = {{good_file(path, false, 0), good_file(path, false, 2)},
                            {good_file(path, true, 0), good_file(path, true, 2)}};
};

}  // namespace

extern "C" int LLVMFuzzerInitialize(int*, char***) {
  ::setenv("TMPDIR", "/dev/shm", 0);  // files in memory
  Kokkos::initialize();
  std::atexit(Kokkos::finalize);
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size) {
  static Files const files;
  Input input(data, size);
  bool const periodic = input.ConsumeBool(), used = input.ConsumeBool();
  set_content(files.path, files.good[periodic][used]);
  craft(files.path, [&](Content const& content) {
    while (input.remaining_bytes() > 0) change(input, content);
  });
  try {
    auto const found = scree::read_checkpoint(files.path);
    auto system = small_system(periodic);
    scree::restore_into(system, found);
    for (int k = 0; k < 3; ++k) step(system);
  } catch (std::runtime_error const&) {
  }
  return 0;
}
