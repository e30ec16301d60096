import type { Mesh } from 'three'
import { formatProblem } from '../core/error.ts'
import type { FaceGroup } from '../runtime/face-group.ts'

/** Type of the property `wrinkles` of a mesh. Animation mixers set `wrinkles[AREA].activation`. */
export type AnimatedAreas = Record<string, { activation: number }>

/** Lets animation mixers set the activations of a mesh's areas. Call again after adding or removing areas. */
export function exposeAreas(mesh: Mesh, group: FaceGroup<never>): void {
  const areas: AnimatedAreas = {}
  for (const name of group.areaNames) areas[name] = animatedArea(group, name)
  ;(mesh as Mesh & { wrinkles?: AnimatedAreas }).wrinkles = areas
}

/**
 * Creates the object whose `activation` a mixer sets. The mixer keeps the object after the area is removed. Setting `activation` then warns
 * once.
 */
function animatedArea(group: FaceGroup<never>, name: string): { activation: number } {
  let hasWarned = false
  return {
    get activation() {
      return group.hasArea(name) ? group.getRestingActivation(name) : 0
    },
    set activation(value) {
      if (group.isDisposed) return
      // Cubic splines may leave the range 0..1.
      if (group.hasArea(name)) group.setRestingActivation(name, Math.min(Math.max(value, 0), 1))
      else if (!hasWarned) {
        hasWarned = true
        console.warn(
          formatProblem({
            who: 'Wrinkles',
            problem: 'an animation moves an area that was removed',
            value: name,
            remedy: 'the other tracks of the animation keep playing',
          }),
        )
      }
    },
  }
}
