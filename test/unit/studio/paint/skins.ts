import type { GrayImage } from 'furrow'
import { BufferGeometry, Float32BufferAttribute, Mesh, MeshStandardMaterial, Ray, Vector3 } from 'three'
import { BRUSH_DEFAULTS, type Brush } from '../../../../studio/src/paint/brush.ts'
import { BrushStroke } from '../../../../studio/src/paint/brush-stroke.ts'
import { makeSkin, type SkinData } from '../../../../studio/src/paint/make-skin.ts'
import type { PaintMap } from '../../../../studio/src/paint/paint-map.ts'
import { PaintSkin, type SkinPoint } from '../../../../studio/src/paint/paint-skin.ts'
import { SkinPicker } from '../../../../studio/src/paint/picker.ts'
import { type MeshSkin, readSkin } from '../../../../studio/src/paint/read-skin.ts'
import type { StagePointer } from '../../../../studio/src/tools/stage-tool.ts'

/** Point of a grid: its position in millimetres and its texture coordinates. */
type GridPoint = readonly [x: number, y: number, z: number, u: number, v: number]

/** Makes a mesh of grids of n x m squares. Each grid has its own vertices. Converts the millimetres of `at` to metres, as in glTF. */
export function meshOf(
  ...grids: readonly { n: number; m: number; at(i: number, j: number): GridPoint }[]
): Mesh<BufferGeometry, MeshStandardMaterial> {
  const [positions, uvs, indices]: number[][] = [[], [], []]
  for (const { n, m, at } of grids) {
    const first = positions.length / 3
    for (let j = 0; j <= m; j++) {
      for (let i = 0; i <= n; i++) {
        const [x, y, z, u, v] = at(i / n, j / m)
        positions.push(...[x, y, z].map((value) => Math.round(1e6 * value) / 1e9))
        uvs.push(u, v)
        const [p, above] = [first + j * (n + 1) + i, first + (j + 1) * (n + 1) + i]
        if (i < n && j < m) indices.push(p, p + 1, above + 1, p, above + 1, above)
      }
    }
  }
  const geometry = new BufferGeometry()
  geometry.setAttribute('position', new Float32BufferAttribute(positions, 3))
  geometry.setAttribute('uv', new Float32BufferAttribute(uvs, 2))
  geometry.setIndex(indices)
  return new Mesh(geometry, new MeshStandardMaterial())
}

/** Sheet of 100 x 100 mm that faces +z. Its two islands meet at y = 10. In the texture, the upper one is rotated and larger. */
export const cutSheet = () =>
  meshOf(
    { n: 20, m: 12, at: (i, j) => [100 * i - 50, 60 * j - 50, 0, 0.02 + 0.45 * i, 0.98 - 0.3 * j] },
    { n: 20, m: 8, at: (i, j) => [100 * i - 50, 10 + 40 * j, 0, 0.98 - 0.4 * j, 0.02 + 0.9 * i] },
  )

/** Sheet of 100 x 100 mm that fills its texture. */
export const plainSheet = () =>
  meshOf({ n: 20, m: 20, at: (i, j) => [100 * i - 50, 100 * j - 50, 0, i, 1 - j] })

/** Two sheets 1 mm apart, like lips. Only a strip where x > 40 joins them. */
export const lips = () =>
  meshOf(
    { n: 20, m: 10, at: (i, j) => [100 * i - 50, 50 * j + 0.5, 0, 0.05 + 0.9 * i, 0.45 - 0.4 * j] },
    { n: 20, m: 10, at: (i, j) => [100 * i - 50, 50 * j - 50.5, 0, 0.05 + 0.9 * i, 0.95 - 0.4 * j] },
    { n: 2, m: 1, at: (i, j) => [40 + 10 * i, j - 0.5, 0, 0.86 + 0.09 * i, 0.55 - 0.1 * j] },
  )

