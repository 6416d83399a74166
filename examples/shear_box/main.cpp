// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "recorder.hpp"

#include <Kokkos_Core.hpp>


namespace shear_box {
// Defined in simulate_*.cpp.
template <int Dim, class Real>
void simulate(support::Run<Options> const& run);
}  // namespace shear_box

int main(int argc, char** argv) {
  return support::guarded_main([&] {
    Kokkos::ScopeGuard const kokkos(argc, argv);
    int exit_code = 0;
    auto const run = support::start({argv + 1, argv + argc}, shear_box::schema(),
                                    {.name = "shear_box",
                                     .summary = "Particle-size segregation in an oscillating shear box",
                                     .results = shear_box::result_files()},
                                    exit_code);
    if (!run) return exit_code;
    bool const in_plane = run->options.numerics.dimension == 2;
    bool const single = run->options.numerics.precision == shear_box::Precision::single_precision;
    if (in_plane)
      single ? shear_box::simulate<2, float>(*run) : shear_box::simulate<2, double>(*run);
    else
      single ? shear_box::simulate<3, float>(*run) : shear_box::simulate<3, double>(*run);
    return 0;
  });
}
