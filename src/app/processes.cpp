// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/app/processes.hpp>

#include <fmt/format.h>

#include <cstdlib>

namespace scree::app::detail {

void refuse_study(CommandLine const& line, int processes) {
  if (line.is_study() && !line.options)
    throw CaseError({fmt::format("--study, --vary: the {} processes of mpirun run one case", processes)});
}

void refuse_mpirun() {
  for (char const* name : {"OMPI_COMM_WORLD_SIZE", "PMI_SIZE"}) {  // Open MPI; MPICH and Intel MPI
    char const* const text = std::getenv(name);
    int const processes = text == nullptr ? 1 : std::atoi(text);
    if (processes > 1)
      throw CaseError(
          {fmt::format("mpirun has started {} processes of this program, which is compiled without MPI, so "
                       "that each would run the whole case; configure it with -DSCREE_MPI=ON",
                       processes)});
  }
}

}  // namespace scree::app::detail
