import type { Material, MeshStandardMaterial } from 'three'

/** A material with normals to wrinkle: standard, physical, Phong, Lambert, Toon or MatCap. */
export type WrinkleMaterial = Material &
  Pick<MeshStandardMaterial, 'normalMap' | 'normalMapType' | 'normalScale'>
