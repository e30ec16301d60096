import { type BufferGeometry, type Mesh, RedFormat, RGFormat } from 'three'
import type { ArrayTexture } from './material/array-texture.ts'
import { listTextures } from './material/wrinkle-textures.ts'
import { isReliefMesh } from './relief/is-relief-mesh.ts'
import type { WrinkledMesh } from './wrinkled-mesh.ts'

/** Cost of wrinkles, as of the last frame. */
export interface WrinkleStatistics {
  /** Areas with an activation above 0, summed over all instances: the areas that an influence map is drawn from. */
  activeAreas: number
  /** Textures with the layers' maps and the areas. Faces made from one wrinkle set share them. */
  textures: number
  /** GPU memory of these textures in bytes, mipmaps included. */
  textureBytes: number
  /** Triangles of the meshes, per instance. Relief draws more than the meshes have. */
  triangles: number
}

/** Measures the cost of a mesh's wrinkles. Allocates. */
export function statisticsOf({ faces, meshes, shaderInputs }: WrinkledMesh): WrinkleStatistics {
  const textures = [...listTextures(shaderInputs.textures), shaderInputs.areas.texture]
  return {
    activeAreas: sum(faces, ({ activations, slots }) =>
      sum(slots.slots, (_, i) => Number(activations.values[i] > 0)),
    ),
    textures: textures.length,
    textureBytes: sum(textures, bytesOf),
    triangles: sum(meshes, trianglesDrawnFor),
  }
}

function trianglesDrawnFor(mesh: Mesh): number {
  const relief = mesh.children.filter(isReliefMesh) as Mesh[]
  return sum(relief.length > 0 ? relief : [mesh], ({ geometry }) => trianglesIn(geometry))
}

function trianglesIn({ index, attributes, drawRange }: BufferGeometry): number {
  const { count } = index ?? attributes.position
  return Math.floor(Math.min(count - drawRange.start, drawRange.count) / 3)
}

/** Mipmaps add a third, unless the file has them. */
function bytesOf({ image, mipmaps, format, generateMipmaps }: ArrayTexture): number {
  const files = mipmaps as { data: ArrayBufferView }[] | undefined
  if (files?.length) return sum(files, ({ data }) => data.byteLength)
  const { width, height, depth } = image as { width: number; height: number; depth: number }
  const channels = format === RedFormat ? 1 : format === RGFormat ? 2 : 4
  return Math.round(width * height * depth * channels * (generateMipmaps ? 4 / 3 : 1))
}

function sum<T>(items: readonly T[], measure: (item: T, index: number) => number): number {
  return items.reduce((total, item, i) => total + measure(item, i), 0)
}
