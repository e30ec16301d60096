import { setFlagsFromString } from 'node:v8'
import { runInNewContext } from 'node:vm'
import { EXPRESSIONS, findTargets } from 'furrow'
import { ExpressionPlayer, FaceTracker, Wrinkles } from 'furrow/three'
import { expect, it } from 'vitest'
import { combinableTargets } from '../../../packages/furrow/src/three/sources/combined-targets.ts'
import { blendMesh } from '../../blend-mesh.ts'
import { layer, randomNormals } from '../../cases.ts'
import { seeded } from '../../random.ts'
import { frameOf } from './stub-renderer.ts'

setFlagsFromString('--expose-gc')
const collectGarbage = runInNewContext('gc') as () => void

const FRAMES = 20_000

/** Measurements of each case. Some may be too high because the JavaScript optimiser runs in parallel and can be late. */
const ROUNDS = 10

it('allocates nothing per frame during a transition', () => {
  const { player } = movingFace()
  const frames = (count: number) => {
    for (let i = 0; i < count; i++) player.update(1e-7)
  }
  player.play('surprised', 1)
  expect(bytesPerFrame(frames)).toBeLessThan(4)
})

it('allocates nothing per frame while an area moves', () => {
  const { mesh, wrinkles } = movingFace()
  const draw = frameOf(mesh)
  const areas = wrinkles.areaNames.slice(0, 1)
  const values = new Float32Array(1)
  const frames = (count: number) => {
    for (let i = 0; i < count; i++) {
      values[0] = (i % 4) / 4
      wrinkles.setActivations(areas, values)
      draw()
    }
  }
  expect(bytesPerFrame(frames)).toBeLessThan(4)
  expect(wrinkles.getActivation(areas[0])).toBe(0.75)
})

it("allocates nothing while reading a VRM's combined blendshapes", () => {
  const nodes = [{ mesh: 0 }]
  const happy = { morphTargetBinds: [0, 1].map((index) => ({ node: 0, index, weight: 0.5 })) }
  const extensions = { VRMC_vrm: { expressions: { preset: { happy } } } }
  const meshes = [{ primitives: [{ targets: [{}, {}] }], extras: { targetNames: ['cheek', 'mouth'] } }]
  const mesh = blendMesh('happy')
  const { names, read } = combinableTargets({ nodes, meshes, extensions }, 0)(mesh)
  const values = new Float64Array(names.length)
  const frames = (count: number) => {
    for (let i = 0; i < count; i++) {
      mesh.morphTargetInfluences![0] = (i % 10) / 10
      read(values, 0)
    }
  }
  expect(bytesPerFrame(frames)).toBeLessThan(4)
  expect([names, values]).toEqual([['cheek', 'mouth', 'happy'], Float64Array.of(0.45, 0.45, 0.9)])
})

it('allocates nothing per frame of a face tracker', () => {
  const names = ['_neutral', 'browDownLeft', 'mouthUpperUpLeft', 'noseSneerLeft', 'jawOpen']
  const tracker = new FaceTracker(blendMesh(...names))
  const scores = names.map((categoryName) => ({ categoryName, score: 0.5 }))
  // Whole numbers, because V8 allocates fractions that the test passes.
  let time = 0
  const frames = (count: number) => {
    for (let i = 0; i < count; i++) tracker.set(scores, ++time)
  }
  expect(bytesPerFrame(frames)).toBeLessThan(4)
})

/** Returns the minimum over the rounds. An allocation of one number per frame would be 16 bytes in each of them. */
function bytesPerFrame(frames: (count: number) => void): number {
  frames(FRAMES) // lets the optimiser compile the code
  const used = Array.from({ length: ROUNDS }, () => {
    collectGarbage()
    const before = process.memoryUsage().heapUsed
    frames(FRAMES)
    return (process.memoryUsage().heapUsed - before) / FRAMES
  })
  return Math.min(...used)
}

/** Creates a face with all blendshapes and areas that the expressions use. */
function movingFace() {
  const targets = [...new Set(EXPRESSIONS.flatMap((expression) => Object.keys(expression.targets)))]
  const areas = [...new Set(EXPRESSIONS.flatMap((expression) => Object.keys(expression.activations)))]
  const mesh = blendMesh(...targets)
  expect(findTargets('browInnerUp', Object.keys(mesh.morphTargetDictionary!))).toHaveLength(1)
  const weights = { width: 2, height: 2, data: new Uint8Array(4) }
  const wrinkles = new Wrinkles(mesh, {
    layers: [layer('skin', 'replace', randomNormals(seeded(1), 2))],
    areas: areas.map((name) => ({ name, weights })),
  })
  return { mesh, player: new ExpressionPlayer(mesh, wrinkles), wrinkles }
}
