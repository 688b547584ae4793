#ifndef plate_impact_transient_blas_h
#define plate_impact_transient_blas_h

namespace PlateImpact
{
  /// Sets up the BLAS that the program is linked to for this process: one
  /// thread, and kernels of this processor. Idempotent.
  void
  prepare_blas();
} // namespace PlateImpact

#endif
