import {
  DataTexture,
  LinearFilter,
  type Material,
  type Mesh,
  MeshMatcapMaterial,
  type MeshStandardMaterial,
  SRGBColorSpace,
} from 'three'

/** Materials of meshes lit from the camera alone, made when they are first asked for: an area that is pointed at compiles nothing anew. */
export class Headlit {
  readonly #materials = new Map<Mesh, Material>()
  #matcap: DataTexture | null = null

  /** @param own the mesh's material, whose colours it has. */
  of(mesh: Mesh, own: Material): Material {
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

/** A material in its own colours, lit from the camera alone: quick to draw while one paints, and every place is bright. */
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

/** How bright a surface is by the normal's place on the picture of a sphere: 1 where it faces the camera. */
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
