import {
  type Accessor,
  Logger,
  type Mesh,
  NodeIO,
  type Primitive,
  type PrimitiveTarget,
  VertexLayout,
} from '@gltf-transform/core'
import { prune } from '@gltf-transform/functions'

/** Blendshapes of the shipped face that move both sides. Many other faces have one per side instead. */
const BOTH_SIDES = ['browInnerUp', 'cheekPuff']

/** Half the width of the band where one side of a split blendshape fades into the other, metres. */
const FADE = 0.01

/** Makes a `BareFace` from a shipped face. Returns a `.glb`. */
export async function makeBare(path: string): Promise<Uint8Array> {
  // Without a registered extension, glTF-Transform drops the wrinkles.
  const io = new NodeIO()
    .setLogger(new Logger(Logger.Verbosity.SILENT))
    .setVertexLayout(VertexLayout.SEPARATE)
  const document = await io.read(path)
  const root = document.getRoot()
  for (const texture of root.listTextures()) texture.dispose()
  for (const named of [...root.listMeshes(), ...root.listNodes()]) {
    if (named.getName() === 'skin') named.setName('face')
  }
  for (const mesh of root.listMeshes()) {
    for (const primitive of mesh.listPrimitives()) {
      primitive.setAttribute('TANGENT', null)
      for (const target of primitive.listTargets()) target.setAttribute('NORMAL', null)
    }
    renameTargets(mesh)
  }
  await document.transform(prune({ keepLeaves: true, keepAttributes: true, keepExtras: true }))
  return io.writeBinary(document)
}

/** Renames `mouthSmileLeft` to `mouthSmile_L`, and splits `browInnerUp` into `browInnerUp_L` and `browInnerUp_R`. */
function renameTargets(mesh: Mesh): void {
  const old = (mesh.getExtras().targetNames ?? []) as string[]
  if (old.length === 0) return
  const names = old.flatMap((name) =>
    BOTH_SIDES.includes(name)
      ? [`${name}_L`, `${name}_R`]
      : [name.replace(/Left$/, '_L').replace(/Right$/, '_R')],
  )
  for (const primitive of mesh.listPrimitives()) {
    const targets = old.flatMap((name, i) => {
      const target = primitive.listTargets()[i]
      return BOTH_SIDES.includes(name)
        ? [oneSide(primitive, target, 1), oneSide(primitive, target, -1)]
        : target
    })
    for (const target of primitive.listTargets()) primitive.removeTarget(target)
    for (const [i, target] of targets.entries()) primitive.addTarget(target.setName(names[i]))
  }
  mesh.setWeights(names.map(() => 0)).setExtras({ targetNames: names })
}

/** Returns one side of a target's displacements. The person's left is at positive x. */
function oneSide(primitive: Primitive, target: PrimitiveTarget, sign: 1 | -1): PrimitiveTarget {
  const positions = primitive.getAttribute('POSITION')!
  const displacements = target.getAttribute('POSITION')!
  const half: Accessor = displacements.clone()
  for (let i = 0; i < half.getCount(); i++) {
    const x = positions.getElement(i, [0, 0, 0])[0]
    const weight = Math.min(1, Math.max(0, 0.5 + (0.5 * sign * x) / FADE))
    half.setElement(
      i,
      displacements.getElement(i, [0, 0, 0]).map((value) => weight * value),
    )
  }
  return target.clone().setAttribute('POSITION', half)
}
