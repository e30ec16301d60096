import { MIPMAP_MARGIN } from '../border.ts'
import { type Metric, type MetricMesh, MILLIMETRES_PER_METRE, surfaceMetric } from '../metric.ts'
import { checkCoverage } from './check-coverage.ts'
import { drawnTriangles, findOverlap } from './overlap.ts'
import { SkinTexels } from './skin-texels.ts'
import { pointAreas, type Skin, type SkinSurface, weldSurface } from './surface.ts'
import { type UvGrid, UvLocator, uvGridOf } from './uv-locator.ts'

/** Canvas for strokes: the skin as a surface, and the positions of a map's texels on it. */
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
 * Prepares a mesh for drawing. Vertices at one position are one point of the skin, so lines cross UV seams. If the left and right halves
 * share texels, the left one (x > 0) is drawn.
 *
 * @param width map width in texels; also the default height.
 * @param scale millimetres per unit of the mesh's positions.
 * @throws FurrowError like `surfaceMetric`, or if hundreds of triangles overlap in UV space.
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

/** Locates the texels of a map on a skin, and UV points on it. */
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

/** Canvas as arrays that a worker can transfer. */
export interface SkinCanvasArrays extends Pick<SkinCanvas, 'surface' | 'metric' | 'scale'> {
  /** Grid of the locator. */
  grid: UvGrid
  /** Owners of the texels. */
  owners: Int32Array
}

export function canvasArrays({ locator, texels, ...plain }: SkinCanvas): SkinCanvasArrays {
  return { ...plain, grid: locator.grid, owners: texels.owners }
}

/** Restores the canvas of a skin from its arrays. */
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
