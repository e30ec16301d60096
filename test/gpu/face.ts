import type { RgbaImage, WrinkleSet } from 'furrow'
import { combineNormals } from 'furrow/author'
import { packAreas, reference } from 'furrow/internal'
import { loadWrinkleSet } from 'furrow/three'
import {
  AmbientLight,
  DataTexture,
  DirectionalLight,
  LinearFilter,
  LinearMipmapLinearFilter,
  type Material,
  MeshBasicMaterial,
  type MeshStandardMaterial,
  PerspectiveCamera,
  Scene,
} from 'three'
import { uv, vec3 } from 'three/tsl'
import { MeshBasicNodeMaterial } from 'three/webgpu'
import { readTexture } from '../../packages/furrow/src/three/loader/read-texture.ts'
import { type Face, loadFace } from '../../stage/face.ts'
import { frameView, type ViewName } from '../../stage/views.ts'
import type { Harness } from './harness.ts'

export const WIDTH = 240
export const HEIGHT = 320

/** Loads the shipped face and its wrinkle set. Removes the drivers, because they would change the activations that tests set. */
export async function loadUndriven(): Promise<{ face: Face; set: WrinkleSet }> {
  const face = await loadFace('/faces/human.glb')
  const { drivers: _, ...set } = await loadWrinkleSet('/faces/human/wrinkles.json')
  return { face, set }
}

/** Creates a scene with one face and two lights. */
export function faceScene({ root, skin }: Pick<Face, 'root' | 'skin'>, view: ViewName) {
  const scene = new Scene()
  const key = new DirectionalLight(0xffffff, 1.6)
  key.position.set(-1, 1, 1.5)
  scene.add(root, key, new AmbientLight(0xffffff, 0.4))
  const camera = new PerspectiveCamera()
  camera.aspect = WIDTH / HEIGHT
  frameView(skin, camera, view)
  return { scene, camera }
}

/** Renders the face with a given material on the skin. */
export async function renderWith(
  harness: Harness,
  face: Face,
  stage: ReturnType<typeof faceScene>,
  material: Material,
) {
  const original = face.skin.material
  face.skin.material = material
  const pixels = await harness.render(stage.scene, stage.camera, WIDTH, HEIGHT)
  face.skin.material = original
  return pixels
}

/** Creates a material that writes (u, v, 1) as colour, so that tests can read the texture coordinates of each pixel. */
export function uvMaterial(harness: Harness): Material {
  if (harness.name !== 'webgl') {
    const material = new MeshBasicNodeMaterial()
    material.colorNode = vec3(uv(), 1)
    return material
  }
  const material = new MeshBasicMaterial()
  material.defines = { USE_UV: '' }
  material.onBeforeCompile = (shader) => {
    shader.fragmentShader = shader.fragmentShader.replace(
      '#include <map_fragment>',
      'diffuseColor.rgb = vec3(vUv, 1.0);',
    )
  }
  return material
}

/** Copies the skin's material. The copy's normal map includes the wrinkles of the first layer at full influence. */
export function wrinkledMaterial(plain: MeshStandardMaterial, set: WrinkleSet): MeshStandardMaterial {
  const combined = combineNormals(readTexture(plain.normalMap!, 'test'), set.layers[0].normal)
  const material = plain.clone()
  material.normalMap = mapOf(combined)
  return material
}

/** Creates a texture with the same filters as the maps of layers. */
export function mapOf({ data, width, height }: RgbaImage, anisotropy = 1): DataTexture {
  const map = new DataTexture(data, width, height)
  map.minFilter = LinearMipmapLinearFilter
  map.magFilter = LinearFilter
  map.generateMipmaps = true
  map.anisotropy = anisotropy
  map.needsUpdate = true
  return map
}

/**
 * Computes in float64 how strongly the wrinkles show (their influence, 0..1) at every pixel of a picture drawn with `uvMaterial`. The result
 * is NaN where no skin is visible.
 */
export function referenceInfluence(
  uvs: Float32Array,
  set: WrinkleSet,
  activations: Record<string, number>,
): Float64Array {
  const areas = packAreas(set.areas.map(({ weights }) => weights))
  const table = set.areas.map(({ name, combine }) => ({
    activation: activations[name] ?? 0,
    layer: 0,
    combine: combine ?? ('sum' as const),
  }))
  return Float64Array.from({ length: WIDTH * HEIGHT }, (_, i) =>
    uvs[i * 4 + 2] === 1 ? reference.influence(areas, table, uvs[i * 4], uvs[i * 4 + 1]) : Number.NaN,
  )
}
