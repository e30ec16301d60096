import type { Layer } from 'furrow'
import { autoWrinkleSet, autoWrinkles } from 'furrow/author'
import type { Mesh } from 'three'
import { skinOf } from '../../packages/furrow/src/auto/character.ts'
import { readMeshes } from '../../packages/furrow/src/three/loader/read-character.ts'

type Heights = Pick<Layer, 'height' | 'heightAmplitude'>

const cache = new WeakMap<object, Heights>()

/** Creates automatic wrinkles with one layer, by the defaults of `furrow auto`, and returns the layer's height map. Cached per geometry. */
export function autoHeights(mesh: Mesh): Heights {
  const { geometry } = mesh
  const known = cache.get(geometry)
  if (known) return known
  const wrinkles = autoWrinkles(skinOf(readMeshes([mesh])), { layers: 1, frame: 'orthonormal' })
  const [{ height, heightAmplitude }] = autoWrinkleSet(wrinkles).layers
  const heights = { height, heightAmplitude }
  cache.set(geometry, heights)
  return heights
}