/** Sheet whose left and right halves share their texels. */
export const foldedSheet = () =>
  meshOf(
    { n: 10, m: 20, at: (i, j) => [50 * i, 100 * j - 50, 0, 0.05 + 0.9 * i, 0.95 - 0.9 * j] },
    { n: 10, m: 20, at: (i, j) => [50 * i - 50, 100 * j - 50, 0, 0.95 - 0.9 * i, 0.95 - 0.9 * j] },
  )

/** Sphere of radius 50 mm around the origin. Its front is one island, and its back another. */
export const ball = () => {
  const half = (sign: number, u0: number) => ({
    n: 24,
    m: 24,
    at: (i: number, j: number): GridPoint => {
      // Longitude increases from left to right, seen from outside. The poles are at the top and the bottom.
      const [longitude, latitude] = [Math.PI * (i - 0.5), Math.PI * (j - 0.5)]
      const [x, z] = [Math.sin(longitude), Math.cos(longitude)].map(
        (value) => sign * 50 * Math.cos(latitude) * value,
      )
      return [x, 50 * Math.sin(latitude), z, u0 + 0.44 * i, 0.95 - 0.9 * j]
    },
  })
  return meshOf(half(1, 0.03), half(-1, 0.53))
}

export function paintSkin(mesh: Mesh, ...parts: Mesh[]): PaintSkin & { meshes: MeshSkin; made: SkinData } {
  const meshes = readSkin([mesh, ...parts])
  const made = makeSkin(meshes.skin)
  return Object.assign(new PaintSkin(meshes.skin, made.surface), { meshes, made })
}

/** Returns the skin of meshes, and a picker of its points. */
export function pickerOf(mesh: Mesh, ...parts: Mesh[]) {
  const skin = paintSkin(mesh, ...parts)
  return { skin, picker: new SkinPicker(skin.meshes, skin, skin.made) }
}

/** Ray along -z that starts 5 m in front of a position. */
export const rayAt = (x: number, y: number) => new Ray(new Vector3(x, y, 5), new Vector3(0, 0, -1))

/** Event of a pointer that is over a position in metres. */
export const pointerAt = (x: number, y: number, others: Partial<StagePointer> = {}): StagePointer => ({
  ray: rayAt(x, y),
  pressure: 1,
  x: 0,
  y: 0,
  shift: false,
  alt: false,
  ...others,
})

/** Paints a stroke through points of a skin at full flow, and returns the weights. */
export function paint(
  image: GrayImage,
  settings: Partial<Brush>,
  skin: PaintSkin,
  ...points: readonly (SkinPoint | undefined)[]
): GrayImage {
  const stroke = new BrushStroke(image, { ...BRUSH_DEFAULTS, flow: 1, ...settings }, skin)
  for (const point of points) stroke.moveTo(point)
  return stroke.end().image
}

export function empty(size: number, weight = 0): GrayImage {
  return { width: size, height: size, data: new Uint8Array(size * size).fill(weight) }
}

/** Yields each point of the skin that a texel covers, with the texel and its weight. */
export function* placesOf(map: PaintMap, { data }: GrayImage) {
  for (let triangle = 0; triangle + 1 < map.starts.length; triangle++) {
    for (let place = map.starts[triangle]; place < map.starts[triangle + 1]; place++) {
      const [x, y, z] = map.positions.subarray(3 * place, 3 * place + 3)
      const isBeyondIsland = map.isBeyondIsland[place] === 1
      yield { triangle, x, y, z, isBeyondIsland, texel: map.texels[place], weight: data[map.texels[place]] }
    }
  }
}

/** Returns only the points of `placesOf` that are on the islands of the texture. */
export const onIslands = (skin: PaintSkin, image: GrayImage) =>
  [...placesOf(skin.mapOf(image.width), image)].filter(({ isBeyondIsland }) => !isBeyondIsland)

/** Returns the point of a skin nearest to a position. */
export const pointNear = (skin: PaintSkin, x: number, y: number, z = 0): SkinPoint =>
  skin.mirrored([-x, y, z])
