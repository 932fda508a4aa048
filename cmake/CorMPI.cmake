# SPDX-License-Identifier: MIT
# MPI::MPI_C where MPI can be compiled with: sets COR_HAVE_MPI. FindMPI ends the configuration where mpicc is installed
# without mpi.h, as Debian's package openmpi-bin (lammps brings it) leaves a machine without libopenmpi-dev; so mpicc is
# asked first.
set(COR_HAVE_MPI FALSE)
find_program(COR_MPICC NAMES mpicc DOC "The compiler wrapper of MPI")
mark_as_advanced(COR_MPICC)
set(mpi_without_header FALSE)
if(COR_MPICC)
  file(WRITE "${CMAKE_CURRENT_BINARY_DIR}/CMakeFiles/mpi_header.c" "#include <mpi.h>\n")
  execute_process(COMMAND ${COR_MPICC} -E "${CMAKE_CURRENT_BINARY_DIR}/CMakeFiles/mpi_header.c"
    RESULT_VARIABLE mpi_without_header OUTPUT_QUIET ERROR_QUIET)
endif()
if(NOT mpi_without_header)
  find_package(MPI QUIET COMPONENTS C)
  set(COR_HAVE_MPI ${MPI_C_FOUND})
endif()
