import { type Mesh, type MeshStandardMaterial, Vector2, Vector3 } from 'three'
import { areasOf } from '../../drivers/driver.ts'
import { TensionActivation } from '../../drivers/tension.ts'
import { coverage, type SampledMesh, sampleCovered } from '../../drivers/tension-samples.ts'
import { driversOf, type TensionDriver } from '../../drivers/types.ts'
import type { WrinklesBase } from '../wrinkles-base.ts'
import { trianglesOf } from './geometry-arrays.ts'
import type { SourceType } from './source.ts'

/** Triangles that stand for an area: each costs three vertices, deformed by the processor as the mesh is. */
const SAMPLES = 16

/** What tension is measured on. */
export interface TenseMesh {
  /** At rest. */
  sampled: SampledMesh
  /** How much of each triangle each area of the drivers covers (`areasOf`, `coverage`); nothing where that cannot be known. */
  covered: readonly Float64Array[]
}

/** The mesh of some drivers. Areas of compressed textures cannot be read. */
export function tenseMesh(wrinkles: WrinklesBase, drivers: readonly TensionDriver[]): TenseMesh {
  const sampled = sampledMesh(wrinkles.mesh)
  const covered = areasOf(drivers).areaNames.map((area) => {
    const weights = wrinkles.getArea(area)?.weights
    return weights && 'data' in weights ? coverage(sampled, weights) : new Float64Array()
  })
  return { sampled, covered }
}

/** Measures the mesh as skinning and blendshapes deform it, and its positions where something else does. */
export const tensionSource: SourceType = {
  types: ['tension'],
  create(wrinkles, drivers) {
    const own = driversOf('tension', drivers)
    return sampledTension(wrinkles.mesh, tenseMesh(wrinkles, own), own)
  },
}

/** Measures a few triangles of each area on the processor. */
export function sampledTension(
  mesh: Mesh,
  { sampled, covered }: TenseMesh,
  drivers: readonly TensionDriver[],
): { driver: TensionActivation; update(): void } {
  const samples = covered.map((shares) => sampleCovered(sampled, shares, SAMPLES))
  const vertices = Uint32Array.from(new Set(samples.flatMap((triangles) => [...triangles])))
  const places = new Map([...vertices].map((vertex, i) => [vertex, i]))
  const rest = Float64Array.from(
    [...vertices].flatMap((vertex) => [0, 1, 2].map((k) => sampled.positions[3 * vertex + k])),
  )
  const bound = areasOf(drivers).areaNames.map((area, i) => ({
    area,
    triangles: samples[i].map((vertex) => places.get(vertex)!),
  }))
  const driver = new TensionActivation(drivers, bound, rest)
  const positions = new Float64Array(rest.length)
  const at = new Vector3()
  return {
    driver,
    update() {
      for (let i = 0; i < vertices.length; i++) {
        mesh.getVertexPosition(vertices[i], at)
        at.toArray(positions, 3 * i)
      }
      driver.update(positions)
    },
  }
}

/** The mesh at rest, with the texture coordinates that the areas have: those of the normal map. */
function sampledMesh({ geometry, material }: Mesh): SampledMesh {
  const position = geometry.getAttribute('position')
  const { normalMap } = material as MeshStandardMaterial
  const uv = geometry.getAttribute(normalMap?.channel ? `uv${normalMap.channel}` : 'uv')
  const positions = new Float64Array(3 * position.count)
  const uvs = new Float64Array(2 * position.count)
  const place = new Vector2()
  normalMap?.updateMatrix()
  for (let i = 0; i < position.count; i++) {
    positions.set([position.getX(i), position.getY(i), position.getZ(i)], 3 * i)
    place.fromBufferAttribute(uv as never, i)
    if (normalMap) place.applyMatrix3(normalMap.matrix)
    uvs.set([place.x, place.y], 2 * i)
  }
  return { positions, uvs, triangles: trianglesOf(geometry) }
}
