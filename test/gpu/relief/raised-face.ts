import type { Area, ArraySlice, GrayImage, Layer } from 'furrow'
import { packAreas, reference } from 'furrow/internal'
import { readWrinkleMaps } from 'furrow/three'
import type { Mesh, Object3D } from 'three'
import { type GLTF, GLTFLoader } from 'three/addons/loaders/GLTFLoader.js'
import { coveredTriangles, maxHalvings } from '../../../packages/furrow/src/relief/covered-triangles.ts'
import { displace } from '../../../packages/furrow/src/relief/displaced.ts'
import { weightedTexels } from '../../../packages/furrow/src/relief/height-fields.ts'
import { outwardClearance } from '../../../packages/furrow/src/relief/outward-clearance.ts'
import { splitMesh } from '../../../packages/furrow/src/relief/split-mesh.ts'
import { finish } from '../../unit/relief/coarse.ts'
import type { Harness } from '../harness.ts'

/** Height difference between black and white texels of `bands`, metres. */
const AMPLITUDE = 0.002
const SIDE = 512

/** Height map of a layer, and its scale. */
export interface Heights {
  height: GrayImage
  /** Height difference between black and white texels, metres. */
  heightAmplitude: number
}

/** Height map of horizontal bands, several millimetres wide on the skin: wider and higher than wrinkles. */
const bands: GrayImage = {
  width: SIDE,
  height: SIDE,
  data: Uint8Array.from({ length: SIDE * SIDE }, (_, i) =>
    Math.round(127.5 + 127.5 * Math.sin((2 * Math.PI * 40 * Math.floor(i / SIDE)) / SIDE)),
  ),
}

const BANDS: Heights = { height: bands, heightAmplitude: AMPLITUDE }

export interface RaisedFace {
  root: Object3D
  skin: Mesh
  heights: Heights
  areas: Area<ArraySlice>[]
  wrinkles: InstanceType<Harness['Wrinkles']>
  dispose(): void
}

/** Loads the shipped face with `bands` in place of its heights. All areas are active. */
export async function bandedFace(harness: Harness): Promise<RaisedFace> {
  return raisedFace(harness, () => BANDS)
}

/** Loads the shipped face with its own heights. All areas are active. */
export async function shippedFace(harness: Harness): Promise<RaisedFace> {
  return raisedFace(harness, ([{ height, heightAmplitude }]) => {
    if (!height || !('data' in height)) throw new Error('the shipped face has no heights')
    return { height: height as GrayImage, heightAmplitude: heightAmplitude! }
  })
}

async function raisedFace(
  harness: Harness,
  heightsOf: (layers: readonly Layer<ArraySlice>[]) => Heights,
): Promise<RaisedFace> {
  const gltf: GLTF = await new GLTFLoader().loadAsync('/packed/shipped.glb')
  const [{ meshes, set }] = await readWrinkleMaps(gltf)
  const [skin] = meshes
  const heights = heightsOf(set.layers)
  // `displacedSkin` computes heights without onset, which `onset.test.ts` covers.
  const layers = set.layers.map(({ onset: _, ...layer }) => ({ ...layer, ...heights }))
  const areas = set.areas.map((area) => ({ ...area, activation: 1 }))
  const wrinkles = new harness.Wrinkles(skin, { layers, areas }, { relief: 'on' })
  await wrinkles.reliefReady()
  return { root: gltf.scene, skin, heights, areas, wrinkles, dispose: () => wrinkles.dispose() }
}

/** Computes the skin with and without relief in float64. Returns triangles, and positions in mesh space. */
export function displacedSkin({ skin, heights, areas: activeAreas }: RaisedFace) {
  const { height: map, heightAmplitude } = heights
  const { attributes, index, morphAttributes } = skin.geometry
  const rest = attributes.position.array
  const coarse = { positions: rest, uvs: attributes.uv.array, triangles: index!.array }
  const areas = packAreas(activeAreas.map(({ weights }) => weights as GrayImage))
  const active = activeAreas.map(({ combine = 'sum' }) => ({ activation: 1, layer: 0, combine }) as const)
  const slices = activeAreas.map((_, slice) => slice)
  // Splits all triangles inside areas to the finest level. The drawn mesh is split only where heights need it.
  const halvings = maxHalvings(coveredTriangles(coarse, weightedTexels(areas, slices)))
  const dense = finish(splitMesh(coarse, halvings))
  const clearance = finish(
    outwardClearance(coarse, attributes.normal.array, dense.firstOf, heightAmplitude / 2),
  )
  const deformed = (name: 'position' | 'normal') => {
    const out = Float64Array.from(attributes[name].array)
    for (const [target, weight] of skin.morphTargetInfluences!.entries()) {
      const offsets = morphAttributes[name]?.[target]
      if (weight !== 0 && offsets) for (let i = 0; i < out.length; i++) out[i] += weight * offsets.array[i]
    }
    return out
  }
  const normals = deformed('normal')
  for (let i = 0; i < normals.length; i += 3) {
    const length = Math.hypot(normals[i], normals[i + 1], normals[i + 2])
    for (let axis = 0; axis < 3; axis++) normals[i + axis] /= length
  }
  const heightAt = (u: number, v: number) => {
    const influence = reference.influenceFromMap(areas, active, u, v)
    const height = reference.interpolate(map, u, v, (i, j) => map.data[i + j * map.width]) / 255
    return influence * (height - 0.5) * heightAmplitude
  }
  const plain = { triangles: coarse.triangles, positions: deformed('position') }
  const positions = displace(dense, { positions: plain.positions, normals }, heightAt, clearance)
  return { triangles: dense.triangles, positions, plain }
}
