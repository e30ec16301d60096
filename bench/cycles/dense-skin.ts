/**
 * Builds the mesh of the skin for Cycles, and displaces it in float64. Its triangles are smaller than those that Furrow's relief draws in a
 * browser.
 */
import { readFile } from 'node:fs/promises'
import { join } from 'node:path'
import { decodeGray } from 'furrow-files'
import { readFolder, readHeightImage } from 'furrow-files/node'
import { packAreas } from '../../packages/furrow/src/core/pack.ts'
import {
  bloodColour,
  bloodOf,
  influence,
  interpolate,
  mixValues,
} from '../../packages/furrow/src/core/reference.ts'
import { DeformedNormals } from '../../packages/furrow/src/math/deformed-normals.ts'
import { coveredTriangles, maxHalvings } from '../../packages/furrow/src/relief/covered-triangles.ts'
import { displace, displacement } from '../../packages/furrow/src/relief/displaced.ts'
import { weightedTexels } from '../../packages/furrow/src/relief/height-fields.ts'
import { outwardClearance } from '../../packages/furrow/src/relief/outward-clearance.ts'
import { splitMesh } from '../../packages/furrow/src/relief/split-mesh.ts'
import type { Description } from './page.ts'

const WHO = 'cycles'

/** Maximum edge length in metres, so that even a narrow wrinkle is several edges wide. */
const EDGE = 0.00035
const MAX_TRIANGLES = 1_500_000

/** Maximum displacement, metres. */
const REACH = 0.002

/** A displaced mesh. */
export interface Skin {
  /** Packed xyz of each vertex, metres, world space. */
  positions: Float32Array
  /** Packed uv of each vertex. */
  uvs: Float32Array
  /** Packed rgb factors of each vertex, linear. Blood in the skin multiplies the base colour by them. */
  tints: Float32Array
  triangles: Uint32Array
}

/**
 * Splits and displaces a face's skin.
 *
 * @param folder output of `furrow unpack`.
 */
export async function denseSkin({ skin, activations }: Description, folder: string): Promise<Skin> {
  const { uvs, triangles } = skin
  const { areas, heightAt, bloodAt } = await readWrinkles(folder, activations)
  const mesh = { positions: skin.rest, uvs, triangles }
  const slices = Array.from({ length: areas.depth }, (_, slice) => slice)
  const halvings = maxHalvings(coveredTriangles(mesh, weightedTexels(areas, slices)))
  const dense = finish(splitMesh(mesh, halvings, { edge: EDGE, budget: MAX_TRIANGLES }))
  const normals = new Float32Array(skin.normals.length)
  new DeformedNormals({ positions: skin.rest, normals: skin.normals, triangles }).update(
    skin.positions,
    normals,
  )
  const clearance = finish(outwardClearance(mesh, skin.normals, dense.firstOf, REACH))
  const moved = displace(dense, { positions: skin.positions, normals }, heightAt, clearance)
  const denseUvs = textureCoordinates(dense, uvs)
  const tints = new Float32Array(3 * dense.count)
  for (let i = 0; i < dense.count; i++) {
    tints.set(bloodColour([1, 1, 1], bloodAt(denseUvs[2 * i], denseUvs[2 * i + 1])), 3 * i)
  }
  return { positions: Float32Array.from(moved), uvs: denseUvs, tints, triangles: dense.triangles }
}

/**
 * Reads the wrinkles of a folder. Returns the packed areas and two functions of texture coordinates: `heightAt` returns the displacement in metres,
 * and `bloodAt` returns the added optical depth of blood for green light (negative = paler).
 */
async function readWrinkles(folder: string, activations: Record<string, number>) {
  const set = await readFolder(folder, false, WHO)
  const read = (path: string) => join(folder, decodeURIComponent(path))
  const weights = await Promise.all(
    set.areas.map(async ({ image, convention }) => {
      const gray = await decodeGray(await readFile(read(image)), image, WHO)
      if (convention !== 'weight') gray.data = gray.data.map((value) => 255 - value)
      return gray
    }),
  )
  const areas = packAreas(weights)
  const layers = await Promise.all(
    set.layers.map(async ({ height, heightAmplitude = 0, blood, bloodAmplitude = 0 }) => ({
      image: height === undefined ? null : await readHeightImage(read(height), WHO),
      amplitude: heightAmplitude,
      blood: blood === undefined ? null : await decodeGray(await readFile(read(blood)), blood, WHO),
      bloodAmplitude,
    })),
  )
  const active = set.areas.map(({ name, layer, combine = 'sum' }) => ({
    activation: activations[name] ?? 0,
    layer: layer === undefined ? 0 : set.layers.findIndex((each) => each.name === layer),
    combine,
  }))
  const heightAt = (u: number, v: number) =>
    displacement(
      layers.flatMap(({ image, amplitude }, layer) => {
        if (!image) return []
        const full = 2 ** image.bits - 1
        const height = interpolate(image, u, v, (i, j) => image.data[i + j * image.width]) / full
        return { influence: influence(areas, active, u, v, layer), height, amplitude }
      }),
    )
  const bloodAt = (u: number, v: number) => {
    const parts = layers.flatMap(({ blood, bloodAmplitude }, layer) => {
      if (!blood) return []
      const stored = interpolate(blood, u, v, (i, j) => blood.data[i + j * blood.width] / 255)
      const value = [bloodOf(stored) * bloodAmplitude]
      return { value, influence: influence(areas, active, u, v, layer) }
    })
    return mixValues([0], parts)[0]
  }
  return { areas, heightAt, bloodAt }
}

/** Interpolates the texture coordinates of the split vertices from the corners of the original triangles. */
function textureCoordinates(
  { count, corners, weights }: { count: number; corners: Uint32Array; weights: Float32Array },
  uvs: ArrayLike<number>,
): Float32Array {
  const out = new Float32Array(2 * count)
  for (let i = 0; i < 3 * count; i++) {
    for (let axis = 0; axis < 2; axis++) {
      out[2 * Math.floor(i / 3) + axis] += weights[i] * uvs[2 * corners[i] + axis]
    }
  }
  return out
}

function finish<T>(steps: Generator<void, T>): T {
  for (;;) {
    const { done, value } = steps.next()
    if (done) return value
  }
}
