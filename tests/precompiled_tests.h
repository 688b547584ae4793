// Precompiled: what most tests include and takes long to compile.
#include <deal.II/base/function.h>
#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_tools.h>

#include "plate_impact/estimator/energy_norm_estimator.h"
#include "plate_impact/plate/plate_discretization.h"
#include "plate_impact/plate/plate_mesh.h"

#include <Eigen/Dense>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
