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

/**
 * What full weight takes from the light of the skin, linear RGB: orange is left, and the shape is still seen. WebGL blends colours that are
 * encoded already, WebGPU before that.
 */
const TAKEN = { encoded: [0, 0.17, 0.65], linear: [0, 0.42, 0.9] } as const

/** A mesh more that moves as another one does; hidden at first. */
export function movingCopy(mesh: Mesh, material: Material): Mesh {
  const copy = mesh.clone(false)
  copy.material = material
  copy.morphTargetInfluences = mesh.morphTargetInfluences
  copy.visible = false
  mesh.parent?.add(copy)
  return copy
}

/** Draws areas in orange over the meshes of a skin, as they move. */
export class AreaOverlay {
  readonly #copies: readonly Mesh[]

  /** @param influence shows areas as gray, see `createInfluenceMaterial`; it becomes the overlay's. */
  constructor(meshes: readonly Mesh[], influence: Material) {
    const material = asFilter(influence as Coloured)
    this.#copies = meshes.map((mesh) => movingCopy(mesh, material))
  }

  set visible(visible: boolean) {
    for (const copy of this.#copies) copy.visible = visible
  }

  /** The material is disposed of by its owner. */
  dispose(): void {
    for (const copy of this.#copies) copy.removeFromParent()
  }
}

type Coloured = Material & { color: Color }

/** Makes a material take light from what is drawn below it, by its colour. */
function asFilter(material: Coloured): Material {
  material.color.fromArray(TAKEN['colorNode' in material ? 'linear' : 'encoded'])
  material.transparent = true
  material.depthWrite = false
  material.blending = CustomBlending
  material.blendEquation = AddEquation
  material.blendSrc = ZeroFactor
  material.blendDst = OneMinusSrcColorFactor
  material.blendSrcAlpha = ZeroFactor
  material.blendDstAlpha = OneFactor
  // The same surface by another program: depths may differ in their last bit.
  material.polygonOffset = true
  material.polygonOffsetFactor = material.polygonOffsetUnits = -1
  return material
}
