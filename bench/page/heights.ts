import type { Layer } from 'furrow'
import { autoWrinkleSet, autoWrinkles } from 'furrow/author'
import type { Mesh } from 'three'
import { skinOf } from '../../packages/furrow/src/auto/character.ts'
import { readMeshes } from '../../packages/furrow/src/three/loader/read-character.ts'

type Heights = Pick<Layer, 'height' | 'heightAmplitude'>

const made = new WeakMap<object, Heights>()

/** The heights of automatic wrinkles of a skin, all in one layer, at the age and size that `furrow auto` has by default. Made once. */
export function autoHeights(mesh: Mesh): Heights {
  const { geometry } = mesh
  const known = made.get(geometry)
  if (known) return known
  const wrinkles = autoWrinkles(skinOf(readMeshes([mesh])), { layers: 1, frame: 'orthonormal' })
  const [{ height, heightAmplitude }] = autoWrinkleSet(wrinkles).layers
  const heights = { height, heightAmplitude }
  made.set(geometry, heights)
  return heights
}
