import {
  DirectionalLight,
  DoubleSide,
  Mesh,
  MeshStandardMaterial,
  MeshToonMaterial,
  PlaneGeometry,
  Scene,
} from 'three'
import { beforeAll, describe, expect, it } from 'vitest'
import { randomAreas, randomImage, randomNormals } from '../cases.ts'
import { seeded } from '../random.ts'
import { largestDifference } from './difference.ts'
import { mapOf } from './face.ts'
import { harnessOn, RENDERERS, square, squareCamera } from './harness.ts'
import { KINDS, MAP, randomLayer } from './layer-values.ts'

const PIXELS = 64

describe.each(RENDERERS)('shadows on %s', (name) => {
  const harness = harnessOn(name)
  beforeAll(() => {
    harness.renderer.shadowMap.enabled = true
  })

  // A renderer draws shadows with a separate material, which uses the colour nodes of the mesh.
  it.each([
    ['standard', false, MeshStandardMaterial],
    ['standard', true, MeshStandardMaterial],
    ['toon', true, MeshToonMaterial],
  ])(
    'of a %s material with its own maps (%s) equal those of the plain mesh',
    async (_, hasMaps, Material) => {
      const random = seeded(4)
      const material = new Material({
        map: hasMaps ? mapOf(randomImage(random, MAP)) : null,
        normalMap: mapOf(randomNormals(random, MAP)),
        shadowSide: DoubleSide,
      })
      const mesh = square(material)
      const scene = shadowed(mesh)
      const unshadowed = await shoot(scene, false)
      const plain = await shoot(scene, true)
      const [area] = randomAreas(random, 1, MAP)
      const layer = randomLayer(random, 'layer', [...KINDS])
      const wrinkles = new harness.Wrinkles(mesh, {
        layers: [layer],
        areas: [{ ...area!, layer: 'layer' }],
      })
      wrinkles.setActivation(area!.name, 1)
      expect(largestDifference(await shoot(scene, true), plain)).toBe(0)
      expect(largestDifference(unshadowed, plain)).toBeGreaterThan(0.1)
      wrinkles.dispose()
    },
  )

  /** Draws only the ground. The mesh is outside the view of the camera. */
  function shoot(scene: Scene, castsShadow: boolean) {
    scene.children[0]!.castShadow = castsShadow
    return harness.render(scene, squareCamera(), PIXELS)
  }
})

/** Creates a scene in which a mesh outside the picture casts a shadow into the picture. */
function shadowed(mesh: Mesh): Scene {
  const ground = new Mesh(new PlaneGeometry(4, 4), new MeshStandardMaterial())
  ground.position.z = -1
  ground.receiveShadow = true
  mesh.position.x = 2.5
  const light = new DirectionalLight(0xffffff, 3)
  light.position.set(2, 0, 1)
  light.castShadow = true
  light.shadow.mapSize.set(256, 256)
  Object.assign(light.shadow.camera, { left: -3, right: 3, top: 3, bottom: -3, near: 0.01, far: 10 })
  return new Scene().add(mesh, ground, light)
}
