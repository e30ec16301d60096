import { type VRM, VRMLoaderPlugin, VRMUtils } from '@pixiv/three-vrm'
import { ExpressionPlayer, WrinkleLoaderPlugin, wrinklesOf, wrinklesReady } from 'furrow/three'
import { type Object3D, Scene } from 'three'
import { type GLTF, GLTFLoader } from 'three/addons/loaders/GLTFLoader.js'
import { clone as cloneSkinned } from 'three/addons/utils/SkeletonUtils.js'
import { afterEach, describe, expect, it, vi } from 'vitest'
import { asVrm1 } from '../../vrm.ts'
import { createHarness, harnessOn, squareCamera } from '../harness.ts'
import { vrmFile } from '../vrm-file.ts'
import { driver, faceMeshes } from '../wrinkled-file.ts'
import { bareSheet } from './bare-sheet.ts'

/** Blendshapes of the face. The expression `sad` moves `sad` and `browInnerUp`. */
const SHAPES = ['browInnerUp', 'other', 'sad']
/** Weights of these blendshapes in each expression. */
const EXPRESSIONS: Record<string, number[]> = {
  happy: [0.5, 0, 0],
  sad: [0.7, 0, 1],
  angry: [0, 1, 0],
  surprised: [1, 1, 0],
}
/** Names of the expressions in VRM 0, by the name in VRM 1.0. */
const PRESETS: Record<string, string> = { happy: 'joy', sad: 'sorrow', angry: 'angry' }

afterEach(() => vi.restoreAllMocks())

describe.each([
  ['VRM 0', vrm0],
  ['VRM 1.0', vrm1],
])("the face of a %s after three-vrm's combineMorphs", (_, addExpressions) => {
  const harness = harnessOn('webgl')

  const load = async (): Promise<GLTF> => {
    const file = await vrmFile(
      false,
      ({ drivers }) =>
        drivers.splice(0, 1, driver('a', 'browInnerUp'), driver('c', 'angry'), driver('d', 'sad')),
      // biome-ignore lint/suspicious/noExplicitAny: the JSON of a file
      (json: any) => {
        const [mesh] = json.meshes
        mesh.extras.targetNames = SHAPES
        mesh.weights = SHAPES.map(() => 0)
        for (const primitive of mesh.primitives) primitive.targets = SHAPES.map(() => primitive.targets[0])
        addExpressions(json)
      },
    )
    return new GLTFLoader()
      .register((parser) => new WrinkleLoaderPlugin(parser))
      .register((parser) => new VRMLoaderPlugin(parser))
      .parseAsync(file.buffer, '')
  }
  const combine = (gltf: GLTF) => {
    VRMUtils.combineMorphs(gltf.userData.vrm)
    for (const mesh of faceMeshes(gltf.scene))
      expect(Object.keys(mesh.morphTargetDictionary!)).not.toContain('other')
  }
  const draw = (root: Object3D) => harness.renderBytes(new Scene().add(root), squareCamera(), 8)
  const activations = (root: Object3D) => {
    const wrinkles = wrinklesOf(faceMeshes(root)[0])!
    return ['a', 'c', 'd'].map((area) => wrinkles.getActivation(area))
  }
  /** Returns the activations in each expression, then in combinations of expressions. */
  const responses = async (gltf: GLTF) => {
    const { expressionManager } = gltf.userData.vrm as VRM
    const poses = Object.keys(EXPRESSIONS).map((name): Record<string, number> => ({ [name]: 1 }))
    const shown: number[][] = []
    for (const pose of [...poses, { happy: 0.6, sad: 0.3, angry: 0.8 }, {}]) {
      for (const name of Object.keys(EXPRESSIONS)) expressionManager!.setValue(name, pose[name] ?? 0)
      expressionManager!.update()
      await draw(gltf.scene)
      shown.push(activations(gltf.scene))
    }
    return shown
  }
  const curve = (weight: number) => Math.max(0, (weight - 0.2) / 0.8)
  const EXPECTED = [
    [curve(0.5), 0, 0],
    [curve(0.7), 0, 1],
    [0, 1, 0],
    [1, 0, 0],
    [curve(0.6 * 0.5 + 0.3 * 0.7), curve(0.8), curve(0.3)],
    [0, 0, 0],
  ]
  const close = (rows: number[][]) => rows.map((row) => row.map((value) => expect.closeTo(value, 5)))

  it.each([
    ['before the first frame', 0],
    ['after some frames', 3],
  ])('wrinkles the same if combineMorphs is called %s', async (_, frames) => {
    const warn = vi.spyOn(console, 'warn')
    const gltf = await load()
    for (let i = 0; i < frames; i++) expect(await responses(gltf)).toEqual(close(EXPECTED))
    combine(gltf)
    expect(await responses(gltf)).toEqual(close(EXPECTED))
    expect(warn.mock.calls.filter(([text]) => /wrinkle/i.test(text))).toEqual([])
  })

  it("is played by the file's expressions through their blendshapes, on copies too", async () => {
    const { scene } = await load()
    for (const root of [scene, cloneSkinned(scene)]) {
      const [mesh] = faceMeshes(root)
      const player = new ExpressionPlayer(root, wrinklesOf(mesh))
      expect(player.expressionNames).toEqual(['neutral', ...Object.keys(EXPRESSIONS)])
      for (const [name, weights] of Object.entries(EXPRESSIONS)) {
        player.play(name, 0)
        expect(mesh.morphTargetInfluences).toEqual(weights.map((weight) => expect.closeTo(weight, 6)))
      }
      player.play('disgusted', 0)
      expect(mesh.morphTargetInfluences).toEqual([0, 0, 0])
    }
  })

  it.each([
    ['before', true],
    ['after', false],
  ])('gives copies made %s combineMorphs the same wrinkles', async (_, isBefore) => {
    // Before combineMorphs, copies lack the input `angry`, because they have no expression manager. A warning says so.
    vi.spyOn(console, 'warn').mockImplementation(() => {})
    const gltf = await load()
    const early = isBefore && cloneSkinned(gltf.scene)
    combine(gltf)
    const copy = early || cloneSkinned(gltf.scene)
    const [{ morphTargetDictionary, morphTargetInfluences }] = faceMeshes(copy)
    const index = morphTargetDictionary![isBefore ? 'browInnerUp' : 'happy']
    morphTargetInfluences![index] = isBefore ? 0.5 : 1
    await draw(copy)
    await draw(gltf.scene)
    expect([activations(copy), activations(gltf.scene)]).toEqual(close([EXPECTED[0], [0, 0, 0]]))
  })
})

