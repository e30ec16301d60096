import type { WrinkleSet } from 'furrow'
import {
  BufferAttribute,
  Float32BufferAttribute,
  Mesh,
  MeshStandardMaterial,
  OrthographicCamera,
  Scene,
  SphereGeometry,
} from 'three'

/** Radius of the ball, metres. */
export const RADIUS = 0.05

/** Height difference between black and white texels, metres. */
export const AMPLITUDE = 0.003

const SIZE = 256

/** Creates a ball with a UV seam, a blendshape that stretches it, and an emissive material, which shows its outline. */
export function ball(segments = 16): Mesh {
  const geometry = new SphereGeometry(RADIUS, segments, segments)
  const { position } = geometry.attributes
  // Rounds positions, so that both sides of the seam are equal: cos(2 * PI) and sin(2 * PI) are inexact.
  const rounded = Float32Array.from(position.array, (value) => Math.round(value * 1e6) / 1e6 + 0)
  geometry.setAttribute('position', new BufferAttribute(rounded, 3))
  const taller = rounded.map((value, i) => (i % 3 === 1 ? 0.3 * value : 0))
  geometry.morphAttributes.position = [new Float32BufferAttribute(taller, 3)]
  geometry.morphTargetsRelative = true
  const mesh = new Mesh(geometry, new MeshStandardMaterial({ color: 0, emissive: 0xffffff }))
  mesh.updateMorphTargets()
  return mesh
}

/** Returns the bytes of a height map that rises and falls several times around the ball. */
export function heightBytes(): Uint8Array {
  return Uint8Array.from({ length: SIZE * SIZE }, (_, i) => {
    const [u, v] = [(i % SIZE) / SIZE, Math.floor(i / SIZE) / SIZE]
    return Math.round(127.5 + 127.5 * Math.sin(6 * Math.PI * u + 0.4) * Math.cos(8 * Math.PI * v))
  })
}

/** Creates a wrinkle set with flat normals, and heights over the complete ball. */
export function heightSet(): WrinkleSet {
  const normal = { width: 1, height: 1, data: new Uint8Array([128, 128, 255, 255]) }
  const height = { width: SIZE, height: SIZE, data: heightBytes() }
  const weights = { width: 1, height: 1, data: new Uint8Array([255]) }
  return {
    layers: [{ name: 'waves', kind: 'detail', normal, height, heightAmplitude: AMPLITUDE }],
    areas: [{ name: 'all', weights, activation: 1 }],
  }
}

/** Creates a camera whose frame is `side` metres wide and high. */
export function sideCamera(side: number): OrthographicCamera {
  const camera = new OrthographicCamera(-side / 2, side / 2, side / 2, -side / 2, 0, 1)
  camera.position.z = 0.5
  return camera
}

export function sceneOf(...meshes: Mesh[]): Scene {
  return new Scene().add(...meshes)
}
