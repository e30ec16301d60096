import { LoadAssetContainerAsync } from '@babylonjs/core/Loading/sceneLoader.js'
import { Vector3 } from '@babylonjs/core/Maths/math.vector.js'
import type { AbstractMesh } from '@babylonjs/core/Meshes/abstractMesh.js'
import '@babylonjs/loaders/glTF/2.0/glTFLoader.js'
import { parseDrivers, type WrinkleDriver } from 'furrow'
import * as babylon from 'furrow/babylon'
import * as three from 'furrow/three'
import type { SkinnedMesh } from 'three'
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js'
import { afterAll, beforeAll, expect, it } from 'vitest'
import { type BabylonHarness, createHarness } from './harness.ts'

const FACE = '/faces/human.glb'
const WEIGHTS = { browInnerUp: 1, mouthSmileLeft: 0.7, pull: 0.8 }

let container: Awaited<ReturnType<typeof LoadAssetContainerAsync>>
let gltf: Awaited<ReturnType<GLTFLoader['loadAsync']>>
let harness: BabylonHarness

beforeAll(async () => {
  babylon.registerWrinkleMaps()
  harness = await createHarness('webgl')
  const scene = harness.createScene()
  const bytes = new Uint8Array(await (await fetch(FACE)).arrayBuffer())
  container = await LoadAssetContainerAsync(bytes, scene, { pluginExtension: '.glb' })
  container.addAllToScene()
  gltf = await new GLTFLoader().register((parser) => new three.WrinkleLoaderPlugin(parser)).loadAsync(FACE)
})
afterAll(() => harness.dispose())

it('tension, muscles and joints have the same values as in three.js', () => {
  const [shown] = babylon.wrinklesOf(container)
  const [exact] = three.wrinklesOf(gltf)
  const drivers = driversOf(exact)
  babylon.setDrivers(shown, drivers)
  three.setDrivers(exact, drivers)
  const values = () => {
    shown.update()
    gltf.scene.updateMatrixWorld(true)
    exact.update()
    return [shown, exact].map((own) => exact.areaNames.map((name) => own.getActivation(name)))
  }
  const [rest] = values()
  moveBabylon(shown.mesh)
  moveThree(exact.mesh as SkinnedMesh)
  const [found, expected] = values()
  for (const [i, name] of exact.areaNames.entries()) expect(found[i], name).toBeCloseTo(expected[i], 4)
  expect(found.filter((value, i) => Math.abs(value - rest[i]) > 0.01).length).toBeGreaterThan(5)
})

/** Returns drivers: tension for all areas but the last, a joint angle for the last. */
function driversOf({ areaNames, mesh }: three.WrinklesBase): WrinkleDriver[] {
  const { position } = mesh.geometry.attributes
  const forehead = [0, 1, 2].map((axis) => position.getComponent(0, axis))
  const { bones = [] } = (mesh as SkinnedMesh).skeleton ?? {}
  const tension = areaNames.slice(0, -1).map((area, i) => ({
    type: 'tension',
    area,
    measure: i % 2 ? 'stretch' : 'compression',
    ...(i % 3 === 0 && { direction: [1, 0] }),
    curve: [
      [-0.5, 0],
      [0.5, 1],
    ],
  }))
  const drivers = [
    {
      type: 'muscle',
      name: 'pull',
      origin: forehead.map((value, axis) => value + (axis === 1 ? 0.03 : 0)),
      insertion: forehead,
      angle: 1.5,
      outer: 4,
    },
    ...tension,
    ...(bones.length > 1
      ? [
          {
            type: 'bone',
            area: areaNames.at(-1),
            joints: [bones[0].name, bones[1].name],
            measure: 'angle',
            curve: [
              [0, 0],
              [1, 1],
            ],
          },
        ]
      : []),
  ]
  return parseDrivers(drivers, areaNames)
}

function moveBabylon(mesh: AbstractMesh): void {
  const targets = mesh.morphTargetManager!
  for (let i = 0; i < targets.numTargets; i++) {
    targets.getTarget(i).influence = WEIGHTS[targets.getTarget(i).name as 'pull'] ?? 0
  }
  mesh.skeleton?.bones[1]?.getTransformNode()?.rotate(Vector3.Right(), 0.3)
}

function moveThree({ morphTargetDictionary, morphTargetInfluences, skeleton }: SkinnedMesh): void {
  for (const [name, weight] of Object.entries(WEIGHTS))
    morphTargetInfluences![morphTargetDictionary![name]] = weight
  skeleton?.bones[1]?.rotateX(0.3)
}
