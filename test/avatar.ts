import type { Accessor, Document, Mesh, Node, Primitive } from '@gltf-transform/core'
import { accessorsOf } from './accessors.ts'

/** Height in metres by which `addBody` raises the shipped face, so that the body stands on the floor. */
export const HEAD_HEIGHT = 0.88

/** Boxes that form a body in a T pose, metres. `joint` moves the box. */
const BODY: readonly { joint: string; min: readonly number[]; max: readonly number[] }[] = [
  { joint: 'Spine', min: [-0.19, 0.92, -0.13], max: [0.19, 1.46, 0.08] },
  { joint: 'Arm.L', min: [0.19, 1.36, -0.1], max: [0.82, 1.44, 0] },
  { joint: 'Arm.R', min: [-0.82, 1.36, -0.1], max: [-0.19, 1.44, 0] },
  { joint: 'Hips', min: [0.02, 0, -0.12], max: [0.17, 0.92, 0.05] },
  { joint: 'Hips', min: [-0.17, 0, -0.12], max: [-0.02, 0.92, 0.05] },
]

/** Joints with their positions in the armature, centimetres. `of` names the parent joint; a joint without `of` is a child of the armature node. */
const JOINTS: readonly { name: string; of?: string; at: [number, number, number] }[] = [
  { name: 'Hips', at: [0, 92, -3] },
  { name: 'Spine', of: 'Hips', at: [0, 105, -3] },
  { name: 'Arm.L', of: 'Spine', at: [19, 140, -5] },
  { name: 'Arm.R', of: 'Spine', at: [-19, 140, -5] },
  { name: 'Head', of: 'Spine', at: [0, 155, -3] },
]

/**
 * Adds a body with joints to the shipped face. The joints move all meshes. Joint positions are in centimetres, below
 * a node scaled by 0.01. The body becomes part of the mesh `skin` and has the material of the skin.
 *
 * @param bodyShapes names of extra blendshapes that widen the whole body.
 */
export function addBody(document: Document, bodyShapes: readonly string[] = []): void {
  const scene = document.getRoot().listScenes()[0]!
  const nodes = document
    .getRoot()
    .listNodes()
    .filter((node) => node.getMesh())
  const armature = document.createNode('Armature').setScale([0.01, 0.01, 0.01])
  scene.addChild(armature)
  const skin = makeSkin(document, armature)
  for (const node of nodes) {
    const mesh = node.getMesh()!
    const [primitive] = mesh.listPrimitives()
    raise(primitive!)
    if (mesh.getName() === 'skin') joinBody(document, mesh, bodyShapes)
    const count = primitive!.getAttribute('POSITION')!.getCount()
    const head = JOINTS.findIndex(({ name }) => name === 'Head')
    const bodyJoints = BODY.flatMap(({ joint }) => Array<number>(8).fill(indexOf(joint)))
    const isSkin = mesh.getName() === 'skin'
    const joints = Array.from({ length: count }, (_, i) =>
      isSkin && i >= count - bodyJoints.length ? bodyJoints[i - (count - bodyJoints.length)]! : head,
    )
    bindToJoints(document, primitive!, joints)
    armature.addChild(node.setSkin(skin))
  }
}

/** Rotates the scene about the vertical axis. */
export function turnScene(document: Document, degrees: number): void {
  const scene = document.getRoot().listScenes()[0]!
  const half = (degrees * Math.PI) / 360
  const turned = document.createNode('turned').setRotation([0, Math.sin(half), 0, Math.cos(half)])
  for (const child of scene.listChildren()) turned.addChild(child)
  scene.addChild(turned)
}

function indexOf(joint: string): number {
  return JOINTS.findIndex(({ name }) => name === joint)
}

