import type { InstancedMesh, Mesh } from 'three'
import { sentence } from '../core/error.ts'
import { isMorphDriver, type WrinkleDriver } from '../core/wrinkle-maps.ts'
import { MorphActivation } from '../drivers/morph.ts'
import type { WrinklesBase } from './Wrinkles.ts'

/**
 * Lets a mesh's blendshapes move its wrinkles, by themselves, each time before the mesh is drawn, as long as
 * `wrinkles.driven` is true and the wrinkles are not disposed of. Instances that have weights of their own
 * (`setMorphAt`) wrinkle by those.
 *
 * @param drivers of the file; types this version does not know are left out with a warning, and so are targets
 *   that the mesh does not have.
 */
export function driveByMorphs(wrinkles: WrinklesBase, drivers: readonly WrinkleDriver[]): void {
  const { mesh } = wrinkles
  const morph = new MorphActivation(drivers.filter(isMorphDriver), targetNames(mesh))
  warnOfUnknown(mesh, morph, drivers)
  if (morph.areaNames.length === 0) return
  const { areaNames, activations } = morph
  wrinkles.onDrive((instance) => {
    const { morphTargetInfluences, morphTexture } = mesh as Partial<InstancedMesh>
    // Each instance's row holds the share of the base shape, then those of the targets.
    if (morphTexture) morph.update(morphTexture.image.data!, instance * morphTexture.image.width + 1)
    else if (morphTargetInfluences) morph.update(morphTargetInfluences)
    else return
    for (let i = 0; i < areaNames.length; i++) {
      // An area may have been removed since; the others go on.
      if (wrinkles.hasArea(areaNames[i])) wrinkles.setActivation(areaNames[i], activations[i], instance)
    }
  })
}

/** Names in the order of the weights. An `InstancedMesh` has no list of its own; its geometry may. */
function targetNames({ geometry, morphTargetDictionary }: Mesh): string[] {
  if (!morphTargetDictionary) return geometry.morphAttributes.position?.map(({ name }) => name) ?? []
  return Object.keys(morphTargetDictionary)
}

function warnOfUnknown(mesh: Mesh, morph: MorphActivation, drivers: readonly WrinkleDriver[]): void {
  const types = drivers
    .filter((driver) => !isMorphDriver(driver))
    .map(({ type }) => `driver of type "${type}"`)
  const targets = morph.unknownTargets.map((name) => `target "${name}"`)
  if (types.length + targets.length === 0) return
  console.warn(
    sentence({
      who: 'Wrinkles',
      what: `the drivers of mesh "${mesh.name}" name what is not here`,
      value: [...types, ...targets].join(', '),
      remedy: 'the others move their areas all the same',
    }),
  )
}
