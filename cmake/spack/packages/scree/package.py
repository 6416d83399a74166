# SPDX-FileCopyrightText: The scree authors
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Recipe for Spack 1.0 or later, for a copy of this repository:

    spack repo add path/to/scree/cmake/spack
    spack env create scree && spack env activate scree
    spack develop --path path/to/scree scree@main
    spack add scree@main ^kokkos+openmp && spack install

Not tried with Spack: written after its recipes of libraries on Kokkos."""
from spack_repo.builtin.build_systems.cmake import CMakePackage

from spack.package import *


class Scree(CMakePackage):
    """Smoothed particle hydrodynamics of granular matter: a header-only C++20 library on Kokkos."""

    license("Apache-2.0 WITH LLVM-exception")

    version("main")

    variant("app", default=False, description="scree::app: programs with case files")
    variant("tests", default=False, description="Build the tests")

    depends_on("cxx", type="build")
    depends_on("cmake@3.24:", type="build")
    depends_on("kokkos@5.0.2:")
    depends_on("eigen@3.4")
    depends_on("fmt@10.1:")
    depends_on("hdf5~mpi")
    depends_on("cli11", when="+app")
    depends_on("tomlplusplus", when="+app")
    depends_on("catch2@3:", type="build", when="+tests")
    requires("^kokkos+wrapper", when="^kokkos+cuda", msg="scree is compiled for GPUs through the nvcc_wrapper of Kokkos")
    requires("^kokkos+cuda_constexpr", when="^kokkos+cuda", msg="scree's loops call constexpr functions of the standard library")

    def cmake_args(self):
        return [
            self.define_from_variant("SCREE_APP", "app"),
            self.define_from_variant("SCREE_BUILD_TESTS", "tests"),
            self.define("SCREE_BUILD_EXAMPLES", False),
            self.define("SCREE_BUILD_BENCHMARKS", False),
            self.define("HDF5_ROOT", self.spec["hdf5"].prefix),
            self.define("CMAKE_CXX_COMPILER", self["kokkos"].kokkos_cxx),
        ]
