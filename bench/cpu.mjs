// CPU cost of one face per frame: 57 blendshapes drive 64 areas, all of which move, alone or with every other type of driver.
// Uses the packages' builds, as pages do, and a renderer that draws nothing.

import { setFlagsFromString } from 'node:v8'
import { runInNewContext } from 'node:vm'
import { addDrivers, Wrinkles } from 'furrow/three'
import {
  Bone,
  BufferAttribute,
  MeshStandardMaterial,
  PerspectiveCamera,
  PlaneGeometry,
  Scene,
  Skeleton,
  SkinnedMesh,
} from 'three'
import { idleRenderer } from './idle-renderer.mjs'

setFlagsFromString('--expose-gc')
const collectGarbage = runInNewContext('gc')

const TARGETS = 57
const AREAS = 64
/** Blendshapes that drive an area, as many as in a driver of the shipped face. */
const LINKS = 4
const ROUNDS = 15
const FRAMES = 20_000

const CURVE = [
  [0.1, 0],
  [0.6, 0.7],
  [1, 1],
]

/** Areas that tension drives too: those of one expression. */
const TENSION_AREAS = 8

/**
 * Microseconds and allocated bytes per frame, medians over rounds.
 *
 * @param allTypes whether joints, tension, age, time, other areas and conflicts drive areas too.
 * @param ownClock whether `wrinkles.clock` is the page's own; otherwise it is `performance`.
 */
export function measureCpu(median, allTypes, ownClock = allTypes) {
  const frame = movingFace(allTypes, ownClock)
  for (let i = 0; i < 3 * FRAMES; i++) frame(i)
  const rounds = Array.from({ length: ROUNDS }, (_, round) => {
    collectGarbage()
    const used = process.memoryUsage().heapUsed
    const start = performance.now()
    for (let i = 0; i < FRAMES; i++) frame(round * FRAMES + i)
    const milliseconds = performance.now() - start
    return {
      microseconds: (1000 * milliseconds) / FRAMES,
      bytes: (process.memoryUsage().heapUsed - used) / FRAMES,
    }
  })
  return {
    targets: TARGETS,
    areas: AREAS,
    microseconds: median(rounds.map(({ microseconds }) => microseconds)),
    bytes: median(rounds.map(({ bytes }) => bytes)),
  }
}

/** Returns a function that runs frame number `index`, with other weights of all blendshapes than in the last. */
function movingFace(allTypes, ownClock) {
  const geometry = new PlaneGeometry(1, 1, 16, 16)
  const { count } = geometry.getAttribute('position')
  geometry.morphAttributes.position = Array.from({ length: TARGETS }, (_, i) => {
    const attribute = new BufferAttribute(new Float32Array(3 * count), 3)
    attribute.name = `target${i}`
    return attribute
  })
  geometry.setAttribute('skinIndex', new BufferAttribute(new Uint16Array(4 * count), 4))
  const skinWeights = Float32Array.from({ length: 4 * count }, (_, i) => (i % 4 === 0 ? 1 : 0))
  geometry.setAttribute('skinWeight', new BufferAttribute(skinWeights, 4))
  const mesh = new SkinnedMesh(geometry, new MeshStandardMaterial())
  const bones = ['neck', 'head'].map((name) => Object.assign(new Bone(), { name }))
  mesh.add(bones[0].add(bones[1]))
  mesh.bind(new Skeleton(bones))
  const side = 16
  const weights = { width: side, height: side, data: new Uint8Array(side * side).fill(255) }
  const normal = { width: 1, height: 1, data: Uint8Array.of(128, 128, 255, 255) }
  const areas = Array.from({ length: AREAS }, (_, i) => ({ name: `area${i}`, weights }))
  const wrinkles = new Wrinkles(mesh, { layers: [{ name: 'all', kind: 'detail', normal }], areas })
  addDrivers(wrinkles, [
    ...areas.map(({ name }, i) => morphDriver(name, i)),
    ...(allTypes ? areas.flatMap(({ name }, i) => otherDrivers(name, i)) : []),
  ])
  // A page with its own time step, in whole milliseconds. JavaScript allocates 16 bytes for the fraction that `performance`
  // returns.
  let milliseconds = 0
  if (ownClock) wrinkles.clock = { now: () => milliseconds }
  const renderer = idleRenderer()
  const scene = new Scene()
  const camera = new PerspectiveCamera()
  const influences = mesh.morphTargetInfluences
  return (index) => {
    for (let i = 0; i < TARGETS; i++) influences[i] = ((index * 7 + i * 13) % 100) / 100
    if (allTypes) {
      bones[1].rotation.x = ((index * 3) % 50) / 50
      mesh.updateMatrixWorld()
    }
    milliseconds = 16 * index
    renderer.info.calls++
    mesh.onBeforeRender(renderer, scene, camera, geometry, mesh.material, null)
  }
}

/** Per type, the driver of one area; none where a type does not evaluate anything of its own. A test compares it with the registry. */
export const OTHER_DRIVERS = {
  age: (area) => ({ type: 'age', area, curve: CURVE }),
  input: (area) => ({ type: 'input', name: 'stress', area, curve: CURVE }),
  time: (area) => ({ type: 'time', area, attack: 0.05, release: 0.4 }),
  bone: (area) => ({
    type: 'bone',
    area,
    joints: ['neck', 'head'],
    measure: 'angle',
    axis: [1, 0, 0],
    curve: CURVE,
  }),
  conflict: (_, i) => ({ type: 'conflict', targets: [`target${i % TARGETS}`, `target${(i + 7) % TARGETS}`] }),
  // The last area reads no other, which would be a cycle.
  area: (area, i) =>
    i + 1 < AREAS && {
      type: 'area',
      area,
      areas: [{ name: `area${i + 1}`, weight: 0.1 }],
      rule: 'sum',
      curve: CURVE,
    },
  tension: (area, i) => i < TENSION_AREAS && { type: 'tension', area, measure: 'compression', curve: CURVE },
  // Evaluated as a driver of its morph target.
  muscle: () => null,
  // A preset: data for players.
  expression: () => null,
}

/** Drivers of every other type for one area. */
function otherDrivers(area, i) {
  return Object.values(OTHER_DRIVERS)
    .map((create) => create(area, i))
    .filter(Boolean)
}

function morphDriver(area, i) {
  const targets = Array.from({ length: LINKS }, (_, k) => ({
    name: `target${(i * 5 + k * 11) % TARGETS}`,
    weight: 0.4,
  }))
  return { type: 'morph', area, targets, rule: 'sum', curve: CURVE }
}
