# Finds the headers and the CPU library of OpenSubdiv and defines the target
# OpenSubdiv::CPU. A module of our own, because the CMake package that Debian
# ships names a static library that it does not contain.
find_path(OpenSubdivCpu_INCLUDE_DIR opensubdiv/far/topologyRefiner.h)
find_library(OpenSubdivCpu_LIBRARY osdCPU)

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(OpenSubdivCpu
  REQUIRED_VARS OpenSubdivCpu_LIBRARY OpenSubdivCpu_INCLUDE_DIR)
mark_as_advanced(OpenSubdivCpu_INCLUDE_DIR OpenSubdivCpu_LIBRARY)

if(OpenSubdivCpu_FOUND AND NOT TARGET OpenSubdiv::CPU)
  add_library(OpenSubdiv::CPU UNKNOWN IMPORTED)
  set_target_properties(OpenSubdiv::CPU PROPERTIES
    IMPORTED_LOCATION "${OpenSubdivCpu_LIBRARY}"
    INTERFACE_INCLUDE_DIRECTORIES "${OpenSubdivCpu_INCLUDE_DIR}")
endif()
