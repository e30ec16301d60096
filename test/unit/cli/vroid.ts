import type { Accessor, Document, Mesh, Primitive } from '@gltf-transform/core'
import { accessorsOf } from '../../accessors.ts'
import { meshOf, targetNamesOf } from './auto-variants.ts'

/** Blendshapes of VRoid. Each one is a sum of ARKit blendshapes with these weights. */
const SHAPES: Readonly<Record<string, Readonly<Record<string, number>>>> = {
  Fcl_ALL_Neutral: {},
  Fcl_ALL_Angry: { browDownLeft: 1, browDownRight: 1, mouthFrownLeft: 0.6, mouthFrownRight: 0.6 },
  Fcl_ALL_Joy: { eyeBlinkLeft: 1, eyeBlinkRight: 1, mouthSmileLeft: 1, mouthSmileRight: 1 },
  Fcl_BRW_Angry: { browDownLeft: 1, browDownRight: 1 },
  Fcl_BRW_Fun: { browOuterUpLeft: 0.4, browOuterUpRight: 0.4 },
  Fcl_BRW_Sorrow: { browInnerUp: 0.8 },
  Fcl_BRW_Surprised: { browInnerUp: 1, browOuterUpLeft: 1, browOuterUpRight: 1 },
  Fcl_EYE_Natural: {},
  Fcl_EYE_Close: { eyeBlinkLeft: 1, eyeBlinkRight: 1 },
  Fcl_EYE_Close_R: { eyeBlinkRight: 1 },
  Fcl_EYE_Close_L: { eyeBlinkLeft: 1 },
  Fcl_EYE_Joy: { eyeBlinkLeft: 0.8, eyeBlinkRight: 0.8, cheekSquintLeft: 1, cheekSquintRight: 1 },
  Fcl_EYE_Joy_R: { eyeBlinkRight: 0.8, cheekSquintRight: 1 },
  Fcl_EYE_Joy_L: { eyeBlinkLeft: 0.8, cheekSquintLeft: 1 },
  Fcl_EYE_Surprised: { eyeWideLeft: 1, eyeWideRight: 1 },
  Fcl_MTH_Up: { mouthShrugUpper: 0.5, mouthShrugLower: 0.5 },
  Fcl_MTH_Down: { mouthFrownLeft: 0.4, mouthFrownRight: 0.4 },
  Fcl_MTH_Angry: { mouthFrownLeft: 0.6, mouthFrownRight: 0.6, jawOpen: 0.2 },
  Fcl_MTH_Small: { mouthPucker: 1 },
  Fcl_MTH_Large: { mouthStretchLeft: 0.8, mouthStretchRight: 0.8 },
  Fcl_MTH_Fun: { mouthSmileLeft: 1, mouthSmileRight: 1 },
  Fcl_MTH_Joy: { mouthSmileLeft: 0.8, mouthSmileRight: 0.8, jawOpen: 0.6 },
  Fcl_MTH_Sorrow: { mouthFrownLeft: 1, mouthFrownRight: 1 },
  Fcl_MTH_A: { jawOpen: 0.8 },
  Fcl_MTH_I: { mouthStretchLeft: 0.5, mouthStretchRight: 0.5 },
  Fcl_MTH_U: { mouthPucker: 0.7 },
  Fcl_MTH_O: { mouthFunnel: 0.9 },
}

/** Blendshapes of an avatar that only has emotions, vowels and blinks. */
export const EMOTIONS: typeof SHAPES = {
  Fcl_ALL_Neutral: {},
  Fcl_ALL_Angry: { browDownLeft: 1, browDownRight: 1, mouthFrownLeft: 0.6, mouthFrownRight: 0.6 },
  Fcl_ALL_Fun: { mouthSmileLeft: 0.6, mouthSmileRight: 0.6, browOuterUpLeft: 0.2, browOuterUpRight: 0.2 },
  Fcl_ALL_Joy: {
    ...{ eyeBlinkLeft: 0.8, eyeBlinkRight: 0.8, cheekSquintLeft: 1, cheekSquintRight: 1 },
    ...{ mouthSmileLeft: 1, mouthSmileRight: 1 },
  },
  Fcl_ALL_Sorrow: { browInnerUp: 0.7, mouthFrownLeft: 1, mouthFrownRight: 1 },
  Fcl_ALL_Surprised: { browInnerUp: 1, browOuterUpLeft: 1, browOuterUpRight: 1, jawOpen: 0.4 },
  Fcl_EYE_Close_L: { eyeBlinkLeft: 1 },
  Fcl_EYE_Close_R: { eyeBlinkRight: 1 },
  Fcl_MTH_A: { jawOpen: 0.8 },
  Fcl_MTH_I: { mouthStretchLeft: 0.5, mouthStretchRight: 0.5 },
  Fcl_MTH_U: { mouthPucker: 0.7 },
  Fcl_MTH_O: { mouthFunnel: 0.9 },
}

