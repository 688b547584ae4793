#pragma once

#include "plate_impact/base/choices.h"

#include <array>
#include <memory>
#include <string>
#include <tuple>
#include <vector>

/// The entries of a scene, one struct per section. What an entry means, its
/// unit, its default and what is allowed is written once, where it is declared
/// (declare_entries(), in the room of what the section configures), and printed
/// by `plate-impact defaults`. SI units.
namespace PlateImpact
{
  struct Entries;
  struct PlateFile;

  /// What the entry Plate/Outline says.
  struct Outline
  {
    PlateOutline shape = PlateOutline::rectangle;
    std::string  file; ///< of Gmsh, for the shape of that name
  };


  /// A support and the edge that it is on; empty: those of a file without
  /// names, the one edge or the x and the y edges.
  template <typename Support>
  struct OnEdge
  {
    std::string edge;
    Support     support;
  };


  /// A ply of a laminate, longitudinal (1) along its fibres. Taken apart by
  /// position in plate_entries.cc and ply.cc: mind the order.
  struct PlyParameters
  {
    double longitudinal_modulus;       ///< E_1
    double transverse_modulus;         ///< E_2
    double poissons_ratio;             ///< nu_12
    double in_plane_shear_modulus;     ///< G_12
    double longitudinal_shear_modulus; ///< G_13
    double transverse_shear_modulus;   ///< G_23
    // 0: derived (Ply)
    double through_thickness_modulus        = 0.; ///< E_3
    double through_thickness_poissons_ratio = 0.; ///< nu_13
    double transverse_poissons_ratio        = 0.; ///< nu_23
    double mode_2_toughness                 = 0.; ///< G_IIc; 0: not given
  };


  /// Angles of plies to x in degrees, from the struck face, and how they were
  /// written; none for a homogeneous isotropic plate.
  struct Layup
  {
    std::string         text;
    std::vector<double> angles;
  };


  struct PlateParameters
  {
    std::array<double, 2> side_lengths;
    double                thickness;
    double                youngs_modulus;
    double                poissons_ratio;
    double                density;
    double                yield_strength; ///< 0: not given
    double                loss_factor;    ///< at the first natural frequency
    double                shear_correction_factor; ///< 0: by equilibrium
    /// one, x edges and y edges, or those of a file by their names
    std::vector<OnEdge<EdgeSupport>> supports;
    /// of edges that hold the deflection
    std::vector<OnEdge<InPlaneSupport>> in_plane_supports = {
      {"", InPlaneSupport::held}};
    bool                  has_large_deflection = false; ///< von Karman
    std::array<double, 2> impact_point = {{0., 0.}};    ///< from the centre
    Outline               outline;
    Layup                 layup;
    PlyParameters         ply;

    void
    declare_entries(Entries &entries);

    // what follows from the entries
    bool is_skew = false;                  ///< the section mirrors in no line
    std::shared_ptr<const PlateFile> file; ///< for an outline from one

    bool
    is_laminate() const
    {
      return !layup.angles.empty();
    }

    bool
    is_circle() const
    {
      return outline.shape == PlateOutline::circle;
    }

    bool
    is_from_file() const
    {
      return outline.shape == PlateOutline::file;
    }
  };

  struct ImpactorParameters
  {
    ImpactorShape shape;
    double        radius;
    double        length;
    double        mass;
    double        density;
    double        youngs_modulus;
    double        poissons_ratio;
    double        yield_strength; ///< 0: does not yield
    double        velocity;

    // what follows from the entries
    double contact_radius = 0.; ///< at the expected peak [m]; 0: not known

    void
    declare_entries(Entries &entries);

    bool
    is_cylinder() const
    {
      return shape == ImpactorShape::cylinder;
    }

    /// Of the contact along x; 0 of a sphere. [m]
    double
    contact_half_length() const
    {
      return is_cylinder() ? 0.5 * length : 0.;
    }

    auto
    members() const
    {
      const auto &[a, b, c, d, e, f, g, h, i, derived] = *this;
      return std::tie(a, b, c, d, e, f, g, h, i);
    }
  };

  struct ContactParameters
  {
    ForceLaw         law;
    LocalResponse    local_response;
    bool             finite_ball; ///< beside a layer
    LoadShape        load_distribution;
    double           patch_radius;
    ForceIntegration integration;
    UnloadingLaw     unloading;
    double           critical_indentation;

    void
    declare_entries(Entries &entries);

    /// Whether the force spreads over an area that Patch radius measures.
    bool
    has_patch() const
    {
      return !load_is_singular() && !load_is_line();
    }

    /// Whether the energy around the load is infinite.
    bool
    load_is_singular() const
    {
      return load_distribution == LoadShape::point;
    }

    /// Whether the shear force jumps across the load.
    bool
    load_is_line() const
    {
      return load_distribution == LoadShape::line;
    }

