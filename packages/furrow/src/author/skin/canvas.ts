import { MIPMAP_MARGIN } from '../border.ts'
import { type Metric, type MetricMesh, MILLIMETRES_PER_METRE, surfaceMetric } from '../metric.ts'
import { checkCoverage } from './check-coverage.ts'
import { drawnTriangles, findOverlap } from './overlap.ts'
import { SkinTexels } from './skin-texels.ts'
import { pointAreas, type Skin, type SkinSurface, weldSurface } from './surface.ts'
import { type UvGrid, UvLocator, uvGridOf } from './uv-locator.ts'

/** Data for drawing wrinkles into a texture: the skin as a surface, and the mapping between texels and positions on the skin. */
export interface SkinCanvas {
  /** Surface in millimetres. */
  surface: SkinSurface
  locator: UvLocator
  texels: SkinTexels
  metric: Metric
  /** Millimetres per unit of the mesh's positions. */
  scale: number
}

/**
 * Prepares a mesh for drawing. Vertices with equal positions are merged, so that lines can cross UV seams. If the left and right halves of
 * the mesh share texels, only the left half (x > 0) is drawn. The canvas keeps the arrays `uvs` and `indices` of the mesh.
 *
 * @param width map width in texels; also the default height.
 * @param scale millimetres per unit of the mesh's positions.
 * @throws FurrowError if the mesh is inconsistent or covers no texel, or if the UV bounding boxes of its triangles have more than 128 times
 *   the texture's area in total.
 */
export function skinCanvas(
  mesh: MetricMesh,
  width: number,
  height = width,
  scale = MILLIMETRES_PER_METRE,
): SkinCanvas {
  const skin = {
    ...mesh,
    indices: mesh.indices ?? Array.from({ length: mesh.positions.length / 3 }, (_, i) => i),
  }
  checkCoverage(skin, 'skinCanvas')
  const metric = surfaceMetric(mesh, width, height, scale)
  const welded = weldSurface(skin)
  const points = welded.points.map((value) => scale * value)
  const surface = { ...welded, points, areas: pointAreas(points, welded.corners) }
  return { metric, scale, ...mapSkin(skin, surface, width, height) }
}

/** Builds `locator`, which finds the triangle at a UV point, and `texels`, which finds the position at each texel. */
export function mapSkin(
  skin: Pick<Skin, 'uvs' | 'indices'>,
  surface: SkinSurface,
  width: number,
  height = width,
): Omit<SkinCanvas, 'metric' | 'scale'> {
  const isDrawn = drawnTriangles(surface, findOverlap(skin, surface))
  return {
    surface,
    locator: new UvLocator(skin, surface, uvGridOf(skin, surface, isDrawn)),
    texels: new SkinTexels(skin, surface, width, height, isDrawn, MIPMAP_MARGIN),
  }
}

/** Data of a `SkinCanvas` that can be transferred between workers. */
export interface SkinCanvasArrays extends Pick<SkinCanvas, 'surface' | 'metric' | 'scale'> {
  /** Value of `UvLocator.grid`. */
  grid: UvGrid
  /** Value of `SkinTexels.owners`. */
  owners: Int32Array
}

export function canvasArrays({ locator, texels, ...plain }: SkinCanvas): SkinCanvasArrays {
  return { ...plain, grid: locator.grid, owners: texels.owners }
}

/** Rebuilds a canvas from the result of `canvasArrays` for the same skin. */
export function canvasFromArrays(
  skin: Pick<Skin, 'uvs' | 'indices'>,
  { grid, owners, ...plain }: SkinCanvasArrays,
): SkinCanvas {
  const { surface, metric } = plain
  return {
    ...plain,
    locator: new UvLocator(skin, surface, grid),
    texels: new SkinTexels(skin, surface, metric.width, metric.height, owners),
  }
}
