import {
  AddEquation,
  CustomBlending,
  DataTexture,
  LinearFilter,
  type Material,
  type Mesh,
  MeshMatcapMaterial,
  type MeshStandardMaterial,
  OneFactor,
  OneMinusSrcColorFactor,
  SRGBColorSpace,
  ZeroFactor,
} from 'three'

/**
 * What full weight takes from the light of the skin, linear RGB: orange is left, and the shape is still seen. WebGL blends colours that are
 * encoded already, WebGPU before that.
 */
const TAKEN = { encoded: [0, 0.17, 0.65], linear: [0, 0.42, 0.9] } as const

/** Draws areas in orange over the meshes of a skin, as they move. */
export class AreaOverlay {
  readonly #copies: readonly Mesh[]

  /** @param influence shows areas as gray, see `createInfluenceMaterial`; it becomes the overlay's. */
  constructor(meshes: readonly Mesh[], influence: Material) {
    const material = asFilter(influence as MeshMatcapMaterial)
    this.#copies = meshes.map((mesh) => {
      const copy = mesh.clone(false)
      copy.material = material
      copy.morphTargetInfluences = mesh.morphTargetInfluences
      copy.visible = false
      mesh.parent?.add(copy)
      return copy
    })
  }

  set visible(visible: boolean) {
    for (const copy of this.#copies) copy.visible = visible
  }

  /** The material is disposed of by its owner. */
  dispose(): void {
    for (const copy of this.#copies) copy.removeFromParent()
  }
}

/** Makes a material take light from what is drawn below it, by its colour. */
function asFilter(material: Material & Pick<MeshMatcapMaterial, 'color'>): Material {
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

/** A material in its own colours, lit from the camera alone: quick to draw while one paints, and every place is bright. */
export function headlit(material: Material, matcap: DataTexture): Material {
  const { map = null, color, side, vertexColors } = material as MeshStandardMaterial
  return new MeshMatcapMaterial({
    map,
    matcap,
    side,
    vertexColors,
    ...(color && { color: color.clone() }),
    toneMapped: false,
  })
}

const MATCAP_SIZE = 64

/** How bright a surface is by the normal's place on the picture of a sphere: 1 where it faces the camera. */
export function createMatcap(): DataTexture {
  const data = new Uint8Array(4 * MATCAP_SIZE * MATCAP_SIZE)
  for (let i = 0; i < MATCAP_SIZE * MATCAP_SIZE; i++) {
    const [x, y] = [i % MATCAP_SIZE, Math.floor(i / MATCAP_SIZE)].map(
      (k) => (2 * (k + 0.5)) / MATCAP_SIZE - 1,
    )
    const facing = Math.sqrt(Math.max(0, 1 - x * x - y * y))
    data.fill(255 * (0.4 + 0.6 * facing), 4 * i, 4 * i + 3)
    data[4 * i + 3] = 255
  }
  const texture = new DataTexture(data, MATCAP_SIZE, MATCAP_SIZE)
  texture.colorSpace = SRGBColorSpace
  texture.minFilter = texture.magFilter = LinearFilter
  texture.needsUpdate = true
  return texture
}
