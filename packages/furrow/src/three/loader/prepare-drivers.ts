import type { Mesh } from 'three'
import type { GLTFParser } from 'three/addons/loaders/GLTFLoader.js'
import type { MorphDriver } from '../../drivers/morph/definition.ts'
import type { WrinkleDriver } from '../../drivers/registry.ts'
import { MorphDrivers } from '../../runtime/morph-drivers.ts'
import type { Drive, FetchedBindings } from '../sources/binding.ts'
import { targetNames, weightReader } from '../sources/morph.ts'

/**
 * Prepares the drivers of a file. Most files have blendshapes alone, named as their mesh names them; what any others take is fetched.
 *
 * @param mesh the face in the file. Copies may have other blendshapes: what they take is fetched when they are driven.
 * @param vrm of the file, if it is a VRM.
 */
export async function prepareDrivers(
  mesh: Mesh,
  drivers: readonly WrinkleDriver[],
  bindings: FetchedBindings,
  vrm: GLTFParser | undefined,
): Promise<Drive> {
  let any: Promise<Drive> | undefined
  const fetchAny = () => {
    any ??= import('./any-drivers.ts').then(({ planDrivers }) => planDrivers(mesh, drivers, bindings, vrm))
    return any
  }
  if (vrm || !areMorphs(drivers) || !hasTargets(targetNames(mesh), drivers)) return fetchAny()
  return (own) => {
    const names = targetNames(own.mesh)
    const driveAny = async () => {
      try {
        const drive = await fetchAny()
        if (!own.isDisposed) drive(own)
      } catch (error) {
        console.warn((error as Error).message)
      }
    }
    if (hasTargets(names, drivers)) {
      own.setDrivers(new MorphDrivers(drivers, names, weightReader(own.mesh, names), driveAny))
    } else driveAny()
  }
}

function areMorphs(drivers: readonly WrinkleDriver[]): drivers is readonly MorphDriver[] {
  return drivers.every(({ type }) => type === 'morph')
}

function hasTargets(names: readonly string[], drivers: readonly MorphDriver[]): boolean {
  return drivers.every(({ targets }) => targets.every(({ name }) => names.includes(name)))
}
