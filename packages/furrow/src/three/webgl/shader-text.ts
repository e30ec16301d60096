/** Edits to the text of three.js's own shaders. */
import { REVISION } from 'three'
import { FurrowError } from '../../core/error.ts'
import { TESTED_THREE } from '../three-version.ts'

/**
 * Replaces the first occurrence of a text in a shader.
 *
 * @throws FurrowError when the shader does not contain it.
 */
export function replace(shader: string, text: string, replacement: string): string {
  if (!shader.includes(text)) throw unpatchable(text)
  return shader.replace(text, () => replacement)
}

/** What is thrown for a shader without a text that the patch needs. */
export function unpatchable(missing: string): FurrowError {
  return new FurrowError({
    code: 'unsupported',
    who: 'Wrinkles',
    what: `material whose shader cannot be patched in three.js r${REVISION}, it lacks`,
    value: missing,
    limit: `the built-in lit materials of three.js r${TESTED_THREE.oldest} to r${TESTED_THREE.newest}`,
    remedy: 'use one of them, or set the mode to "off"',
  })
}

/** Where a material's fragment shader starts. */
export const MAIN = 'void main() {'

/** Where a material reads its normal map. */
export const NORMAL_MAPS = '#include <normal_fragment_maps>'

/** Where a material reads its base colour map. */
export const BASE_COLOR_MAP = '#include <map_fragment>'