it('automatic wrinkles that finish after combineMorphs follow expressions too', async () => {
  const harness = await createHarness('webgl')
  const shown = async (isCombined: boolean) => {
    const file = asVrm1(await bareSheet(), (json) => {
      const preset = { happy: { morphTargetBinds: [{ node: 0, index: 0, weight: 0.75 }] } }
      json.extensions.VRMC_vrm.expressions = { preset }
    })
    const auto = { size: 256, areaSize: 32 }
    const gltf = await new GLTFLoader()
      .register((parser) => new WrinkleLoaderPlugin(parser, { auto }))
      .register((parser) => new VRMLoaderPlugin(parser))
      .parseAsync(file.buffer, '')
    const { vrm } = gltf.userData
    if (isCombined) VRMUtils.combineMorphs(vrm)
    expect(wrinklesOf(gltf)).toEqual([])
    const [wrinkles] = await wrinklesReady(gltf)
    vrm.expressionManager.setValue('happy', 1)
    vrm.expressionManager.update()
    await harness.renderBytes(new Scene().add(gltf.scene), squareCamera(), 8)
    return wrinkles.areaNames.map((area) => wrinkles.getActivation(area))
  }
  const expected = await shown(false)
  expect(Math.max(...expected)).toBeGreaterThan(0.1)
  expect(await shown(true)).toEqual(expected)
  harness.dispose()
})

// biome-ignore lint/suspicious/noExplicitAny: the JSON of a file
function vrm1(json: any) {
  const node = nodeOfFace(json)
  const preset = Object.entries(EXPRESSIONS).map(([name, weights]) => [
    name,
    { morphTargetBinds: weights.map((weight, index) => ({ node, index, weight })) },
  ])
  json.extensions.VRMC_vrm.expressions = { preset: Object.fromEntries(preset) }
}

// biome-ignore lint/suspicious/noExplicitAny: the JSON of a file
function vrm0(json: any) {
  const { humanBones } = json.extensions.VRMC_vrm.humanoid as { humanBones: Record<string, object> }
  const { mesh } = json.nodes[nodeOfFace(json)]
  const blendShapeGroups = Object.entries(EXPRESSIONS).map(([name, weights]) => ({
    name,
    presetName: PRESETS[name] ?? 'unknown',
    binds: weights.map((weight, index) => ({ mesh, index, weight: 100 * weight })),
  }))
  json.extensionsUsed = json.extensionsUsed.filter((name: string) => name !== 'VRMC_vrm').concat('VRM')
  json.extensions = {
    VRM: {
      meta: { title: 'face' },
      humanoid: { humanBones: Object.entries(humanBones).map(([bone, node]) => ({ bone, ...node })) },
      blendShapeMaster: { blendShapeGroups },
    },
  }
}

function nodeOfFace({ nodes }: { nodes: { mesh?: number }[] }): number {
  return nodes.findIndex(({ mesh }) => mesh !== undefined)
}