/** Blendshapes of an avatar whose brows are a mesh in front of the skin, so that brow shapes do not move the skin. */
export const FLOATING_BROWS: typeof SHAPES = Object.fromEntries(
  Object.entries(SHAPES).map(([name, sum]) => [name, name.startsWith('Fcl_BRW_') ? {} : sum]),
)

/** Meshes of the shipped face that become primitives of the mesh `Face`, with the material names of VRoid Studio. */
const PARTS = [
  ['mouth', 'N00_000_00_FaceMouth_00_FACE (Instance)'],
  ['eye-left', 'N00_000_00_EyeIris_00_EYE (Instance)'],
  ['skin', 'N00_000_00_Face_00_SKIN (Instance)'],
  ['brows', 'N00_000_00_FaceBrow_00_FACE (Instance)'],
  ['lashes', 'N00_000_00_FaceEyelash_00_FACE (Instance)'],
] as const

/** Name of the skin's material in a file made by `toVRoid`. */
export const VROID_SKIN = PARTS[2][1]

/**
 * Converts the shipped face to a face that looks like an export of VRoid Studio in VRM 0. One mesh has several primitives, which share all vertices
 * and have different materials. The face has only VRoid's blendshapes, and looks along -Z.
 *
 * @param shapes new blendshapes by name. Each one is a sum of ARKit blendshapes with these weights.
 */
export function toVRoid(document: Document, shapes = SHAPES): void {
  const parts = PARTS.map(([name, material]) => ({ mesh: meshOf(document, name), material }))
  const counts = parts.map(({ mesh }) => mesh.listPrimitives()[0]!.getAttribute('POSITION')!.getCount())
  const total = counts.reduce((a, b) => a + b, 0)
  const accessor = accessorsOf(document)
  const joined = (semantic: string, size: number, turned: boolean) => {
    const out = new Float32Array(size * total)
    parts.reduce((first, { mesh }, i) => {
      const source = mesh.listPrimitives()[0]!.getAttribute(semantic)
      if (source) copy(source, out, size, first, 1, turned)
      return first + counts[i]!
    }, 0)
    return out
  }
  const attributes = {
    POSITION: accessor('VEC3', joined('POSITION', 3, true)),
    NORMAL: accessor('VEC3', joined('NORMAL', 3, true)),
    TEXCOORD_0: accessor('VEC2', joined('TEXCOORD_0', 2, false)),
  }
  const targets = Object.entries(shapes).map(([name, sum]) => {
    const out = new Float32Array(3 * total)
    parts.reduce((first, { mesh }, i) => {
      const names = targetNamesOf(mesh)
      for (const [shape, weight] of Object.entries(sum)) {
        const target = mesh.listPrimitives()[0]!.listTargets()[names.indexOf(shape)]
        const moved = target?.getAttribute('POSITION')
        if (moved) copy(moved, out, 3, first, weight, true)
      }
      return first + counts[i]!
    }, 0)
    return document.createPrimitiveTarget(name).setAttribute('POSITION', accessor('VEC3', out))
  })
  const face = document.createMesh('Face').setExtras({ targetNames: Object.keys(shapes) })
  parts.reduce((first, { mesh, material }, i) => {
    const own = mesh.listPrimitives()[0]!
    const corners = Uint32Array.from(own.getIndices()!.getArray() as Uint32Array, (vertex) => first + vertex)
    const primitive: Primitive = document.createPrimitive().setIndices(accessor('SCALAR', corners))
    for (const [semantic, values] of Object.entries(attributes)) primitive.setAttribute(semantic, values)
    for (const target of targets) primitive.addTarget(target)
    face.addPrimitive(primitive.setMaterial(document.createMaterial(material)))
    return first + counts[i]!
  }, 0)
  for (const mesh of document.getRoot().listMeshes()) if (mesh !== face) drop(mesh)
  document.getRoot().listScenes()[0]!.addChild(document.createNode('Face').setMesh(face))
}

/** Adds an accessor times `weight` to `out`, from vertex `first` on. `turned` rotates it by 180 degrees about the vertical axis. */
function copy(
  source: Accessor,
  out: Float32Array,
  size: number,
  first: number,
  weight: number,
  turned: boolean,
): void {
  const element: number[] = []
  for (let i = 0; i < source.getCount(); i++) {
    source.getElement(i, element)
    for (let k = 0; k < size; k++) {
      const sign = turned && k !== 1 ? -1 : 1
      out[size * (first + i) + k]! += weight * sign * element[k]!
    }
  }
}

function drop(mesh: Mesh): void {
  for (const parent of mesh.listParents()) if (parent.propertyType === 'Node') parent.dispose()
  mesh.dispose()
}
