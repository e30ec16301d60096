import type { Material, MeshStandardMaterial } from 'three'

/** A material with a normal map: standard, physical, Phong, Lambert, Toon or MatCap, or one of another library. */
export type WrinkleMaterial = Material &
  Pick<MeshStandardMaterial, 'normalMap' | 'normalMapType' | 'normalScale'> & {
    /** Of a `ShaderMaterial`: its own GLSL. */
    fragmentShader?: string
    isRawShaderMaterial?: boolean
  }

/** Whether a material lights in steps: three.js's by a gradient map, MToon by a factor. */
export function isToon(material: WrinkleMaterial): boolean {
  return 'gradientMap' in material || 'shadingToonyFactor' in material
}

/** Copies a material as its class does. Not by its own `clone`: the loader replaces that, so that copies wrinkle too. */
export function cloneByClass(material: WrinkleMaterial): WrinkleMaterial {
  return Object.getPrototypeOf(material).clone.call(material)
}
