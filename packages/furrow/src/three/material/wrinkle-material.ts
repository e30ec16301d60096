import type { Material, MeshStandardMaterial } from 'three'

/** A material with a normal map: standard, physical, Phong, Lambert, Toon, MatCap, or a third-party material. */
export type WrinkleMaterial = Material &
  Pick<MeshStandardMaterial, 'normalMap' | 'normalMapType' | 'normalScale'> & {
    /** GLSL of a `ShaderMaterial`. */
    fragmentShader?: string
    isRawShaderMaterial?: boolean
  }

/** Whether a material has toon shading, by three.js's gradient map or MToon's factor. */
export function isToon(material: WrinkleMaterial): boolean {
  return 'gradientMap' in material || 'shadingToonyFactor' in material
}

/** Clones a material with its class's `clone`: the loader overrides the instance's own, so that copies wrinkle too. */
export function cloneByClass(material: WrinkleMaterial): WrinkleMaterial {
  return Object.getPrototypeOf(material).clone.call(material)
}
