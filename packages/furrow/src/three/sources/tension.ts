import { type Material, type Mesh, Vector3 } from 'three'
import type { InputOf } from '../../drivers/activation.ts'
import type { SampledMesh } from '../../drivers/tension/samples.ts'
import type { InputReader } from '../../runtime/driver-runtime.ts'
import type { FaceGroup } from '../../runtime/face-group.ts'
import {
  tensionSurface as surfaceOf,
  type TensionSurface,
  sampledTension as tensionOf,
} from '../../runtime/sampled-tension.ts'
import { wrinkleUvs } from '../mesh/wrinkle-uvs.ts'
import type { AnyRenderer } from '../renderer.ts'
import { trianglesOf } from './geometry-arrays.ts'

export { indexIn, type MeasuredArea, type TensionSurface } from '../../runtime/sampled-tension.ts'

/** Properties of a face that tension measurement needs. Only measurement on the GPU needs `onRelease`. */
export type DrivenFace = Pick<FaceGroup, 'getArea'> &
  Partial<Pick<FaceGroup, 'onRelease'>> & { readonly mesh: Mesh }

/** Creates a reader of tension inputs, which measures on the CPU or GPU how much the skin under areas is compressed or stretched. */
export type BindTension = (
  face: DrivenFace,
  inputs: readonly InputOf<'tension'>[],
) => InputReader<AnyRenderer>

export function tensionSurface(face: DrivenFace, inputs: readonly InputOf<'tension'>[]): TensionSurface {
  if (inputs.length === 0) return { sampled: EMPTY, measured: [] }
  return surfaceOf(sampledMesh(face.mesh), inputs, (name) => face.getArea(name))
}

const EMPTY: SampledMesh = { positions: [], uvs: [], triangles: [] }

/** Measures tension on the CPU, after blendshapes and skinning. */
export const bindTension: BindTension = (face, inputs) =>
  sampledTension(face.mesh, tensionSurface(face, inputs), inputs)

/** Creates a reader of tension inputs, which measures a few triangles of each area on the CPU. */
export function sampledTension(
  mesh: Mesh,
  surface: TensionSurface,
  inputs: readonly InputOf<'tension'>[],
): InputReader<unknown> {
  const position = new Vector3()
  return tensionOf(surface, inputs, (vertex, positions, offset) => {
    mesh.getVertexPosition(vertex, position)
    position.toArray(positions, offset)
  })
}

/** Copies a mesh at rest, with the texture coordinates at which areas are sampled. */
function sampledMesh(mesh: Mesh): SampledMesh {
  const position = mesh.geometry.getAttribute('position')
  const positions = new Float64Array(3 * position.count)
  for (let i = 0; i < position.count; i++) {
    positions.set([position.getX(i), position.getY(i), position.getZ(i)], 3 * i)
  }
  return {
    positions,
    uvs: wrinkleUvs(mesh, mesh.material as Material),
    triangles: trianglesOf(mesh.geometry),
  }
}
