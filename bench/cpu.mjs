// `node bench/cpu.mjs`: measures the CPU time per frame of one face, and per frame and face in crowds. Each face has 57 blendshapes that drive
// 64 areas. The crowds are compared with minimal JavaScript that does the same work. Uses the built packages and a stub renderer.

import { fileURLToPath } from 'node:url'
import { setFlagsFromString } from 'node:v8'
import { runInNewContext } from 'node:vm'
import { addDrivers, Wrinkles } from 'furrow/three'
import {
  Bone,
  BufferAttribute,
  InstancedMesh,
  MeshStandardMaterial,
  PerspectiveCamera,
  PlaneGeometry,
  Scene,
  Skeleton,
  SkinnedMesh,
} from 'three'
import { idleRenderer } from './idle-renderer.mjs'
import { median } from './median.mjs'

setFlagsFromString('--expose-gc')
const collectGarbage = runInNewContext('gc')

const TARGETS = 57
const AREAS = 64
/** Number of blendshapes that drive each area, as in `faces/human.glb`. */
const LINKS = 4
const LINK_WEIGHT = 0.4
const ROUNDS = 15
const FRAMES = 20_000

const CURVE = [
  [0.1, 0],
  [0.6, 0.7],
  [1, 1],
]

/** Number of areas with a tension driver. One expression uses about eight. */
const TENSION_AREAS = 8

/**
 * Measures microseconds and allocated bytes per frame, medians over rounds.
 *
 * @param allTypes whether to add drivers of every type besides `morph`.
 * @param customClock whether to replace `wrinkles.clock`, which is `performance` by default, by a clock with integer milliseconds.
 */
export function measureCpu(allTypes, customClock = allTypes) {
  return { targets: TARGETS, areas: AREAS, ...measure(movingFace(allTypes, customClock), FRAMES) }
}

/** Faces times frames per round. Faces with constant weights (`still`) take far less time, so more of them are evaluated. */
const CROWD_FACES = { moving: 30_000, still: 600_000 }
/** Fraction of a crowd's faces that move when `stillAmongMoving` is measured. */
const FEW = 0.01

/**
 * Measures microseconds per face and frame in a crowd of instances, with the blendshapes and areas of `measureCpu`.
 *
 * @returns `moving`: time per face if all move. `still`: time per face if none moves. `stillAmongMoving`: time per still face if one face in a
 * hundred moves.
 */
export function measureCrowdCpu(faces) {
  const { all, none, few } = crowdFrames(faces)
  const perFace = (frame, count) => measure(frame, count / faces).microseconds / faces
  const moving = perFace(all, CROWD_FACES.moving)
  const still = perFace(none, CROWD_FACES.still)
  const mixed = perFace(few, CROWD_FACES.still)
  return { moving, still, stillAmongMoving: (mixed - FEW * moving) / (1 - FEW) }
}

/**
 * Measures microseconds per face and frame of minimal JavaScript that does the same work as the library. It compares weights with those of the
 * last frame, evaluates the drivers, and writes activations and the vertices of the influence map's quads.
 */
export function measureMinimalCpu(faces) {
  const { all, none } = minimalFrames(faces)
  const perFace = (frame, count) => measure(frame, count / faces).microseconds / faces
  return { moving: perFace(all, CROWD_FACES.moving), still: perFace(none, CROWD_FACES.still) }
}

/** Returns the microseconds and allocated bytes per frame, as medians over rounds of `frames` frames each. */
function measure(frame, frames) {
  for (let i = 0; i < 3 * frames; i++) frame(i)
  const rounds = Array.from({ length: ROUNDS }, (_, round) => {
    collectGarbage()
    const used = process.memoryUsage().heapUsed
    const start = performance.now()
    for (let i = 0; i < frames; i++) frame(round * frames + i)
    const milliseconds = performance.now() - start
    return {
      microseconds: (1000 * milliseconds) / frames,
      bytes: (process.memoryUsage().heapUsed - used) / frames,
    }
  })
  return {
    microseconds: median(rounds.map(({ microseconds }) => microseconds)),
    bytes: median(rounds.map(({ bytes }) => bytes)),
  }
}

/**
 * Returns three functions, each of which runs one frame of a crowd. `all` changes the weights of every face, `few` changes the weights of one
 * face in a hundred, and `none` changes no weights.
 */
