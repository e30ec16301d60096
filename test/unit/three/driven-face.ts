import type { WrinkleDriver } from 'furrow'
import { addDrivers, Wrinkles } from 'furrow/three'
import {
  Bone,
  Float32BufferAttribute,
  type Mesh,
  MeshStandardMaterial,
  PlaneGeometry,
  Skeleton,
  SkinnedMesh,
} from 'three'
import { layer, randomNormals } from '../../cases.ts'
import { seeded } from '../../random.ts'
import { frameOf } from './stub-renderer.ts'

const AREAS = ['brow', 'nose', 'neck']

/** Creates a square with two joints and two blendshapes. The first blendshape halves its width. */
export function drivenFace(drivers: WrinkleDriver[], targets = ['browDown_L', 'jawOpen']) {
  const geometry = new PlaneGeometry(1, 1, 4, 4)
  const { count } = geometry.getAttribute('position')
  geometry.morphTargetsRelative = true
  geometry.morphAttributes.position = targets.map((name, i) => {
    const offsets = new Float32Array(3 * count)
    for (let k = 0; k < count; k++) if (i === 0) offsets[3 * k] = -geometry.attributes.position.getX(k) / 2
    return Object.assign(new Float32BufferAttribute(offsets, 3), { name })
  })
  if (targets.length === 0) geometry.morphAttributes = {}
  geometry.setAttribute('skinIndex', new Float32BufferAttribute(new Float32Array(4 * count), 4))
  const skinWeights = Float32Array.from({ length: 4 * count }, (_, i) => (i % 4 === 0 ? 1 : 0))
  geometry.setAttribute('skinWeight', new Float32BufferAttribute(skinWeights, 4))
  const mesh = new SkinnedMesh(geometry, new MeshStandardMaterial())
  const [chest, head] = ['chest', 'head'].map((name) => Object.assign(new Bone(), { name }))
  head.position.y = 1
  mesh.add(chest.add(head))
  mesh.bind(new Skeleton([chest, head]))
  const weights = { width: 2, height: 2, data: new Uint8Array(4).fill(255) }
  const wrinkles = new Wrinkles(mesh, {
    layers: [layer('skin', 'detail', randomNormals(seeded(1), 2))],
    areas: AREAS.map((name) => ({ name, weights, ...(name === 'nose' && { activation: 0.2 }) })),
  })
  addDrivers(wrinkles, drivers)
  const draw = frameOf(mesh as Mesh)
  const activations = () => {
    draw()
    return AREAS.map((name) =>
      wrinkles.hasArea(name) ? Math.round(1e4 * wrinkles.getActivation(name)) / 1e4 : null,
    )
  }
  return { mesh, head, wrinkles, draw, activations }
}
