import type { Material, MeshStandardMaterial } from 'three'

/** A material with a normal map: standard, physical, Phong, Lambert, Toon, MatCap, or a third-party material. */
export type WrinkleMaterial = Material &
  Pick<MeshStandardMaterial, 'normalMap' | 'normalMapType' | 'normalScale'> & {
    /** GLSL of a `ShaderMaterial`. */
    fragmentShader?: string
    isRawShaderMaterial?: boolean
  }

/** Whether a material has toon shading: three.js's `MeshToonMaterial`, or MToon. */
export function isToon(material: WrinkleMaterial): boolean {
  return 'gradientMap' in material || 'shadingToonyFactor' in material
}

/** Clones a material, but not its wrinkles. Calls `clone` of the class, because the loader's `material.clone` adds wrinkles to copies. */
export function cloneByClass(material: WrinkleMaterial): WrinkleMaterial {
  return Object.getPrototypeOf(material).clone.call(material)
}