function crowdFrames(faces) {
  const geometry = createPlane()
  const mesh = new InstancedMesh(geometry, new MeshStandardMaterial(), faces)
  const wrinkles = new Wrinkles(mesh, createSet(), { areaSize: 16 })
  addDrivers(
    wrinkles,
    wrinkles.areaNames.map((name, i) => morphDriver(name, i)),
  )
  const source = { morphTargetInfluences: new Float32Array(TARGETS) }
  mesh.setMorphAt(0, source)
  const { morphTexture } = mesh
  const { data, width } = morphTexture.image
  const weights = [0, 1].map((frame) => data.map((_, i) => ((frame * 7 + i * 13) % 100) / 100))
  const draw = frameRunner(mesh)
  // Replaces all weights at once. `setMorphAt` per face would add time that the library does not cause.
  const show = (shown) => {
    morphTexture.image.data = shown
    morphTexture.needsUpdate = true
    draw()
  }
  const mixed = weights.map((all) =>
    weights[0].map((weight, i) => (Math.floor(i / width) % (1 / FEW) < 1 ? all[i] : weight)),
  )
  return { all: (i) => show(weights[i % 2]), none: draw, few: (i) => show(mixed[i % 2]) }
}

/** Numbers per quad. Each of its four corners has a position (2 numbers), a texel (2 numbers), an activation and the index of an area. */
const QUAD_SIZE = 24

/** Returns functions that run the frames `all` and `none` of `crowdFrames` without the library. */
function minimalFrames(faces) {
  const weights = [0, 1].map((frame) =>
    Float32Array.from({ length: faces * TARGETS }, (_, i) => ((frame * 7 + i * 13) % 100) / 100),
  )
  const last = new Float64Array(faces * TARGETS)
  const links = Uint16Array.from({ length: AREAS * LINKS }, (_, i) =>
    linkedTarget(Math.floor(i / LINKS), i % LINKS),
  )
  const linkWeights = new Float64Array(AREAS * LINKS).fill(LINK_WEIGHT)
  const [x0, y0, x1, y1, x2, y2] = CURVE.flat()
  const activations = new Float32Array(faces * AREAS)
  const quads = new Float32Array(faces * AREAS * QUAD_SIZE)
  const columns = Math.ceil(Math.sqrt(faces))
  const run = (shown) => {
    let at = 0
    for (let face = 0; face < faces; face++) {
      const first = face * TARGETS
      let hasMoved = false
      for (let i = first; i < first + TARGETS; i++) {
        if (shown[i] === last[i]) continue
        last[i] = shown[i]
        hasMoved = true
      }
      if (!hasMoved) continue
      const column = face % columns
      const row = Math.floor(face / columns)
      for (let area = 0; area < AREAS; area++) {
        let sum = 0
        for (let i = area * LINKS; i < (area + 1) * LINKS; i++) sum += linkWeights[i] * last[first + links[i]]
        let value = y2
        if (sum <= x0) value = y0
        else if (sum <= x1) value = y0 + ((sum - x0) / (x1 - x0)) * (y1 - y0)
        else if (sum <= x2) value = y1 + ((sum - x1) / (x2 - x1)) * (y2 - y1)
        activations[face * AREAS + area] = value
        if (value === 0) continue
        for (let corner = 0; corner < 4; corner++) {
          const right = corner & 1
          const bottom = corner >> 1
          quads[at++] = (column + right) / columns
          quads[at++] = (row + bottom) / columns
          quads[at++] = 16 * right
          quads[at++] = 16 * bottom
          quads[at++] = value
          quads[at++] = area
        }
      }
    }
  }
  return { all: (i) => run(weights[i % 2]), none: () => run(weights[0]) }
}

