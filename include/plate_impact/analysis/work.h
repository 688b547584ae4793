#ifndef plate_impact_analysis_work_h
#define plate_impact_analysis_work_h

namespace PlateImpact
{
  /// What a scene paid for.
  struct Work
  {
    unsigned int factorizations    = 0;
    unsigned int linear_solves     = 0;
    unsigned int contact_steps     = 0; ///< with a force other than zero
    unsigned int estimator_samples = 0;
    unsigned int ritz_vectors      = 0;
  };

  /// Wall time of the stages of a cycle, every second in one of them. [s]
  struct Seconds
  {
    double mesh = 0., assembly = 0., factorization = 0., stepping = 0.,
           estimation = 0., output = 0.;

    double
    total() const
    {
      return mesh + assembly + factorization + stepping + estimation + output;
    }

    Seconds &
    operator+=(const Seconds &other)
    {
      mesh += other.mesh;
      assembly += other.assembly;
      factorization += other.factorization;
      stepping += other.stepping;
      estimation += other.estimation;
      output += other.output;
      return *this;
    }
  };
} // namespace PlateImpact

#endif
