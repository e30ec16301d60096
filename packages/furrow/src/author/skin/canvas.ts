import { MIPMAP_MARGIN } from '../border.ts'
import { type Metric, type MetricMesh, MILLIMETRES_PER_METRE, surfaceMetric } from '../metric.ts'
import { checkCoverage } from './check-coverage.ts'
import { drawnTriangles, findOverlap } from './overlap.ts'
import { SkinTexels } from './skin-texels.ts'
import { pointAreas, type Skin, type SkinSurface, weldSurface } from './surface.ts'
import { type UvGrid, UvLocator, uvGridOf } from './uv-locator.ts'

/** What strokes are drawn on: the skin as a surface, and where on it the texels of a map are. */
export interface SkinCanvas {
  /** In millimetres. */
  surface: SkinSurface
  locator: UvLocator
  texels: SkinTexels
  metric: Metric
  /** Millimetres per unit of the mesh's positions. */
  scale: number
}

/**
 * Prepares a mesh to be drawn on. Vertices at one position are one point of the skin, so that lines run on across the seams of the texture;
 * where the left and the right half use the same texels, the left one (x > 0) is drawn.
 *
 * @param width in texels, as is height.
 * @param scale millimetres per unit of the mesh's positions.
 * @throws FurrowError as `surfaceMetric` does, and where triangles lie on top of each other in the texture by the hundred.
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

/** Finds the texels of a skin in a map, and its points in the texture. */
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

/** A canvas as arrays that a worker can hand over. */
export interface SkinCanvasArrays extends Pick<SkinCanvas, 'surface' | 'metric' | 'scale'> {
  /** Of its locator. */
  grid: UvGrid
  /** Of its texels. */
  owners: Int32Array
}

export function canvasArrays({ locator, texels, ...plain }: SkinCanvas): SkinCanvasArrays {
  return { ...plain, grid: locator.grid, owners: texels.owners }
}

/** The canvas that arrays were made of. @param skin that of the canvas. */
export function canvasAgain(
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
