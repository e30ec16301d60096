import { DataTexture, LinearFilter, LinearMipmapLinearFilter, RepeatWrapping } from 'three'
import { randomNormals } from '../cases.ts'
import { seeded } from '../random.ts'

/** Creates a square map of random normals, with the texture settings of glTF. */
export function normalMap(seed: number, side: number): DataTexture {
  const map = new DataTexture(randomNormals(seeded(seed), side).data, side, side)
  map.wrapS = map.wrapT = RepeatWrapping
  map.magFilter = LinearFilter
  map.minFilter = LinearMipmapLinearFilter
  map.generateMipmaps = true
  map.needsUpdate = true
  return map
}
