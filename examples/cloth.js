/** A simulated cloth and its wrinkle maps, for tension.html. Not part of the library. */

import { bumpToNormal } from 'furrow/author'
import { DoubleSide, Mesh, MeshPhysicalMaterial, PlaneGeometry } from 'three'

/** Squares per row and column of the cloth. The mesh is too coarse to show folds. */
const SIDE = 24
/** Width of the cloth, metres. */
const WIDTH = 0.27
/** Minimum length of a thread, as a fraction of its length at rest. The thickness of cloth limits its compression. */
const MIN_STRETCH = 0.5
/** Time step of the simulation, seconds. */
const STEP = 1 / 240
/** Metres per second squared. */
const GRAVITY = 9.81

/**
 * A cloth that hangs from two corners. Threads resist stretch, but resist compression only below `MIN_STRETCH`. The
 * method is from T. Jakobsen, Advanced Character Physics, 2001.
 */
export class Cloth {
  constructor() {
    const geometry = new PlaneGeometry(WIDTH, WIDTH, SIDE, SIDE)
    const look = { color: '#7c4a3a', roughness: 0.75, side: DoubleSide, sheen: 0.6, sheenColor: '#ffd9c0' }
    this.mesh = new Mesh(geometry, new MeshPhysicalMaterial(look))
    this.mesh.position.y = 0.8
    this.positions = Float64Array.from(geometry.attributes.position.array)
    this.lastPositions = this.positions.slice()
    this.threads = createThreads()
    this.lastUpdate = 0
    /** Fraction by which the upper corners are closer together than at rest. `push` moves smoothly to `targetPush`. */
    this.push = 0
    this.targetPush = 0
  }

  /**
   * Moves the upper corners together by the fraction `push`, 0..1. If it is not 0, simulates 900 steps, after which the
   * cloth moves only by a few millimetres per second.
   */
  settle(push) {
    this.push = push
    this.targetPush = push
    for (let i = 0; push > 0 && i < 900; i++) this.step()
    this.write()
  }

  /**
   * Simulates the time since the previous update, at most 8 steps.
   *
   * @param seconds current time, measured from any fixed moment.
   */
  update(seconds) {
    const steps = Math.min(8, Math.round((seconds - this.lastUpdate) / STEP))
    this.lastUpdate = seconds
    for (let i = 0; i < steps; i++) {
      this.push += (this.targetPush - this.push) * 0.03
      this.step()
    }
    this.write()
  }

  step() {
    const { positions, lastPositions } = this
    for (let i = 0; i < positions.length; i++) {
      const velocity = (positions[i] - lastPositions[i]) * 0.995
      lastPositions[i] = positions[i]
      positions[i] += velocity - (i % 3 === 1 ? GRAVITY * STEP * STEP : 0)
    }
    for (let round = 0; round < 16; round++) {
      this.fixCorners()
      for (const [a, b, length] of this.threads) this.constrain(3 * a, 3 * b, length)
    }
    this.fixCorners()
  }

  fixCorners() {
    const half = (WIDTH / 2) * (1 - this.push)
    this.positions.set([-half, WIDTH / 2, 0], 0)
    this.positions.set([half, WIDTH / 2, 0], 3 * SIDE)
  }

  constrain(a, b, length) {
    const { positions } = this
    const difference = [0, 1, 2].map((k) => positions[b + k] - positions[a + k])
    const distance = Math.hypot(...difference)
    const allowed = Math.min(Math.max(distance, MIN_STRETCH * length), length)
    const correction = (0.5 * (distance - allowed)) / distance
    for (let k = 0; k < 3; k++) {
      positions[a + k] += correction * difference[k]
      positions[b + k] -= correction * difference[k]
    }
  }

  write() {
    const { position } = this.mesh.geometry.attributes
    position.array.set(this.positions)
    position.needsUpdate = true
    this.mesh.geometry.computeVertexNormals()
  }
}

function createThreads() {
  const threads = []
  const row = SIDE + 1
  const length = WIDTH / SIDE
  const diagonal = length * Math.SQRT2
  for (let y = 0; y <= SIDE; y++) {
    for (let x = 0; x <= SIDE; x++) {
      const i = y * row + x
      if (x < SIDE) threads.push([i, i + 1, length])
      if (y < SIDE) threads.push([i, i + row, length])
      if (x < SIDE && y < SIDE) threads.push([i, i + row + 1, diagonal], [i + 1, i + row, diagonal])
    }
  }
  return threads
}

/**
 * Creates the weights of one square patch, in a cloth of `count` x `count` patches. They fall to 0 at the centres of
 * the neighbouring patches, so that the weights of all patches sum to 1 between patch centres. From the outermost
 * centres to the cloth's edge, where there is no neighbour, the sum falls to 0.5, and to 0.25 in the corners.
 */
export function patchWeights(column, row, count) {
  const size = 64
  const data = new Uint8Array(size * size)
  const centre = (patch) => Math.min(Math.max(patch + 0.5, 0), count)
  const falloff = (x, patch) => Math.max(0, 1 - Math.abs(x - centre(patch)))
  for (let i = 0; i < data.length; i++) {
    const [x, y] = [i % size, Math.floor(i / size)].map((texel) => ((texel + 0.5) / size) * count)
    data[i] = 255 * falloff(x, column) * falloff(y, row)
  }
  return { width: size, height: size, data }
}

/** Creates a normal map of slanted vertical folds that do not reach across the whole cloth. */
export function foldNormals(size) {
  const heights = new Float64Array(size * size)
  let seed = 7
  const random = () => {
    seed = (seed * 16807) % 2147483647
    return seed / 2147483647
  }
  for (let k = 0; k < 70; k++) {
    const [x0, y0, length] = [random() * size, random() * size, (0.15 + 0.3 * random()) * size]
    const lean = (random() - 0.5) * 0.5
    const width = (0.008 + 0.012 * random()) * size
    const height = (0.6 + 0.6 * random()) * 0.012 * size
    for (let y = Math.max(0, Math.floor(y0 - length)); y < Math.min(size, y0 + length); y++) {
      const along = (y - y0) / length
      const middle = x0 + lean * (y - y0) + 6 * Math.sin(along * 3 + k)
      const end = Math.min(size, middle + 4 * width)
      for (let x = Math.max(0, Math.floor(middle - 4 * width)); x < end; x++) {
        heights[y * size + x] += height * (1 - along * along) * Math.exp(-(((x - middle) / width) ** 2))
      }
    }
  }
  const normals = bumpToNormal({ width: size, height: size, data: heights }).data
  const data = new Uint8Array(4 * size * size).fill(255)
  for (let i = 0; i < size * size; i++) data.set(normals.subarray(3 * i, 3 * i + 3), 4 * i)
  return { width: size, height: size, data }
}
