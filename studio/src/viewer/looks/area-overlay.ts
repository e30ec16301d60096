import { movingCopy } from 'furrow/internal/three'
import {
  AddEquation,
  type Color,
  CustomBlending,
  type Material,
  type Mesh,
  OneFactor,
  OneMinusSrcColorFactor,
  ZeroFactor,
} from 'three'

/** Fractions of red, green and blue light that the overlay absorbs at weight 1. WebGL blends encoded colours, WebGPU blends linear colours. */
const ABSORPTION = { encoded: [0, 0.17, 0.65], linear: [0, 0.42, 0.9] } as const

/** Draws areas in orange over the meshes of a skin. */
export class AreaOverlay {
  readonly #copies: readonly Mesh[]

  /** @param influence material that shows areas in gray, see `createInfluenceMaterial`. This class modifies it. */
  constructor(meshes: readonly Mesh[], influence: Material) {
    const material = asFilter(influence as Coloured)
    this.#copies = meshes.map((mesh) => movingCopy(mesh, material))
  }

  set visible(visible: boolean) {
    for (const copy of this.#copies) copy.visible = visible
  }

  /** Does not dispose of the material. */
  dispose(): void {
    for (const copy of this.#copies) copy.removeFromParent()
  }
}

type Coloured = Material & { color: Color }

/** Turns a material into a filter that multiplies the colours below it. */
function asFilter(material: Coloured): Material {
  material.color.fromArray(ABSORPTION['colorNode' in material ? 'linear' : 'encoded'])
  material.transparent = true
  material.depthWrite = false
  material.blending = CustomBlending
  material.blendEquation = AddEquation
  material.blendSrc = ZeroFactor
  material.blendDst = OneMinusSrcColorFactor
  material.blendSrcAlpha = ZeroFactor
  material.blendDstAlpha = OneFactor
  // The shader programs of filter and skin can compute slightly different depths. The offset prevents z-fighting.
  material.polygonOffset = true
  material.polygonOffsetFactor = material.polygonOffsetUnits = -1
  return material
}
