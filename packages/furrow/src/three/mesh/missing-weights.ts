import type { InstancedMesh, Mesh } from 'three'
import { formatProblem } from '../../core/error.ts'

/**
 * Sets the blendshape weights of an `InstancedMesh` to 0 and warns, if the mesh has no weights. An `InstancedMesh` has none by default, and
 * three.js throws when it draws blendshapes without weights.
 *
 * Call this function before each draw and not earlier: `WebGPURenderer` throws if a mesh has both shared weights and weights per instance.
 */
export function addMissingWeights(mesh: Mesh): void {
  const { isInstancedMesh, morphTexture, morphTargetInfluences } = mesh as Partial<InstancedMesh>
  if (!isInstancedMesh || morphTexture || morphTargetInfluences) return
  const targets = mesh.geometry.morphAttributes.position
  if (!targets?.length) return
  mesh.morphTargetInfluences = targets.map(() => 0)
  console.warn(
    formatProblem({
      who: 'Wrinkles',
      problem: 'an InstancedMesh has blendshapes and no weights, so that three.js cannot draw it',
      value: mesh.name,
      limit: 'morphTargetInfluences, or setMorphAt',
      remedy:
        'all instances now have weights of 0; set instances.morphTargetInfluences = mesh.morphTargetInfluences',
    }),
  )
}
