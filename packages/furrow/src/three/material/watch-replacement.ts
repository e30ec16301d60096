import type { Mesh } from 'three'
import { sentence } from '../../core/error.ts'
import type { PatchedMaterial } from './patched-material.ts'

/** Consecutive draws with another material. Passes such as selective bloom exchange materials in every frame, and stay below. */
const MOST_DRAWS = 30

/**
 * Watches which material a mesh is drawn with, and warns once when the page has replaced the one that shows the wrinkles.
 *
 * @returns the function to call before each draw.
 */
export function watchReplacement(mesh: Mesh, patched: PatchedMaterial): () => void {
  let draws = 0
  return () => {
    if (draws > MOST_DRAWS) return
    draws = patched.mode === 'off' || patched.isOn(mesh) ? 0 : draws + 1
    if (draws > MOST_DRAWS) warn(mesh)
  }
}

function warn({ name, material }: Mesh): void {
  console.warn(
    sentence({
      who: 'Wrinkles',
      problem: `mesh "${name}" has another material than the one that shows its wrinkles`,
      value: [material].flat()[0]?.name,
      remedy: 'move them with new Wrinkles(mesh, wrinkles), then call wrinkles.dispose()',
    }),
  )
}
