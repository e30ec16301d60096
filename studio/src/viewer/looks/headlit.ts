import {
  DataTexture,
  LinearFilter,
  type Material,
  type Mesh,
  MeshMatcapMaterial,
  type MeshStandardMaterial,
  SRGBColorSpace,
} from 'three'

/** Makes materials that are lit from the camera. Caches one for each mesh, so that pointing at areas compiles no shaders. */
export class Headlit {
  readonly #materials = new Map<Mesh, Material>()
  #matcap: DataTexture | null = null

  /** @param own material of the mesh, whose colours are copied. */
  materialOf(mesh: Mesh, own: Material): Material {
    const known = this.#materials.get(mesh)
    if (known) return known
    this.#matcap ??= createMatcap()
    const material = headlit(own, this.#matcap)
    this.#materials.set(mesh, material)
    return material
  }

  dispose(): void {
    for (const material of this.#materials.values()) material.dispose()
    this.#matcap?.dispose()
  }
}

/** Makes a material that is lit from the camera. It is fast, and no part of the mesh is dark. */
function headlit(material: Material, matcap: DataTexture): Material {
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

/** Makes a matcap texture that is brightest where the normal points to the camera. */
function createMatcap(): DataTexture {
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
