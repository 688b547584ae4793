#ifndef plate_impact_adaptation_ranked_refinement_h
#define plate_impact_adaptation_ranked_refinement_h

#include "plate_impact/adaptation/mesh_adaptation.h"

namespace PlateImpact
{
  /// Halves the cells with the largest errors that together hold a share of the
  /// squared error (Doerfler 1996, doi:10.1137/0733054), and doubles those with
  /// the smallest: deal.II's refine_and_coarsen_fixed_fraction(). One level a
  /// cycle.
  class FixedFraction : public MeshAdaptation
  {
  public:
    explicit FixedFraction(const AdaptivityParameters &adaptivity);

    bool
    adapt(dealii::Triangulation<2> &mesh,
          const ErrorOverLimit     &error,
          std::vector<std::string> &warnings) const override;

  private:
    const AdaptivityParameters adaptivity;
  };


  /// The same with shares of the number of cells:
  /// refine_and_coarsen_fixed_number().
  class FixedNumber : public MeshAdaptation
  {
  public:
    explicit FixedNumber(const AdaptivityParameters &adaptivity);

    bool
    adapt(dealii::Triangulation<2> &mesh,
          const ErrorOverLimit     &error,
          std::vector<std::string> &warnings) const override;

  private:
    const AdaptivityParameters adaptivity;
  };
} // namespace PlateImpact

#endif
