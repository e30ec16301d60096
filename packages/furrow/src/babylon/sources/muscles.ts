import { VertexBuffer } from '@babylonjs/core/Buffers/buffer.js'
import type { AbstractMesh } from '@babylonjs/core/Meshes/abstractMesh.js'
import { MorphTarget } from '@babylonjs/core/Morph/morphTarget.js'
import { MorphTargetManager } from '@babylonjs/core/Morph/morphTargetManager.js'
import type { MuscleDriver } from '../../drivers/muscle/definition.ts'
import { muscleOffsets } from '../../drivers/muscle/offsets.ts'
import { morphNormalDeltas } from '../../math/deformed-normals.ts'
import { targetNames } from './morph.ts'
import { trianglesOf, vertexData } from './surface.ts'

/**
 * Adds a morph target with positions and normals to a mesh for each virtual muscle. The target has the name of the muscle, and its weight
 * is the contraction. Muscles whose name is already the name of a target are skipped. Instances share the targets of their source mesh.
 */
export function addMuscles(mesh: AbstractMesh, muscles: readonly MuscleDriver[]): void {
  const known = targetNames(mesh.morphTargetManager)
  const missing = muscles.filter(({ name }) => !known.includes(name))
  if (missing.length === 0) return
  mesh.morphTargetManager ??= new MorphTargetManager(mesh.getScene())
  const positions = vertexData(mesh, VertexBuffer.PositionKind)
  const normals = vertexData(mesh, VertexBuffer.NormalKind)
  const normalDeltas = morphNormalDeltas({ positions, normals, triangles: trianglesOf(mesh) })
  for (const muscle of missing) {
    const offsets = muscleOffsets(muscle, positions)
    const target = new MorphTarget(muscle.name, 0, mesh.getScene())
    target.setPositions(positions.map((value, i) => value + offsets[i]))
    const turned = normalDeltas(offsets)
    target.setNormals(normals.map((value, i) => value + turned[i]))
    mesh.morphTargetManager.addTarget(target)
  }
}
