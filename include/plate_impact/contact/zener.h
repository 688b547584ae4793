#pragma once

#include "plate_impact/contact/contact.h"
#include "plate_impact/contact/contact_history.h"
#include "plate_impact/plate/plate_section.h"

#include <cmath>
#include <limits>
#include <optional>

namespace PlateImpact
{
  /// The bending wave of a thin plate that a contact sends out.
  struct BendingWave
  {
    double length;      ///< [m]
    double group_speed; ///< [m/s]
  };

  /// What theory expects of an impact: Zener's equation on an infinite thin
  /// plate, whose response to a force at a point is the velocity
  /// F / (8 sqrt(D rho t)),
  ///   d(alpha)/dt = v - F(alpha) / (8 sqrt(D rho t)),  dv/dt = -F(alpha) / m
  /// (Zener, Phys. Rev. 59, 1941, doi:10.1103/PhysRev.59.669), until waves
  /// return from the edges, and for loads that spread over more than the
  /// thickness only approximately. Integrated by the energy-conserving contact
  /// step, for any law, to about 1e-5.
  class ZenerImpact
  {
  public:
    ZenerImpact(const Contact      &contact,
                const Impactor     &impactor,
                const PlateSection &section);

    Contact      contact; ///< before first touch
    Impactor     impactor;
    PlateSection section;
    ContactState peak; ///< time, force and indentation

    /// Twice the time to the peak. [s]
    double
    contact_time() const
    {
      return 2. * peak.time;
    }

    /// The peak with steps of a given length, as a scene takes them. [s]
    ContactState
    peak_in_steps(double time_step) const;

    /// The peak on a plate that does not move.
    ContactState
    peak_on_rigid_plate() const
    {
      PlateSection immovable = section;
      immovable.mass_per_area *= 1e12;
      return ZenerImpact(contact, impactor, immovable).peak;
    }

    /// Up to the end of the contact, or to a time; to an infinite one no
    /// further than a millionth of the energy remains, for a plate that gives
    /// way at once is never left. Energies are left out.
    ContactHistory
    history(double end_time) const;

    /// Rebound speed over impact speed; 0 below a thousandth.
    double
    restitution() const
    {
      const ContactState last =
        history(std::numeric_limits<double>::infinity()).states.back();
      return last.overlap() < 0. ? -last.impactor_velocity / impactor.velocity :
                                   0.;
    }

    /// When waves are back from an edge at a distance [m]. [s]
    double
    return_of_waves(const double distance) const
    {
      return 2. * distance / wave().group_speed;
    }

    /// Zener's dimensionless loss factor for a sphere under Hertz's law,
    ///   lambda = m / (8 T sqrt(D rho t)),  T = (m / (k sqrt(v)))^{2/5},
    /// on which alone the restitution depends; empty for other laws.
    std::optional<double>
    loss_factor() const;

    /// The step with which the peak force keeps to a relative tolerance. [s]
    double
    chosen_time_step(double tolerance) const;

    /// The wave whose half period is the contact time or another one [s]: phase
    /// speed sqrt(omega) (D / rho t)^{1/4}, group speed twice that (Graff, Wave
    /// Motion in Elastic Solids, sec. 4.2).
    BendingWave
    wave(const std::optional<double> &other = {}) const
    {
      const double half_period = other.value_or(contact_time());
      const double frequency   = std::acos(-1.) / half_period;
      const double speed       = std::sqrt(frequency) *
        std::pow(section.mean_bending_stiffness() / section.mass_per_area,
                 0.25);
      return {2. * half_period * speed, 2. * speed};
    }
  };
} // namespace PlateImpact
