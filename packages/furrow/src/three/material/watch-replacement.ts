import type { Mesh } from 'three'
import { formatProblem } from '../../core/error.ts'
import type { PatchedMaterial } from './patched-material.ts'

/** Number of consecutive draws with another material before a warning. Some passes, e.g. selective bloom, replace materials for a few draws. */
const MAX_DRAWS = 30

/**
 * Warns once if the page has replaced the wrinkled material of a mesh.
 *
 * @returns a function to call before each draw.
 */
export function watchReplacement(mesh: Mesh, patched: PatchedMaterial): () => void {
  let draws = 0
  return () => {
    if (draws > MAX_DRAWS) return
    draws = patched.mode === 'off' || patched.isOn(mesh) ? 0 : draws + 1
    if (draws > MAX_DRAWS) warn(mesh)
  }
}

function warn({ name, material }: Mesh): void {
  console.warn(
    formatProblem({
      who: 'Wrinkles',
      problem: `the wrinkled material of mesh "${name}" was replaced`,
      value: [material].flat()[0]?.name,
      remedy:
        'add the wrinkles to the new material with new Wrinkles(mesh, wrinkles), then call wrinkles.dispose()',
    }),
  )
}
