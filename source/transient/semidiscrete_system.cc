#include "plate_impact/transient/semidiscrete_system.h"

#include <algorithm>

namespace PlateImpact
{
  Eigen::MatrixXd
  SemidiscreteSystem::unknowns(
    const Eigen::Ref<const Eigen::MatrixXd> &states) const
  {
    return states;
  }



  SemidiscreteSystem::Span
  SemidiscreteSystem::span(
    const Eigen::Ref<const Eigen::MatrixXd> &states) const
  {
    return {states, Eigen::MatrixXd::Identity(states.cols(), states.cols())};
  }



  unsigned int
  SemidiscreteSystem::n_states_at_once() const
  {
    return std::clamp<Eigen::Index>(2400000 / load().size(), 1, 16);
  }
} // namespace PlateImpact
