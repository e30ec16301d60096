import { type Mesh, NumberKeyframeTrack } from 'three'
import { sentence } from '../core/error.ts'
import type { WrinkleFaces } from '../runtime/wrinkle-faces.ts'

/** What a mixer finds on a mesh as `wrinkles[AREA].activation`. */
export type AnimatedAreas = Record<string, { activation: number }>

/**
 * Key frames of an area's activation at rest, for an `AnimationClip` that three.js's `AnimationMixer` plays on the mesh or any
 * object above it, together with whatever else the clip moves. Drivers add to it.
 *
 * @param mesh with wrinkles; by its name, as clips of files do, so that copies play it too.
 * @param times seconds, growing.
 * @param values 0..1, one for each time; linear between them.
 */
export function activationTrack(
  mesh: Mesh,
  area: string,
  times: ArrayLike<number>,
  values: ArrayLike<number>,
): NumberKeyframeTrack {
  const name = `${mesh.name || mesh.uuid}.wrinkles[${area}].activation`
  return new NumberKeyframeTrack(name, Array.from(times), Array.from(values))
}

/** Lets mixers reach the areas of a mesh; call it again after areas were added or removed. */
export function exposeAreas(mesh: Mesh, wrinkles: WrinkleFaces<never>): void {
  const areas: AnimatedAreas = {}
  for (const name of wrinkles.areaNames) areas[name] = animatedArea(wrinkles, name)
  ;(mesh as Mesh & { wrinkles?: AnimatedAreas }).wrinkles = areas
}

/** A mixer keeps it even when the area is gone: one warning says so. */
function animatedArea(wrinkles: WrinkleFaces<never>, name: string): { activation: number } {
  let hasWarned = false
  return {
    get activation() {
      return wrinkles.hasArea(name) ? wrinkles.getRestingActivation(name) : 0
    },
    set activation(value) {
      // Splines may overshoot.
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
