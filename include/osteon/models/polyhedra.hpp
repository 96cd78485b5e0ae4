// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// Generated polyhedra with integer coordinates for tests, measurements and first steps. All are
/// exact and valid: closed surfaces that do not meet themselves, normals pointing outwards.

#include "osteon/models/grid_solids.hpp"
#include "osteon/models/high_degree.hpp"
#include "osteon/models/mesh_builder.hpp"
#include "osteon/models/prisms.hpp"
#include "osteon/models/symmetric_solids.hpp"
#include "osteon/models/voxels.hpp"
