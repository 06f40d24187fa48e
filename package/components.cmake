# The optional components of Surface_mesh_foliation: headers that need one library more. Read by the
# package's own CMakeLists.txt, and by find_package(Surface_mesh_foliation COMPONENTS ...).
#
# component   for                                  library   Debian's package
# Parallel    CGAL::Parallel_tag                   TBB       libtbb-dev
# Spectra     Heat_kernel_signature                Spectra   libspectra-dev
# Cholmod     Cholmod_solver.h                     CHOLMOD   libsuitesparse-dev
# Boomer_amg  Boomer_amg_solver.h                  hypre     libhypre-dev
# VTK         IO/read_with_vtk.h                   VTK       libvtk9-dev
# Assimp      IO/read_with_assimp.h                Assimp    libassimp-dev

set(surface_mesh_foliation_components Parallel Spectra Cholmod Boomer_amg VTK Assimp)
set(surface_mesh_foliation_library_of_Parallel "TBB (Debian: libtbb-dev)")
set(surface_mesh_foliation_library_of_Spectra "Spectra (Debian: libspectra-dev)")
set(surface_mesh_foliation_library_of_Cholmod "CHOLMOD (Debian: libsuitesparse-dev)")
set(surface_mesh_foliation_library_of_Boomer_amg "hypre and MPI (Debian: libhypre-dev)")
set(surface_mesh_foliation_library_of_VTK "VTK (Debian: libvtk9-dev)")
set(surface_mesh_foliation_library_of_Assimp "Assimp (Debian: libassimp-dev)")

# surface_mesh_foliation_find_component(<component>): makes the target
# Surface_mesh_foliation::<component> if the library of the component is there. It has what the
# library needs, and is linked besides Surface_mesh_foliation::Surface_mesh_foliation.
function(surface_mesh_foliation_find_component component)
  set(target Surface_mesh_foliation::${component})
  if(TARGET ${target})
    return()
  endif()
  set(includes "")
  set(libraries "")
  if(component STREQUAL "Parallel")
    find_package(TBB QUIET)
    include(CGAL_TBB_support)
    if(TARGET CGAL::TBB_support)
      set(libraries CGAL::TBB_support)
    endif()
  elseif(component STREQUAL "Spectra")
    find_path(SMF_SPECTRA_INCLUDE_DIR Spectra/SymEigsSolver.h)
    mark_as_advanced(SMF_SPECTRA_INCLUDE_DIR)
    if(SMF_SPECTRA_INCLUDE_DIR)
      set(includes ${SMF_SPECTRA_INCLUDE_DIR})
    endif()
  elseif(component STREQUAL "Cholmod")
    find_path(SMF_CHOLMOD_INCLUDE_DIR cholmod.h PATH_SUFFIXES suitesparse)
    find_library(SMF_CHOLMOD_LIBRARY cholmod)
    mark_as_advanced(SMF_CHOLMOD_INCLUDE_DIR SMF_CHOLMOD_LIBRARY)
    if(SMF_CHOLMOD_INCLUDE_DIR AND SMF_CHOLMOD_LIBRARY)
      set(includes ${SMF_CHOLMOD_INCLUDE_DIR})
      set(libraries ${SMF_CHOLMOD_LIBRARY})
    endif()
  elseif(component STREQUAL "Boomer_amg")
    find_path(SMF_HYPRE_INCLUDE_DIR HYPRE_parcsr_ls.h PATH_SUFFIXES hypre)
    find_library(SMF_HYPRE_LIBRARY HYPRE)
    mark_as_advanced(SMF_HYPRE_INCLUDE_DIR SMF_HYPRE_LIBRARY)
    if(SMF_HYPRE_INCLUDE_DIR AND SMF_HYPRE_LIBRARY)
      # the MPI that hypre is built for, but not MPI's obsolete C++ functions
      set(MPI_CXX_SKIP_MPICXX ON)
      find_package(MPI QUIET COMPONENTS CXX)
      if(TARGET MPI::MPI_CXX)
        set(includes ${SMF_HYPRE_INCLUDE_DIR})
        set(libraries ${SMF_HYPRE_LIBRARY} MPI::MPI_CXX)
      endif()
    endif()
  elseif(component STREQUAL "VTK")
    find_package(VTK QUIET COMPONENTS CommonCore CommonDataModel IOXML)
    if(TARGET VTK::IOXML)
      set(libraries VTK::CommonCore VTK::CommonDataModel VTK::IOXML)
    endif()
  elseif(component STREQUAL "Assimp")
    find_package(assimp QUIET)
    if(TARGET assimp::assimp)
      set(libraries assimp::assimp)
    endif()
  else()
    message(FATAL_ERROR "Surface_mesh_foliation has no component ${component}; it has "
      "${surface_mesh_foliation_components}")
  endif()
  if(includes OR libraries)
    add_library(${target} INTERFACE IMPORTED)
    target_include_directories(${target} SYSTEM INTERFACE ${includes})
    target_link_libraries(${target} INTERFACE ${libraries})
  endif()
endfunction()
