import { type Mesh, NumberKeyframeTrack } from 'three'
import { wrongArgument } from '../core/argument.ts'
import { sentence } from '../core/error.ts'
import type { WrinkleFaces } from '../runtime/wrinkle-faces.ts'

/** What an animation mixer finds on a mesh as `wrinkles[AREA].activation`. */
export type AnimatedAreas = Record<string, { activation: number }>

/**
 * Creates key frames of an area's activation at rest, for an `AnimationClip` that three.js's `AnimationMixer` plays on the mesh or an
 * ancestor of it. Drivers add to it.
 *
 * @param mesh with wrinkles; bound by its name, as in clips of files, so that copies play it too.
 * @param area name of the area.
 * @param times seconds, increasing.
 * @param values 0..1, one per time, interpolated linearly.
 * @throws FurrowError when it is not a mesh, the area is not text, or there are not as many values as times.
 */
export function activationTrack(
  mesh: Mesh,
  area: string,
  times: ArrayLike<number>,
  values: ArrayLike<number>,
): NumberKeyframeTrack {
  if (!mesh?.uuid) throw wrongArgument('activationTrack', 'a mesh', mesh, 'a Mesh of three.js')
  if (typeof area !== 'string') throw wrongArgument('activationTrack', 'an area', area, 'a name')
  if (!(times?.length > 0) || times.length !== values?.length) {
    throw wrongArgument('activationTrack', 'values', values?.length, `one for each of ${times?.length} times`)
  }
  const name = `${mesh.name || mesh.uuid}.wrinkles[${area}].activation`
  return new NumberKeyframeTrack(name, Array.from(times), Array.from(values))
}

/** Exposes the areas of a mesh to animation mixers; to be called again after areas were added or removed. */
export function exposeAreas(mesh: Mesh, wrinkles: WrinkleFaces<never>): void {
  const areas: AnimatedAreas = {}
  for (const name of wrinkles.areaNames) areas[name] = animatedArea(wrinkles, name)
  ;(mesh as Mesh & { wrinkles?: AnimatedAreas }).wrinkles = areas
}

/** A mixer keeps this object even after the area was removed; it then warns once. */
function animatedArea(wrinkles: WrinkleFaces<never>, name: string): { activation: number } {
  let hasWarned = false
  return {
    get activation() {
      return wrinkles.hasArea(name) ? wrinkles.getRestingActivation(name) : 0
    },
    set activation(value) {
      if (wrinkles.isDisposed) return
      // Cubic splines may overshoot.
      if (wrinkles.hasArea(name)) wrinkles.setRestingActivation(name, Math.min(Math.max(value, 0), 1))
      else if (!hasWarned) {
        hasWarned = true
        console.warn(
          sentence({
            who: 'Wrinkles',
            what: 'an animation moves an area that was removed',
            value: name,
            remedy: 'the rest of the animation plays',
          }),
        )
      }
    },
  }
}