    /// Whether the load has the length of a cylinder.
    bool
    load_has_length() const
    {
      return load_is_line() || load_distribution == LoadShape::strip;
    }

    auto
    members() const
    {
      const auto &[a, b, c, d, e, f, g, h] = *this;
      return std::tie(a, b, c, d, e, f, g, h);
    }
  };

  struct DiscretizationParameters
  {
    ElementType                 element;
    std::array<unsigned int, 2> initial_cells;
    SolverType                  linear_solver;

    void
    declare_entries(Entries &entries);

    // what follows from the entries
    PlateMass mass = PlateMass::consistent;
  };

  struct TimeParameters
  {
    double         end_time; ///< 0: that of the impact
    double         time_step;
    double         step_tolerance;
    IntegratorType integrator;
    double         ritz_tolerance;
    double         newmark_beta;
    double         newmark_gamma;

    void
    declare_entries(Entries &entries);

    // what follows from the entries
    bool   step_is_chosen = false; ///< by the program
    bool   end_is_chosen  = false; ///< that of the impact
    double end_of_vectors = 0.;    ///< of Ritz vectors, if after end_time

    /// The scheme of Newmark that conserves energy.
    bool
    is_average_acceleration() const
    {
      return newmark_beta == 0.25 && newmark_gamma == 0.5;
    }

    auto
    members() const
    {
      const auto &[a, b, c, d, e, f, g, derived_1, derived_2, derived_3] =
        *this;
      return std::tie(a, b, c, d, e, f, g);
    }
  };

  /// A point at which the exact stress has no bound.
  struct SingularPoint
  {
    std::array<double, 2> position; ///< in a mesh: from the impact [m]
    double                strength; ///< lambda; 0 of a point load [-]
  };


  /// What the entry Adaptivity/Singular points says.
  struct SingularPoints
  {
    bool are_found_automatically = true;
    /// Named ones, from the centre of the plate until the scene is complete;
    /// then as the mesh has them, and of an analysis all.
    std::vector<SingularPoint> points;
  };


  struct AdaptivityParameters
  {
    AdaptationStrategy strategy;
    AdaptationGoal     goal;
    ErrorIndicator     indicator;
    bool               patches_are_interior;
    double             target_error;
    double             target_peak_force_error;
    bool               verify;
    unsigned int       maximum_cycles;
    unsigned int       maximum_cells;
    double             size_exponent;
    SingularPoints     singular_points;
    /// those at a point load in eta and n, those at the minimum size in xi'
    bool         singular_cells_count;
    double       minimum_cell_size;
    bool         minimum_cell_size_is_chosen = false; ///< by the program
    double       maximum_cell_size;
    double       refined_share_of_error;
    double       coarsened_share_of_error;
    double       refined_share_of_cells;
    double       coarsened_share_of_cells;
    unsigned int sampling_interval;

    void
    declare_entries(Entries &entries);

    /// What the goal asks for, a fraction.
    double
    target() const
    {
      return goal == AdaptationGoal::peak_force ? target_peak_force_error :
                                                  target_error;
    }

    /// Whether the mesh follows its error.
    bool
    is_adaptive() const
    {
      return strategy != AdaptationStrategy::none;
    }

    /// Whether it does so for the peak force.
    bool
    is_for_peak_force() const
    {
      return is_adaptive() && goal == AdaptationGoal::peak_force;
    }
  };

  struct OutputParameters
  {
    std::string  directory;
    bool         write_meshes;
    bool         write_report;
    unsigned int field_samples;
    unsigned int natural_frequencies;

    void
    declare_entries(Entries &entries);
  };

  struct ComparisonParameters
  {
    std::vector<ComparedStrategy> strategies;
    std::vector<ElementType>      elements;
    unsigned int                  maximum_cycles;
    double                        reference_peak_force;
    double                        time_budget;

    void
    declare_entries(Entries &entries);
  };

  struct SweepParameters
  {
    std::array<std::string, 3> entries;
    std::array<std::string, 3> values;
    bool                       is_zip; ///< or every value with every other
    bool                       adapts_each_point; ///< or the worst one of them
    bool                       estimate_error;
    bool                       write_histories;

    void
    declare_entries(Entries &entries);
  };

  /// Sections are compared whole, so that a new entry is never forgotten where
  /// something is kept for the next impact: members() binds all of them, which
  /// does not compile with another number, and ties the entries, which are
  /// declared first.
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
      return impactor.shape != ImpactorShape::none;
    }

    /// Whether adaptivity, report or fields ask for the error estimator.
    bool
    needs_estimator() const
    {
      return has_impactor() &&
        (adaptivity.is_adaptive() || output.write_report ||
         output.field_samples > 0);
    }
  };
} // namespace PlateImpact
