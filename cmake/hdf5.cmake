# SPDX-FileCopyrightText: 2026 The Grainproof authors
# SPDX-License-Identifier: BSD-3-Clause
# The C library alone. CMake's own module asks the compiler wrapper, which needs the C language.
find_path(HDF5_INCLUDE hdf5.h PATH_SUFFIXES hdf5/serial REQUIRED)
find_library(HDF5_LIBRARY NAMES hdf5_serial hdf5 PATH_SUFFIXES hdf5/serial REQUIRED)
add_library(hdf5::hdf5 INTERFACE IMPORTED)
set_target_properties(hdf5::hdf5 PROPERTIES
  INTERFACE_INCLUDE_DIRECTORIES ${HDF5_INCLUDE}
  INTERFACE_LINK_LIBRARIES ${HDF5_LIBRARY})
