import {
  Bone,
  BoxGeometry,
  BufferAttribute,
  DataTexture,
  DirectionalLight,
  EquirectangularReflectionMapping,
  FloatType,
  InstancedMesh,
  LinearFilter,
  Matrix4,
  Mesh,
  MeshStandardMaterial,
  type Object3D,
  Scene,
  Skeleton,
  SkinnedMesh,
} from 'three'
import { describe, expect, it } from 'vitest'
import { randomNormals, randomSet } from '../cases.ts'
import { seeded } from '../random.ts'
import { type Harness, harnessOn, RENDERERS, square, squareCamera } from './harness.ts'

interface Feature {
  /** Applies the feature to a square. Returns the mesh to which the test adds wrinkles. */
  apply(mesh: Mesh, scene: Scene, harness: Harness): Mesh
}

/** Features of three.js, besides the material, that characters use and that must work with wrinkles. */
const FEATURES: Record<string, Feature> = {
  'morph targets': {
    apply(mesh) {
      mesh.geometry.morphAttributes.position = [
        new BufferAttribute(
          Float32Array.from({ length: 12 }, (_, i) => i / 30),
          3,
        ),
      ]
      mesh.geometry.morphAttributes.normal = [
        new BufferAttribute(
          Float32Array.from({ length: 12 }, (_, i) => i / 40),
          3,
        ),
      ]
      mesh.geometry.morphTargetsRelative = true
      mesh.updateMorphTargets()
      mesh.morphTargetInfluences![0] = 0.7
      return mesh
    },
  },
  skinning: {
    apply(mesh) {
      const bone = new Bone()
      mesh.geometry.setAttribute('skinIndex', new BufferAttribute(new Uint16Array(16), 4))
      mesh.geometry.setAttribute(
        'skinWeight',
        new BufferAttribute(
          Float32Array.from({ length: 16 }, (_, i) => (i % 4 ? 0 : 1)),
          4,
        ),
      )
      const skinned = new SkinnedMesh(mesh.geometry, mesh.material)
      skinned.add(bone)
      skinned.bind(new Skeleton([bone]))
      bone.rotation.set(0.3, 0.4, 0.1)
      return skinned
    },
  },
  shadows: {
    apply(mesh, scene, harness) {
      harness.renderer.shadowMap.enabled = true
      const light = scene.getObjectByName('key') as DirectionalLight
      light.castShadow = true
      light.shadow.mapSize.set(256, 256)
      mesh.receiveShadow = true
      const occluder = new Mesh(new BoxGeometry(0.5, 0.5, 0.5), new MeshStandardMaterial())
      occluder.position.set(0.8, 0.8, 1)
      occluder.castShadow = true
      scene.add(occluder)
      return mesh
    },
  },
  environment: {
    apply(mesh, scene) {
      const sky = new DataTexture(
        Float32Array.from({ length: 16 * 8 * 4 }, seeded(8)),
        16,
        8,
        undefined,
        FloatType,
      )
      sky.mapping = EquirectangularReflectionMapping
      sky.minFilter = LinearFilter
      sky.magFilter = LinearFilter
      sky.needsUpdate = true
      scene.environment = sky
      return mesh
    },
  },
  instancing: {
    apply(mesh) {
      const instances = new InstancedMesh(mesh.geometry, mesh.material, 2)
      instances.setMatrixAt(0, new Matrix4().makeScale(0.5, 0.5, 1).setPosition(-0.5, 0, 0))
      instances.setMatrixAt(1, new Matrix4().makeScale(0.5, 0.9, 1).setPosition(0.5, 0, 0))
      return instances
    },
  },
}

describe.each(RENDERERS)("the user's scene on %s", (name) => {
  const harness = harnessOn(name)

  it.each(Object.entries(FEATURES))('keeps %s working with wrinkles', async (_, { apply }) => {
    const scene = new Scene()
    const light = new DirectionalLight(0xffffff, 2)
    light.name = 'key'
    light.position.set(1, 1, 1.5)
    const material = new MeshStandardMaterial({ color: 0xd0a080, roughness: 0.4 })
    const base = randomNormals(seeded(1), 16)
    material.normalMap = new DataTexture(base.data, 16, 16)
    material.normalMap.needsUpdate = true
    const plainSquare = square(material)
    scene.add(light, plainSquare)
    const picture = async () => (await harness.renderBytes(scene, squareCamera(), 32)).join()
    const without = await picture()
    scene.remove(plainSquare)
    const mesh = apply(square(material), scene, harness)
    scene.add(mesh as Object3D)
    const plain = await picture()
    expect(plain, 'the feature is visible').not.toBe(without)
    const wrinkles = new harness.Wrinkles(mesh, randomSet(seeded(3), 4, 8, 16), { areaSize: 8 })
    expect(await picture(), 'no change at rest').toBe(plain)
    wrinkles.setActivation('area1', 1)
    expect(await picture(), 'wrinkles are visible').not.toBe(plain)
    wrinkles.dispose()
    expect(await picture(), 'as before after dispose').toBe(plain)
  })
})
