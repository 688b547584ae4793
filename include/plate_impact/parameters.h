#ifndef plate_impact_parameters_h
#define plate_impact_parameters_h

#include <array>
#include <string>
#include <tuple>
#include <vector>

/// The entries of a scene, one struct per section. What an entry means, its
/// unit, its default and what is allowed is written once, where it is declared
/// (declarations.cc), and printed by `plate-impact defaults`. SI units.
namespace PlateImpact
{
  struct PlateParameters
  {
    std::array<double, 2>    side_lengths;
    double                   thickness;
    double                   youngs_modulus;
    double                   poissons_ratio;
    double                   density;
    double                   shear_correction_factor;
    std::vector<std::string> support; ///< one word, or x edges and y edges
  };

  struct ImpactorParameters
  {
    std::string shape;
    double      radius;
    double      length;
    double      mass;
    double      density;
    double      youngs_modulus;
    double      poissons_ratio;
    double      velocity;

    auto
    members() const
    {
      return std::tie(shape,
                      radius,
                      length,
                      mass,
                      density,
                      youngs_modulus,
                      poissons_ratio,
                      velocity);
    }
  };

  struct ContactParameters
  {
    std::string law;
    std::string load_distribution;
    double      patch_radius;
    std::string integration;

    auto
    members() const
    {
      return std::tie(law, load_distribution, patch_radius, integration);
    }
  };

  struct DiscretizationParameters
  {
    std::string                 element;
    std::array<unsigned int, 2> initial_cells;
    std::string                 linear_solver;
  };

  struct TimeParameters
  {
    double      end_time;
    double      time_step;
    double      step_tolerance;
    std::string integrator;
    double      ritz_tolerance;
    double      newmark_beta;
    double      newmark_gamma;

    auto
    members() const
    {
      return std::tie(end_time,
                      time_step,
                      step_tolerance,
                      integrator,
                      ritz_tolerance,
                      newmark_beta,
                      newmark_gamma);
    }
  };

  struct AdaptivityParameters
  {
    std::string  strategy;
    std::string  indicator;
    double       target_error;
    unsigned int maximum_cycles;
    unsigned int maximum_cells;
    double       size_exponent;
    double       minimum_cell_size;
    double       maximum_cell_size;
    double       refined_share_of_error;
    double       coarsened_share_of_error;
    double       refined_share_of_cells;
    double       coarsened_share_of_cells;
    unsigned int sampling_interval;
  };

  struct OutputParameters
  {
    std::string  directory;
    bool         write_meshes;
    bool         write_report;
    unsigned int field_samples;
  };

  struct ComparisonParameters
  {
    std::vector<std::string> strategies;
    std::vector<std::string> elements;
    unsigned int             maximum_cycles;
    double                   reference_peak_force;
    double                   time_budget;
  };

  struct SweepParameters
  {
    std::array<std::string, 3> entries;
    std::array<std::string, 3> values;
    std::string                combination;
    std::string                adapt;
    bool                       estimate_error;
    bool                       write_histories;
  };

  /// Sections are compared whole, so that a new entry is never forgotten where
  /// something is kept for the next impact: members() lists all (tested).
  template <typename Section>
  auto
  operator<(const Section &a, const Section &b)
    -> decltype(a.members() < b.members())
  {
    return a.members() < b.members();
  }

  struct Parameters
  {
    PlateParameters          plate;
    ImpactorParameters       impactor;
    ContactParameters        contact;
    DiscretizationParameters discretization;
    TimeParameters           time;
    AdaptivityParameters     adaptivity;
    OutputParameters         output;
    ComparisonParameters     comparison;
    SweepParameters          sweep;

    bool
    has_impactor() const
    {
      return impactor.shape != "none";
    }

    /// Whether adaptivity, report or fields ask for the error estimator.
    bool
    needs_estimator() const
    {
      return has_impactor() &&
        (adaptivity.strategy != "none" || output.write_report ||
         output.field_samples > 0);
    }
  };
} // namespace PlateImpact

#endif
