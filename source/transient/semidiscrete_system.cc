#include "plate_impact/transient/semidiscrete_system.h"

namespace PlateImpact
{
  namespace
  {
    /// The motion of a linear plate. A damping b K adds g b K, g =
    /// gamma/(beta dt), to the matrix of a step, which stays K + c M up to a
    /// factor. K z and M v follow from the solution of the step itself, so that
    /// a step costs one solve, one product with K and scalar products.
    class PlateStepper : public PlateMotion
    {
    public:
      PlateStepper(const NewmarkScheme &scheme, SemidiscreteSystem &plate)
        : scheme(scheme)
        , plate(plate)
        , damping(plate.damping)
        , stiffening(1. + damping * scheme.gamma / (scheme.beta * scheme.dt))
      {
        plate.solve(scheme.c0 / stiffening, plate.load, unit_response);
        unit_response /= stiffening;
        w_of_unit_response = plate.load.dot(unit_response);

        // at rest, without force
        z = v = Kz = Mv = Eigen::VectorXd::Zero(plate.load.size());
        if (scheme.gamma != 2. * scheme.beta)
          a = Ma = z;
        if (damping > 0. && !scheme.conserves_energy)
          Kv = Ka = z;
      }

      double
      begin_step(const double begin_force) override
      {
        const double c1 = scheme.c1, c2 = scheme.c2;
        right_hand_side =
          c1 * Mv - (1. + c2) * Kz + (c2 * begin_force) * plate.load;
        if (Kv.size() > 0)
          right_hand_side -= damping *
            ((c2 + 1. - scheme.gamma / scheme.beta) * Kv +
             scheme.dt * (1. - scheme.gamma / (2. * scheme.beta)) * Ka);
        const bool is_at_rest = increment.size() == 0;
        if (is_at_rest && begin_force == 0.)
          increment.setZero(z.size());
        else
          {
            plate.solve(scheme.c0 / stiffening, right_hand_side, increment);
            if (damping > 0.)
              increment /= stiffening;
          }
        return w + plate.load.dot(increment);
      }

      std::optional<double>
      end_step(const double at_begin, const double at_end) override
      {
        const double force = at_end + scheme.c2 * at_begin;
        if (force != 0.)
          {
            right_hand_side += force * plate.load;
            increment += force * unit_response;
          }

        const double beta = scheme.beta, gamma = scheme.gamma, dt = scheme.dt;
        plate.multiply_stiffness(increment, K_increment);
        z += increment;
        Kz += K_increment;
        w += plate.load.dot(increment);
        // under average acceleration d / dt is the mean of both rates
        if (damping > 0.)
          dissipated += damping / dt * increment.dot(K_increment);
        // M d = (K* d - (1 + g b) K d) / c_0
        right_hand_side -= stiffening * K_increment;
        // velocities by eqs. 3 and 4 in terms of the increment
        const double from_increment = gamma / (beta * dt),
                     from_v         = 1. - gamma / beta,
                     from_a         = dt * (1. - gamma / (2. * beta));
        const bool has_a            = a.size() > 0;
        const auto move             = [&](const Eigen::VectorXd &by,
                              Eigen::VectorXd       &rate,
                              Eigen::VectorXd       &acceleration) {
          if (!has_a)
            {
              rate = from_increment * by + from_v * rate;
              return;
            }
          const Eigen::VectorXd rate_begin = rate;
          rate = from_increment * by + from_v * rate + from_a * acceleration;
          acceleration =
            scheme.c0 * by - scheme.c1 * rate_begin - scheme.c2 * acceleration;
        };
        move(increment, v, a);
        Mv = from_increment / scheme.c0 * right_hand_side + from_v * Mv;
        if (has_a)
          {
            Mv += from_a * Ma;
            Ma = at_end * plate.load - Kz;
          }
        if (Kv.size() > 0)
          {
            move(K_increment, Kv, Ka);
            if (has_a)
              Ma -= damping * Kv;
          }
        return {};
      }

    private:
      const NewmarkScheme scheme;
      SemidiscreteSystem &plate;
      const double        damping;    ///< b [s]
      const double        stiffening; ///< 1 + g b

      Eigen::VectorXd a, Kv, Ka, Ma; ///< K v and K a: with damping
      Eigen::VectorXd right_hand_side, K_increment;
    };
  } // namespace



  std::unique_ptr<PlateMotion>
  SemidiscreteSystem::motion(const NewmarkScheme &scheme)
  {
    return std::make_unique<PlateStepper>(scheme, *this);
  }



  void
  step_under(const Eigen::VectorXd &forces,
             const NewmarkScheme   &scheme,
             SemidiscreteSystem    &plate,
             const std::function<void(Eigen::Index, const PlateMotion &)> &show)
  {
    const auto motion        = plate.motion(scheme);
    const bool acts_at_begin = scheme.integration.acts_at_begin;
    for (Eigen::Index k = 0; k < forces.size(); ++k)
      {
        // a force at the end of a step is one at the beginning of the next
        motion->begin_step(k == 0 || acts_at_begin ? 0. : forces[k - 1]);
        motion->end_step(acts_at_begin ? forces[k] : 0., forces[k]);
        show(k + 1, *motion);
      }
  }
} // namespace PlateImpact
