import { mkdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs'
import { join } from 'node:path'
import { fileURLToPath } from 'node:url'
import { VRMExpression, VRMExpressionManager, VRMExpressionMorphTargetBind } from '@pixiv/three-vrm-core'
import { EXPRESSIONS, type WrinkleSet } from 'furrow'
import { FaceTracker, Wrinkles } from 'furrow/three'
import { afterAll, afterEach, beforeAll, describe, expect, it, vi } from 'vitest'
import { blendMesh } from '../blend-mesh.ts'
import { randomSet } from '../cases.ts'
import { seeded } from '../random.ts'

const ROOT = fileURLToPath(new URL('../..', import.meta.url))

/** Folder to which examples are written, for Vite to compile. Git ignores it. */
const FOLDER = join(ROOT, 'test/output/docs-run')
beforeAll(() => mkdirSync(FOLDER, { recursive: true }))
afterAll(() => rmSync(FOLDER, { recursive: true, force: true }))
afterEach(() => vi.restoreAllMocks())

const read = (page: string) => readFileSync(join(ROOT, page), 'utf8')

/** Loads, as a module, the example on a page that exports a function of this name. */
async function example(page: string, name: string) {
  const texts = [...read(page).matchAll(/^```ts\n([\s\S]*?)^```$/gm)].map(([, text]) => text)
  const text = texts.find((each) => each.includes(`export function ${name}(`))
  expect(text, `${page} has an example ${name}`).toBeDefined()
  const file = join(FOLDER, `${page.replaceAll('/', '-')}-${name}.ts`)
  writeFileSync(file, text!)
  return (await import(/* @vite-ignore */ file))[name]
}

/** Names of the areas of the shipped face, and of the areas that `furrow auto` makes. */
const AREAS: string[] = JSON.parse(read('faces/human/wrinkles.json')).areas.map(
  (area: { name: string }) => area.name,
)

function set(): WrinkleSet {
  const { layers, areas } = randomSet(seeded(1), 1, 8)
  return { layers, areas: AREAS.map((name) => ({ ...areas[0], name })) }
}

/** Makes a face with the blendshapes that the preset expressions use. */
function face() {
  const mesh = blendMesh(...new Set(EXPRESSIONS.flatMap(({ targets }) => Object.keys(targets))))
  return { mesh, wrinkles: new Wrinkles(mesh, set()) }
}

describe('examples of the documentation run', () => {
  it('tracking: follow sets the scores of each picture, and looks up names once', async () => {
    const { mesh } = face()
    const bind = vi.spyOn(mesh, 'traverse')
    const set = vi.spyOn(FaceTracker.prototype, 'set')
    const follow = (await example('docs/tracking.md', 'follow'))(mesh)
    for (let i = 0; i < 3; i++) {
      follow({ faceBlendshapes: [{ categories: [{ categoryName: 'jawOpen', score: 0.5 }] }] })
    }
    expect(mesh.morphTargetInfluences![mesh.morphTargetDictionary!.jawOpen]).toBe(0.5)
    expect([set.mock.calls.length, bind.mock.calls.length]).toEqual([3, 1])
  })

  it('live: followLive sets the scores of each message', async () => {
    let socket: { onmessage?: (event: { data: string }) => void } = {}
    vi.stubGlobal('WebSocket', function WebSocket(this: typeof socket) {
      socket = this
    })
    const { mesh } = face()
    const followLive = await example('docs/live.md', 'followLive')
    followLive(mesh, 'ws://127.0.0.1:8765/?token=x')
    socket.onmessage!({ data: JSON.stringify({ source: 'vmc', time: 1, scores: { JawOpen: 0.5 } }) })
    expect(mesh.morphTargetInfluences![mesh.morphTargetDictionary!.jawOpen]).toBe(0.5)
    vi.unstubAllGlobals()
  })

  it('tracking: remember saves a calibration and loads it', async () => {
    const items = new Map<string, string>()
    vi.stubGlobal('localStorage', {
      getItem: (key: string) => items.get(key) ?? null,
      setItem: (key: string, value: string) => items.set(key, value),
    })
    const remember = await example('docs/tracking.md', 'remember')
    const [first, second] = [new FaceTracker(face().mesh), new FaceTracker(face().mesh)]
    const save = remember(first)
    first.record('neutral', 1)
    for (let time = 0; time < 2; time += 0.1) first.set({ jawOpen: 0.25 }, time)
    save()
    remember(second)
    expect(second.calibration.shapes.jawOpen.neutral).toBe(0.25)
    vi.unstubAllGlobals()
  })

  it('tracking: speak plays visemes, on faces with and without visemes', async () => {
    const speak = await example('docs/tracking.md', 'speak')
    const speech = { visemes: ['PP', 'aa', 'aa'], vtimes: [100, 200, 600], vdurations: [100, 200, 200] }
    const weights = (time: number, ...names: string[]) => {
      const mesh = blendMesh(...names)
      speak(mesh, speech)(time)
      return mesh.morphTargetInfluences!
    }
    expect(weights(150, 'viseme_PP', 'viseme_aa')).toEqual([0.9, expect.closeTo(0.15)])
    expect(weights(300, 'viseme_PP', 'viseme_aa')).toEqual([0, 0.6])
    expect(weights(700, 'viseme_PP', 'viseme_aa')).toEqual([0, 0.6])
    expect(weights(1000, 'viseme_PP', 'viseme_aa')).toEqual([0, 0])
    expect(weights(300, 'jawOpen', 'mouthPressLeft')).toEqual([expect.closeTo(0.36), 0])
    expect(weights(150, 'jawOpen', 'mouthPressLeft')).toEqual([expect.closeTo(0.09), 0.45])
  })

  it('tracking: followAvatar moves blendshapes that three-vrm resets', async () => {
    const mesh = blendMesh('Fcl_MTH_A', 'browInnerUp')
    const manager = new VRMExpressionManager()
    const aa = new VRMExpression('aa')
    aa.addBind(new VRMExpressionMorphTargetBind({ primitives: [mesh], index: 0, weight: 1 }))
    manager.registerExpression(aa)
    const follow = (await example('docs/tracking.md', 'followAvatar'))({
      scene: mesh,
      update: () => manager.update(),
    })
    for (let i = 0; i < 3; i++) {
      follow({ jawOpen: 0.5, browInnerUp: 0.25 }, 1 / 60)
      expect(mesh.morphTargetInfluences).toEqual([0.5, 0.25])
    }
  })

  it('expressions: react plays expressions', async () => {
    const { mesh, wrinkles } = face()
    const player = (await example('docs/expressions.md', 'react'))(mesh, wrinkles)
    player.update(1)
    expect(mesh.morphTargetInfluences!.some((weight) => weight > 0)).toBe(true)
  })

  it('expressions: scorn animates an area', async () => {
    const { mesh, wrinkles } = face()
    const mixer = (await example('docs/expressions.md', 'scorn'))(mesh)
    mixer.update(0.5)
    expect(wrinkles.getActivation('nose')).toBe(1)
  })

  it('three: raiseBrow activates an area', async () => {
    const { wrinkles } = face()
    ;(await example('docs/three.md', 'raiseBrow'))(wrinkles, 0.5)
    expect(wrinkles.getActivation('foreheadLeft')).toBe(0.5)
  })

  it('expressions: play plays a custom expression', async () => {
    const warn = vi.spyOn(console, 'warn').mockImplementation(() => {})
    const { mesh, wrinkles } = face()
    ;(await example('docs/expressions.md', 'play'))(mesh, wrinkles)
    expect(warn).not.toHaveBeenCalled()
  })

  it('name only areas of the shipped face', () => {
    for (const page of ['docs/babylon.md', 'docs/crowds.md', 'docs/three.md']) {
      const names = [...read(page).matchAll(/setActivation\('(\w+)'/g)].map(([, name]) => name)
      // `scar` is an area that the example adds.
      expect(AREAS, page).toEqual(expect.arrayContaining(names.filter((name) => name !== 'scar')))
    }
  })
})
