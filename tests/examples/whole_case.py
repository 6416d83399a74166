# SPDX-FileCopyrightText: The scree authors
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""A program that is compiled for whole cases refuses more than one rank and says how to get them."""
import tempfile

from case_program import check, run

with tempfile.TemporaryDirectory() as folder:
    said = run(folder, "numerics.ranks=2", code=2)
    check("numerics.ranks" in said and "compiled for whole cases; configure it with -DSCREE_MPI=ON" in said, "the key and the option")
