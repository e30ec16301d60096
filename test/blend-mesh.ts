import { BufferAttribute, Mesh, MeshStandardMaterial, PlaneGeometry } from 'three'

/** Returns a square with blendshapes that move nothing. */
export function blendMesh(...names: string[]): Mesh<PlaneGeometry, MeshStandardMaterial> {
  const geometry = new PlaneGeometry()
  geometry.morphTargetsRelative = true
  geometry.morphAttributes.position = names.map((name) =>
    Object.assign(new BufferAttribute(new Float32Array(12), 3), { name }),
  )
  return new Mesh(geometry, new MeshStandardMaterial())
}
