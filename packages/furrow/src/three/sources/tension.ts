import { type Mesh, type MeshStandardMaterial, Vector2, Vector3 } from 'three'
import { driversOf, type TensionDriver } from '../../core/driver-types.ts'
import { areasOf } from '../../drivers/driver.ts'
import { TensionActivation } from '../../drivers/tension.ts'
import { coverage, type SampledMesh, sampleCovered } from '../../drivers/tension-samples.ts'
import { trianglesOf } from '../coordinates.ts'
import type { WrinklesBase } from '../Wrinkles.ts'
import type { SourceType } from './source.ts'

/** Triangles that stand for an area: each costs three vertices, deformed by the processor as the mesh is. */
const SAMPLES = 16

/** What tension is measured on: a mesh at rest, and areas of it. */
export interface TenseMesh {
  sampled: SampledMesh
  /** Each once, and how much of each triangle it covers (`coverage`): nothing where its weights cannot be read. */
  areas: readonly { area: string; covered: Float64Array }[]
}

/** The areas of some drivers on their mesh; those of compressed textures cannot be read. */
export function tenseMesh(wrinkles: WrinklesBase, drivers: readonly TensionDriver[]): TenseMesh {
  const sampled = sampledMesh(wrinkles.mesh)
  const areas = areasOf(drivers).areaNames.map((area) => {
    const weights = wrinkles.getArea(area)?.weights
    const isReadable = weights && 'data' in weights
    return { area, covered: isReadable ? coverage(sampled, weights) : new Float64Array() }
  })
  return { sampled, areas }
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
  { sampled, areas }: TenseMesh,
  drivers: readonly TensionDriver[],
): { driver: TensionActivation; update(): void } {
  const samples = areas.map(({ area, covered }) => ({
    area,
    triangles: sampleCovered(sampled, covered, SAMPLES),
  }))
  const vertices = Uint32Array.from(new Set(samples.flatMap(({ triangles }) => [...triangles])))
  const places = new Map([...vertices].map((vertex, i) => [vertex, i]))
  const rest = Float64Array.from([...vertices].flatMap((vertex) => corner(sampled, vertex)))
  const bound = samples.map(({ area, triangles }) => ({
    area,
    triangles: triangles.map((vertex) => places.get(vertex)!),
  }))
  const driver = new TensionActivation(drivers, bound, rest)
  const positions = new Float64Array(rest.length)
  const at = new Vector3()
  return {
    driver,
    update() {
      for (let i = 0; i < vertices.length; i++) {
        mesh.getVertexPosition(vertices[i], at)
        positions[3 * i] = at.x
        positions[3 * i + 1] = at.y
        positions[3 * i + 2] = at.z
      }
      driver.update(positions)
    },
  }
}

function corner({ positions }: SampledMesh, vertex: number): number[] {
  return [positions[3 * vertex], positions[3 * vertex + 1], positions[3 * vertex + 2]]
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
