// Precompiled: what most tests include and takes long to compile.
#include <deal.II/base/function.h>
#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_tools.h>

#include "plate_impact/error_estimator.h"
#include "plate_impact/plate_mesh.h"
#include "plate_impact/plate_model.h"

#include <Eigen/Dense>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
