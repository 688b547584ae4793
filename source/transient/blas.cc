#include "plate_impact/transient/blas.h"

#include <cstdlib>
#include <string>

// Present when the BLAS is OpenBLAS and when CHOLMOD was built with OpenMP.
extern "C" {
void
openblas_set_num_threads(int) __attribute__((weak));
char *
openblas_get_corename() __attribute__((weak));
void
gotoblas_dynamic_init() __attribute__((weak));
void
gotoblas_dynamic_quit() __attribute__((weak));
void
omp_set_max_active_levels(int) __attribute__((weak));
}

namespace PlateImpact
{
  namespace
  {
    /// OpenBLAS' name of the best kernels that any processor with this one's
    /// instructions can run; null if it has none worth choosing.
    const char *
    kernels_of_processor()
    {
#ifdef __x86_64__
      if (__builtin_cpu_supports("avx512f") &&
          __builtin_cpu_supports("avx512cd") &&
          __builtin_cpu_supports("avx512bw") &&
          __builtin_cpu_supports("avx512dq") &&
          __builtin_cpu_supports("avx512vl"))
        return "SkylakeX";
      if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"))
        return "Haswell";
#endif
      return nullptr;
    }



    /// OpenBLAS goes by the model of a processor, not by its instructions, and
    /// takes models younger than itself for one of 2004, with a quarter of the
    /// operations per second. It has a variable of the environment against
    /// that, read when kernels are chosen: have them chosen again.
    void
    choose_openblas_kernels()
    {
      if (openblas_get_corename == nullptr ||
          gotoblas_dynamic_init == nullptr || gotoblas_dynamic_quit == nullptr)
        return;
      const char *kernels = kernels_of_processor();
      if (kernels == nullptr ||
          std::string(openblas_get_corename()) != "Prescott")
        return;
      setenv("OPENBLAS_CORETYPE", kernels, /*overwrite=*/0);
      gotoblas_dynamic_quit();
      gotoblas_dynamic_init();
    }
  } // namespace



  void
  prepare_blas()
  {
    static const bool is_done = [] {
      choose_openblas_kernels();
      // threads, four in CHOLMOD whatever the machine has, cost more than they
      // bring
      if (openblas_set_num_threads != nullptr)
        openblas_set_num_threads(1);
      if (omp_set_max_active_levels != nullptr)
        omp_set_max_active_levels(0);
      return true;
    }();
    (void)is_done;
  }
} // namespace PlateImpact
