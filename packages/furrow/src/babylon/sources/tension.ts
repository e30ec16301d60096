import { VertexBuffer } from '@babylonjs/core/Buffers/buffer.js'
import type { AbstractMesh } from '@babylonjs/core/Meshes/abstractMesh.js'
import type { InputOf } from '../../drivers/activation.ts'
import type { InputReader } from '../../runtime/driver-runtime.ts'
import type { FaceGroup } from '../../runtime/face-group.ts'
import { sampledTension, tensionSurface } from '../../runtime/sampled-tension.ts'
import { sampledMesh, vertexData } from './surface.ts'

/** Properties of a face that are needed to read its inputs. */
export type DrivenFace = Pick<FaceGroup, 'getArea'> & { readonly mesh: AbstractMesh }

/** Creates a reader that measures tension (strain of the skin) on the CPU, on a few triangles per area after morph targets and skinning. */
export function bindTension(face: DrivenFace, inputs: readonly InputOf<'tension'>[]): InputReader<unknown> {
  const { mesh } = face
  const surface = tensionSurface(sampledMesh(mesh), inputs, (name) => face.getArea(name))
  const morphed = morphedPositions(mesh)
  const skinned = skinnedPositions(mesh)
  const reader = sampledTension(surface, inputs, (vertex, positions, offset) => {
    morphed(vertex, positions, offset)
    skinned(vertex, positions, offset)
  })
  return {
    ...reader,
    read(values, instance, engine) {
      mesh.skeleton?.prepare()
      reader.read(values, instance, engine)
    },
  }
}

/** Writes or deforms the position of one vertex. The position is stored at index `offset` of `positions`. */
type Deform = (vertex: number, positions: Float64Array, offset: number) => void

function morphedPositions(mesh: AbstractMesh): Deform {
  const rest = vertexData(mesh, VertexBuffer.PositionKind)
  const { morphTargetManager: targets } = mesh
  return (vertex, positions, offset) => {
    const count = targets?.numTargets ?? 0
    for (let axis = 0; axis < 3; axis++) positions[offset + axis] = rest[3 * vertex + axis]
    for (let i = 0; i < count; i++) {
      const target = targets!.getTarget(i)
      const moved = target.influence === 0 ? null : target.getPositions()
      if (!moved) continue
      for (let axis = 0; axis < 3; axis++) {
        const at = 3 * vertex + axis
        positions[offset + axis] += target.influence * (moved[at] - rest[at])
      }
    }
  }
}

function skinnedPositions(mesh: AbstractMesh): Deform {
  const { skeleton } = mesh
  if (!skeleton) return () => {}
  const bones = [VertexBuffer.MatricesIndicesKind, VertexBuffer.MatricesIndicesExtraKind].map((kind) =>
    vertexData(mesh, kind),
  )
  const weights = [VertexBuffer.MatricesWeightsKind, VertexBuffer.MatricesWeightsExtraKind].map((kind) =>
    vertexData(mesh, kind),
  )
  return (vertex, positions, offset) => {
    const matrices = skeleton.getTransformMatrices(mesh)
    const [x, y, z] = [positions[offset], positions[offset + 1], positions[offset + 2]]
    positions.fill(0, offset, offset + 3)
    for (let set = 0; set < weights.length; set++) {
      for (let at = 4 * vertex; at < Math.min(4 * vertex + 4, weights[set].length); at++) {
        const weight = weights[set][at]
        const m = 16 * bones[set][at]
        for (let axis = 0; axis < 3 && weight > 0; axis++) {
          positions[offset + axis] +=
            weight *
            (matrices[m + axis] * x +
              matrices[m + 4 + axis] * y +
              matrices[m + 8 + axis] * z +
              matrices[m + 12 + axis])
        }
      }
    }
  }
}
