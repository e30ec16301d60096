import { DirectionalLight } from '@babylonjs/core/Lights/directionalLight.js'
import { ShadowGenerator } from '@babylonjs/core/Lights/Shadows/shadowGenerator.js'
import '@babylonjs/core/Lights/Shadows/shadowGeneratorSceneComponent.js'
import { PBRMaterial } from '@babylonjs/core/Materials/PBR/pbrMaterial.js'
import { Vector3 } from '@babylonjs/core/Maths/math.vector.js'
import { MorphTarget } from '@babylonjs/core/Morph/morphTarget.js'
import { MorphTargetManager } from '@babylonjs/core/Morph/morphTargetManager.js'
import type { Scene } from '@babylonjs/core/scene.js'
import { addDrivers, Wrinkles } from 'furrow/babylon'
import { describe, expect, it } from 'vitest'
import { randomSet } from '../../cases.ts'
import { seeded } from '../../random.ts'
import { largestDifference } from '../difference.ts'
import { driver } from '../wrinkled-file.ts'
import { type BabylonHarness, ENGINES, harnessOn, square } from './harness.ts'

const PIXELS = 64

describe.each(ENGINES)('shadows in Babylon.js on %s', (name) => {
  const harness = harnessOn(name)

  it('of a face moved by blendshapes equal those without wrinkles', async () => {
    const { scene, mesh, target } = shadowed(harness)
    const pose = async (weight: number) => {
      target.influence = weight
      // Shadow maps may be drawn before all shaders are ready.
      for (let i = 0; i < 3; i++) await harness.render(scene, PIXELS)
      return harness.render(scene, PIXELS)
    }
    const [rest, moved] = [await pose(0), await pose(1)]
    expect(largestDifference(rest, moved)).toBeGreaterThan(0.1)
    const set = randomSet(seeded(3), 2, 8, 16)
    const wrinkles = new Wrinkles(mesh, set)
    const area = set.areas[0].name
    addDrivers(wrinkles, [driver(area, 'aside')])
    expect(await pose(1)).toEqual(moved)
    expect(wrinkles.getActivation(area)).toBe(1)
    expect(await pose(0)).toEqual(rest)
    wrinkles.dispose()
    scene.dispose()
  })
})

/** Creates a scene in which a mesh outside the picture casts a shadow into the picture. A morph target moves the mesh. */
function shadowed(harness: BabylonHarness) {
  const scene = harness.createScene()
  const ground = square(scene, 1)
  ground.position.z = 1
  ground.receiveShadows = true
  const mesh = square(scene)
  mesh.scaling.setAll(0.3)
  mesh.position.set(2, 0, 0)
  for (const own of [ground, mesh]) own.material = skin(scene)
  const target = new MorphTarget('aside', 0, scene)
  target.setPositions(mesh.getVerticesData('position')!.map((value, i) => value + (i % 3 === 1 ? 1.5 : 0)))
  target.setNormals(mesh.getVerticesData('normal')!)
  const manager = new MorphTargetManager(scene)
  manager.addTarget(target)
  mesh.morphTargetManager = manager
  const light = new DirectionalLight('light', new Vector3(-2, 0, 1), scene)
  light.position.set(4, 0, -2)
  const generator = new ShadowGenerator(256, light)
  generator.addShadowCaster(mesh)
  return { scene, mesh, target }
}

function skin(scene: Scene): PBRMaterial {
  const material = new PBRMaterial('skin', scene)
  Object.assign(material, { metallic: 0, roughness: 1, backFaceCulling: false })
  return material
}
