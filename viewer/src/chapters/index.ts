// SPDX-License-Identifier: MIT
import type { Chapter } from "../chapter";
import { bounding } from "./bounding";
import { broadPhase } from "./broad_phase";
import { closestPoints } from "./closest_points";
import { intersections } from "./intersections";
import { meshes } from "./meshes";
import { rays } from "./rays";
import { sceneView } from "./scene_view";
import { trees } from "./trees";
import { walk } from "./walk";

/** In the order of the tabs; the first is the default. */
export const chapters: readonly Chapter[] = [intersections, closestPoints, rays, walk, bounding, trees, broadPhase, meshes, sceneView];
