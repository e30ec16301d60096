import { type BufferGeometry, type Mesh, RedFormat, RGFormat } from 'three'
import type { ArrayTexture } from './material/array-texture.ts'
import { listTextures } from './material/wrinkle-textures.ts'
import { isReliefMesh } from './relief/is-relief-mesh.ts'
import type { WrinkledMesh } from './wrinkled-mesh.ts'

/** Cost of wrinkles, as of the last frame. */
export interface WrinkleStatistics {
  /** Number of areas (groups of wrinkles) with an activation (current strength) above 0, summed over all instances. */
  activeAreas: number
  /** Number of textures for the maps of the layers and for the areas. All faces with the same wrinkle set share these textures. */
  textures: number
  /** GPU memory of the textures in bytes, mipmaps included. */
  textureBytes: number
  /** Number of triangles drawn per instance. Relief increases it, because it splits triangles. */
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

/** Returns the GPU memory of a texture in bytes. Generated mipmaps add a third. */
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
