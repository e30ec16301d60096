import { BufferAttribute, Mesh, MeshStandardMaterial, PlaneGeometry } from 'three'

/** A square with blendshapes of these names, which move nothing. */
export function blendMesh(...names: string[]): Mesh<PlaneGeometry, MeshStandardMaterial> {
  const geometry = new PlaneGeometry()
  geometry.morphTargetsRelative = true
  geometry.morphAttributes.position = names.map((name) =>
    Object.assign(new BufferAttribute(new Float32Array(12), 3), { name }),
  )
  return new Mesh(geometry, new MeshStandardMaterial())
}
