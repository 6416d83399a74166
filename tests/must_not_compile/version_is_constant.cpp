// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// expected: read-only|const|must be a modifiable lvalue
#include <scree/version.hpp>

int main() {
#ifdef FIXED
  scree::Version version = scree::library_version;
  version.major = 1;
#else
  scree::library_version.major = 1;
#endif
}