/** Creates one face. Returns a function that changes all its weights and runs frame `index`. */
function movingFace(allTypes, customClock) {
  const geometry = createPlane()
  const { count } = geometry.getAttribute('position')
  geometry.setAttribute('skinIndex', new BufferAttribute(new Uint16Array(4 * count), 4))
  const skinWeights = Float32Array.from({ length: 4 * count }, (_, i) => (i % 4 === 0 ? 1 : 0))
  geometry.setAttribute('skinWeight', new BufferAttribute(skinWeights, 4))
  const mesh = new SkinnedMesh(geometry, new MeshStandardMaterial())
  const bones = ['neck', 'head'].map((name) => Object.assign(new Bone(), { name }))
  mesh.add(bones[0].add(bones[1]))
  mesh.bind(new Skeleton(bones))
  const set = createSet()
  const { areas } = set
  const wrinkles = new Wrinkles(mesh, set)
  addDrivers(wrinkles, [
    ...areas.map(({ name }, i) => morphDriver(name, i)),
    ...(allTypes ? areas.flatMap(({ name }, i) => otherDrivers(name, i)) : []),
  ])
  // The custom clock returns integers. Fractions, such as `performance.now()` returns, take 16 bytes each, which would count as allocations.
  let milliseconds = 0
  if (customClock) wrinkles.clock = { now: () => milliseconds }
  const draw = frameRunner(mesh)
  const influences = mesh.morphTargetInfluences
  return (index) => {
    for (let i = 0; i < TARGETS; i++) influences[i] = ((index * 7 + i * 13) % 100) / 100
    if (allTypes) {
      bones[1].rotation.x = ((index * 3) % 50) / 50
      mesh.updateMatrixWorld()
    }
    milliseconds = 16 * index
    draw()
  }
}

function createPlane() {
  const geometry = new PlaneGeometry(1, 1, 16, 16)
  const { count } = geometry.getAttribute('position')
  geometry.morphAttributes.position = Array.from({ length: TARGETS }, (_, i) => {
    const attribute = new BufferAttribute(new Float32Array(3 * count), 3)
    attribute.name = `target${i}`
    return attribute
  })
  return geometry
}

function createSet() {
  const side = 16
  const weights = { width: side, height: side, data: new Uint8Array(side * side).fill(255) }
  const normal = { width: 1, height: 1, data: Uint8Array.of(128, 128, 255, 255) }
  const areas = Array.from({ length: AREAS }, (_, i) => ({ name: `area${i}`, weights }))
  return { layers: [{ name: 'all', kind: 'detail', normal }], areas }
}

function frameRunner(mesh) {
  const renderer = idleRenderer()
  const scene = new Scene()
  const camera = new PerspectiveCamera()
  return () => {
    renderer.info.calls++
    mesh.onBeforeRender(renderer, scene, camera, mesh.geometry, mesh.material, null)
  }
}

/**
 * Functions that create a driver for an area, by driver type. They return null or false if no driver of the type is measured for this area.
 * A test checks that all driver types except `morph` are listed.
 */
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
  // Each area reads the next one. The last area reads none, because reading the first one would form a cycle.
  area: (area, i) =>
    i + 1 < AREAS && {
      type: 'area',
      area,
      areas: [{ name: `area${i + 1}`, weight: 0.1 }],
      rule: 'sum',
      curve: CURVE,
    },
  tension: (area, i) => i < TENSION_AREAS && { type: 'tension', area, measure: 'compression', curve: CURVE },
  // A muscle adds a blendshape. Reading its weight costs the same as in `morph` drivers, which are measured.
  muscle: () => null,
  // An expression activates nothing until an application plays it.
  expression: () => null,
}

/** Creates an area's drivers of every type except `morph`. */
function otherDrivers(area, i) {
  return Object.values(OTHER_DRIVERS)
    .map((create) => create(area, i))
    .filter(Boolean)
}

function morphDriver(area, i) {
  const targets = Array.from({ length: LINKS }, (_, k) => ({
    name: `target${linkedTarget(i, k)}`,
    weight: LINK_WEIGHT,
  }))
  return { type: 'morph', area, targets, rule: 'sum', curve: CURVE }
}

/** Index of the blendshape that the morph driver of area `i` reads as its `k`-th target. */
function linkedTarget(i, k) {
  return (i * 5 + k * 11) % TARGETS
}

if (process.argv[1] === fileURLToPath(import.meta.url)) {
  const { microseconds, bytes } = measureCpu(false)
  process.stdout.write(`one face: ${microseconds.toFixed(2)} microseconds, ${bytes.toFixed(1)} bytes\n`)
  for (const faces of [1, 1000, 10_000]) {
    const [furrow, minimal] = [measureCrowdCpu, measureMinimalCpu].map((measured) => measured(faces))
    const line = ({ moving, still }) => `${moving.toFixed(2)} moving, ${still.toFixed(2)} still`
    process.stdout.write(
      `per face of ${faces} instances: ${line(furrow)}; minimal implementation: ${line(minimal)}\n`,
    )
  }
}
