// A plate that is softer along some of its motions, with matrices of a few
// unknowns.
#include "plate_impact/base/exceptions.h"
#include "plate_impact/transient/softened_system.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <gtest/gtest.h>

#include <limits>

namespace PlateImpact
{
  namespace
  {
    struct DenseSystem : public SemidiscreteSystem
    {
      explicit DenseSystem(const Eigen::MatrixXd &K)
        : SemidiscreteSystem(Eigen::VectorXd::Unit(K.rows(), 0))
        , K(K)
        , M(Eigen::VectorXd::LinSpaced(K.rows(), 1., 2.).asDiagonal())
      {}

      void
      multiply_stiffness(const Eigen::VectorXd &x,
                         Eigen::VectorXd       &y) const override
      {
        y = K * x;
      }

      void
      multiply_mass(const Eigen::VectorXd &x, Eigen::VectorXd &y) const override
      {
        y = M * x;
      }

      void
      solve(const double           c,
            const Eigen::VectorXd &b,
            Eigen::VectorXd       &x) override
      {
        x = (K + c * M).llt().solve(b);
      }

      const Eigen::MatrixXd K, M;
    };



    Eigen::MatrixXd
    stiffness_of(const SemidiscreteSystem &system)
    {
      const Eigen::Index n = system.load.size();
      Eigen::MatrixXd    result(n, n);
      Eigen::VectorXd    column;
      for (Eigen::Index i = 0; i < n; ++i)
        {
          system.multiply_stiffness(Eigen::VectorXd::Unit(n, i), column);
          result.col(i) = column;
        }
      return result;
    }



    class SoftenedSystemTest : public ::testing::Test
    {
    protected:
      SoftenedSystemTest()
      {
        std::srand(1); // of Eigen's Random
        Eigen::MatrixXd of_missed;
        root      = Eigen::MatrixXd::Random(6, 6);
        motions   = Eigen::MatrixXd::Random(6, 3);
        of_missed = Eigen::MatrixXd::Random(3, 3);
        missed    = of_missed * of_missed.transpose();
        masses    = 0.5 * motions.transpose() * motions;
      }

      MissedByMesh
      by_mesh(const Eigen::MatrixXd &energies) const
      {
        return {motions, energies, masses};
      }

      Eigen::MatrixXd root, motions, missed, masses;
    };



    TEST_F(SoftenedSystemTest, HasTheComplianceThatIsMissed)
    {
      DenseSystem           plate(root * root.transpose());
      const Eigen::MatrixXd S = motions.transpose() * plate.K * motions,
                            Z = motions * S.inverse(),
                            expected =
                              plate.K.inverse() + Z * missed * Z.transpose();
      const SoftenedSystem softer(plate, by_mesh(missed));
      EXPECT_LT((stiffness_of(softer).inverse() - expected).norm(),
                1e-7 * expected.norm());
      EXPECT_EQ(softer.load, plate.load);
    }



    TEST_F(SoftenedSystemTest, LosesTheEnergiesThatAreMissed)
    {
      DenseSystem           plate(root * root.transpose());
      const Eigen::MatrixXd S    = motions.transpose() * plate.K * motions;
      const auto            lost = [&](const Eigen::MatrixXd &E) {
        return Eigen::MatrixXd(
          S -
          motions.transpose() *
            stiffness_of(SoftenedSystem(plate, by_mesh(E))) * motions);
      };
      EXPECT_LT((lost(1e-3 * missed) - 1e-3 * missed).norm(),
                3e-3 * missed.norm());
      // half of it where a mesh misses as much as it has
      EXPECT_LT((lost(S) - 0.5 * S).norm(), 1e-8 * S.norm());
      EXPECT_LT(lost(0. * S).norm(), 1e-12 * S.norm());
    }



    TEST_F(SoftenedSystemTest, LosesTheMassesThatAreMissed)
    {
      DenseSystem           plate(root * root.transpose());
      const SoftenedSystem  lighter(plate, by_mesh(0. * missed));
      const Eigen::MatrixXd m        = motions.transpose() * plate.M * motions;
      Eigen::MatrixXd       products = motions;
      Eigen::VectorXd       product;
      for (Eigen::Index i = 0; i < 3; ++i)
        {
          lighter.multiply_mass(motions.col(i), product);
          products.col(i) = product;
        }
      EXPECT_LT((motions.transpose() * products - (m - masses)).norm(),
                1e-12 * m.norm());
      // motions that have no mass in common with these lose nothing
      const Eigen::VectorXd x     = Eigen::VectorXd::Random(6),
                            apart = x -
        motions * m.inverse() * motions.transpose() * plate.M * x;
      lighter.multiply_mass(apart, product);
      EXPECT_LT((product - plate.M * apart).norm(), 1e-12 * x.norm());
    }



    TEST_F(SoftenedSystemTest, SolvesForEveryShift)
    {
      DenseSystem           plate(root * root.transpose());
      SoftenedSystem        softer(plate, by_mesh(missed));
      const Eigen::VectorXd x = Eigen::VectorXd::Random(6);
      Eigen::VectorXd       b, solved;
      for (const double c : {0.1, 10., 0.1})
        {
          Eigen::VectorXd inertia;
          softer.multiply_stiffness(x, b);
          softer.multiply_mass(x, inertia);
          b += c * inertia;
          softer.solve(c, b, solved);
          EXPECT_LT((solved - x).norm(), 1e-9 * x.norm()) << c;
        }
    }



    TEST_F(SoftenedSystemTest, TakesMotionsThatDependOnEachOther)
    {
      DenseSystem     plate(root * root.transpose());
      Eigen::MatrixXd combined(3, 5);
      combined << Eigen::Matrix3d::Identity(),
        Eigen::MatrixXd::Constant(3, 1, 2.), Eigen::MatrixXd::Zero(3, 1);
      const Eigen::MatrixXd expected =
        stiffness_of(SoftenedSystem(plate, by_mesh(missed)));
      EXPECT_LT((stiffness_of(
                   SoftenedSystem(plate,
                                  {motions * combined,
                                   combined.transpose() * missed * combined,
                                   combined.transpose() * masses * combined})) -
                 expected)
                  .norm(),
                1e-6 * expected.norm());
    }



    TEST_F(SoftenedSystemTest, RefusesEnergiesThatAreNotFinite)
    {
      DenseSystem plate(root * root.transpose());
      missed(0, 0) = std::numeric_limits<double>::quiet_NaN();
      EXPECT_THROW(SoftenedSystem(plate, by_mesh(missed)), ComputationError);
      EXPECT_THROW(SoftenedSystem(plate, {0. * motions, 0. * missed, masses}),
                   ComputationError);
    }



    /// A plate that is free to move has no energy in a motion as a rigid body.
    TEST_F(SoftenedSystemTest, LeavesRigidMotionsFree)
    {
      Eigen::VectorXd       rigid = Eigen::VectorXd::Ones(6).normalized();
      const Eigen::MatrixXd across =
        Eigen::MatrixXd::Identity(6, 6) - rigid * rigid.transpose();
      DenseSystem plate(across * root * root.transpose() * across);
      motions.col(0) = rigid;
      missed.row(0).setZero();
      missed.col(0).setZero();
      const SoftenedSystem  softer(plate, by_mesh(missed));
      const Eigen::MatrixXd K = stiffness_of(softer);
      ASSERT_TRUE(K.allFinite());
      EXPECT_LT((K * rigid).norm(), 1e-6 * K.norm());
      EXPECT_LT(K.trace(), plate.K.trace());
    }
  } // namespace
} // namespace PlateImpact
