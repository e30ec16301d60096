import type { InstancedMesh, Mesh } from 'three'
import { MorphActivation } from '../../drivers/morph.ts'
import { muscleLinks } from '../../drivers/muscles.ts'
import { driversOf } from '../../drivers/types.ts'
import { VrmWeights } from '../../drivers/vrm.ts'
import { addMuscles } from './muscles.ts'
import type { SourceType } from './source.ts'

/** Reads the mesh's blendshapes, of which each muscle becomes one. Instances that have weights of their own (`setMorphAt`) wrinkle by those. */
export const morphSource: SourceType = {
  types: ['morph', 'muscle'],
  create({ mesh }, drivers, { expressions }) {
    const muscles = driversOf('muscle', drivers)
    addMuscles(mesh, muscles)
    const own = targetNames(mesh)
    const vrm = expressions && new VrmWeights(expressions)
    const driver = new MorphActivation(
      [...driversOf('morph', drivers), ...muscleLinks(muscles)],
      vrm ? [...own, ...vrm.names] : own,
      driversOf('conflict', drivers),
    )
    const both = new Float32Array(vrm ? own.length + vrm.names.length : 0)
    return {
      driver,
      update(instance) {
        const { morphTargetInfluences, morphTexture } = mesh as Partial<InstancedMesh>
        // Each instance's row holds the share of the base shape, then those of the targets.
        if (morphTexture) driver.update(morphTexture.image.data!, instance * morphTexture.image.width + 1)
        else if (vrm) {
          for (let i = 0; i < own.length; i++) both[i] = morphTargetInfluences![i]
          vrm.writeTo(both, own.length)
          driver.update(both)
        } else if (morphTargetInfluences) driver.update(morphTargetInfluences)
      },
    }
  },
}

/** Names in the order of the weights. An `InstancedMesh` has no list of its own; its geometry may. */
function targetNames({ geometry, morphTargetDictionary }: Mesh): string[] {
  if (!morphTargetDictionary) return geometry.morphAttributes.position?.map(({ name }) => name) ?? []
  return Object.keys(morphTargetDictionary)
}