/** Creates the joints. Their inverse bind matrices convert metres to centimetres. */
function makeSkin(document: Document, armature: Node) {
  const skin = document.createSkin()
  const byName = new Map<string, { node: Node; at: readonly number[] }>()
  const inverses: number[] = []
  for (const { name, of, at } of JOINTS) {
    const parent = of === undefined ? undefined : byName.get(of)!
    const offset = at.map((value, k) => value - (parent?.at[k] ?? 0)) as [number, number, number]
    const node = document.createNode(name).setTranslation(offset)
    ;(parent?.node ?? armature).addChild(node)
    byName.set(name, { node, at })
    skin.addJoint(node)
    inverses.push(100, 0, 0, 0, 0, 100, 0, 0, 0, 0, 100, 0, -at[0], -at[1], -at[2], 1)
  }
  return skin.setInverseBindMatrices(accessorsOf(document)('MAT4', Float32Array.from(inverses)))
}

function raise(primitive: Primitive): void {
  const positions = primitive.getAttribute('POSITION')!
  const element: number[] = []
  for (let i = 0; i < positions.getCount(); i++) {
    const [x, y, z] = positions.getElement(i, element)
    positions.setElement(i, [x!, y! + HEAD_HEIGHT, z!])
  }
}

/** Appends the body boxes to the skin's vertices and triangles. */
function joinBody(document: Document, mesh: Mesh, shapes: readonly string[]): void {
  const accessor = accessorsOf(document)
  const [primitive] = mesh.listPrimitives()
  const first = primitive!.getAttribute('POSITION')!.getCount()
  const corners = BODY.flatMap(({ min, max }) =>
    Array.from({ length: 8 }, (_, i) => [0, 1, 2].map((k) => ((i >> k) & 1 ? max[k]! : min[k]!))),
  )
  const faces = [
    0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4, 2, 6, 3, 3, 6, 7, 0, 4, 2, 2, 4, 6, 1, 3, 5, 3, 7,
    5,
  ]
  const triangles = BODY.flatMap((_, box) => faces.map((corner) => first + 8 * box + corner))
  const extended = (source: Accessor, added: readonly number[]) => {
    const out = new Float32Array(source.getElementSize() * (first + corners.length))
    const element: number[] = []
    for (let i = 0; i < first; i++) out.set(source.getElement(i, element), source.getElementSize() * i)
    out.set(added, source.getElementSize() * first)
    return accessor(source.getType() as 'VEC3', out)
  }
  const zeros = (source: Accessor) => Array<number>(source.getElementSize() * corners.length).fill(0)
  for (const semantic of primitive!.listSemantics()) {
    const source = primitive!.getAttribute(semantic)!
    primitive!.setAttribute(
      semantic,
      extended(source, semantic === 'POSITION' ? corners.flat() : zeros(source)),
    )
  }
  for (const target of primitive!.listTargets()) {
    for (const semantic of target.listSemantics()) {
      const source = target.getAttribute(semantic)!
      target.setAttribute(semantic, extended(source, zeros(source)))
    }
  }
  const all = primitive!.getAttribute('POSITION')!
  for (const name of shapes) {
    const wider = new Float32Array(3 * all.getCount())
    for (let i = 0; i < all.getCount(); i++) wider[3 * i] = 0.1 * all.getElement(i, [])[0]!
    primitive!.addTarget(
      document.createPrimitiveTarget(name).setAttribute('POSITION', accessor('VEC3', wider)),
    )
  }
  const names = mesh.getExtras().targetNames as string[]
  mesh.setExtras({ ...mesh.getExtras(), targetNames: [...names, ...shapes] }).setWeights([])
  const old = primitive!.getIndices()!.getArray() as ArrayLike<number>
  primitive!.setIndices(accessor('SCALAR', Uint32Array.from([...Array.from(old), ...triangles])))
}

function bindToJoints(document: Document, primitive: Primitive, joints: readonly number[]): void {
  const accessor = accessorsOf(document)
  const four = (value: (i: number) => number) =>
    Array.from({ length: 4 * joints.length }, (_, i) => (i % 4 === 0 ? value(i / 4) : 0))
  primitive.setAttribute('JOINTS_0', accessor('VEC4', Uint8Array.from(four((i) => joints[i]!))))
  primitive.setAttribute('WEIGHTS_0', accessor('VEC4', Float32Array.from(four(() => 1))))
}
