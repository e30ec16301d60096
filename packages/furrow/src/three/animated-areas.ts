import type { Mesh } from 'three'
import { sentence } from '../core/error.ts'
import type { FaceGroup } from '../runtime/face-group.ts'

/** What an animation mixer finds on a mesh as `wrinkles[AREA].activation`. */
export type AnimatedAreas = Record<string, { activation: number }>

/** Exposes the areas of a mesh to animation mixers; to be called again after areas were added or removed. */
export function exposeAreas(mesh: Mesh, group: FaceGroup<never>): void {
  const areas: AnimatedAreas = {}
  for (const name of group.areaNames) areas[name] = animatedArea(group, name)
  ;(mesh as Mesh & { wrinkles?: AnimatedAreas }).wrinkles = areas
}

/** A mixer keeps this object even after the area was removed; it then warns once. */
function animatedArea(group: FaceGroup<never>, name: string): { activation: number } {
  let hasWarned = false
  return {
    get activation() {
      return group.hasArea(name) ? group.getRestingActivation(name) : 0
    },
    set activation(value) {
      if (group.isDisposed) return
      // Cubic splines may overshoot.
      if (group.hasArea(name)) group.setRestingActivation(name, Math.min(Math.max(value, 0), 1))
      else if (!hasWarned) {
        hasWarned = true
        console.warn(
          sentence({
            who: 'Wrinkles',
            problem: 'an animation moves an area that was removed',
            value: name,
            remedy: 'the rest of the animation plays',
          }),
        )
      }
    },
  }
}
