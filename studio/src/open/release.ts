import type { Material, Mesh, Object3D, ShaderMaterial, Texture } from 'three'

export function texturesOf(root: Object3D): Set<Texture> {
  const textures = new Set<Texture>()
  for (const material of materialsOf(root)) {
    const uniforms = Object.values((material as ShaderMaterial).uniforms ?? {}).map(({ value }) => value)
    for (const value of [...Object.values(material), ...uniforms]) {
      if ((value as Texture | null)?.isTexture) textures.add(value)
    }
  }
  return textures
}

/** Frees the GPU resources of an object. A renderer that draws the object again uploads them again. */
export function releaseFromGPU(root: Object3D): void {
  for (const texture of texturesOf(root)) texture.dispose()
  for (const material of materialsOf(root)) material.dispose()
  root.traverse((object) => {
    if ((object as Mesh).isMesh) (object as Mesh).geometry.dispose()
  })
}

function materialsOf(root: Object3D): Set<Material> {
  const materials = new Set<Material>()
  root.traverse((object) => {
    if (!(object as Mesh).isMesh) return
    for (const material of [(object as Mesh).material].flat()) materials.add(material)
  })
  return materials
}
