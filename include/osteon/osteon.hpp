// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// The front door: everything that a program needs, compiled once into the library osteon::osteon,
/// with nothing but the standard library in sight. The interface is provisional until version 1.
///
///     #include <osteon/osteon.hpp>
///
///     osteon::polygon plan = osteon::read_polygon("plan.wkt");  // or from points; throws
///     input_error
///     plan.set_weight(2, 0);                                    // edge 2 stands still: a gable
///     auto s = osteon::skeletonize(plan);  // {.region = ..., .until = 2.5, .kernel = ...}
///     for (auto arc : s.arcs()) draw(arc.source().point(), arc.target().point());
///     for (auto face : s.faces()) use(face.edge(), face.boundary());
///     auto rings = s.offsets({0.5, 1});
///     auto roof = s.roof({.slope = 0.8, .eaves = 3});
///     if (auto refuted = s.verify()) report(refuted->witness);
///
///     auto t = osteon::skeletonize(osteon::read_polyhedron("bunny.obj"),
///                                  {.prefer = osteon::split_preference::min_volume});
///     osteon::mesh shell = t.offset(0.1);  // closed, with a map to the input's facets
///
/// Inputs and results are values that own their data; nodes, arcs, faces, sheets and cells are
/// views that keep the data alive, so nothing dangles. Const members of all classes may be called
/// from several threads at once; results may be copied to other threads. Errors are those of
/// osteon/core/error.hpp. Points and times are doubles, and exact decimals on demand. Beside the
/// door is a window, osteon/inspect.hpp.

#include "osteon/core/error.hpp"
#include "osteon/door/choices.hpp"
#include "osteon/door/decimal.hpp"
#include "osteon/door/documents.hpp"
#include "osteon/door/elements.hpp"
#include "osteon/door/mesh.hpp"
#include "osteon/door/models.hpp"
#include "osteon/door/polygon.hpp"
#include "osteon/door/polygon_skeleton.hpp"
#include "osteon/door/polyhedron.hpp"
#include "osteon/door/polyhedron_skeleton.hpp"
