import type { Mesh } from 'three'
import { sentence } from '../core/error.ts'
import type { WrinkleFaces } from '../runtime/wrinkle-faces.ts'

/** What an animation mixer finds on a mesh as `wrinkles[AREA].activation`. */
export type AnimatedAreas = Record<string, { activation: number }>

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
