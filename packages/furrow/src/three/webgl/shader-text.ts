/** Edits to the text of materials' shaders, which may include three.js's chunks or hold such text themselves. */
import { REVISION, ShaderChunk } from 'three'
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

/**
 * Replaces an `#include` by its text, edited. Like three.js, it leaves those in comments alone.
 *
 * @returns the shader as it was if it does not include the chunk.
 */
export function replaceChunk(
  shader: string,
  name: keyof typeof ShaderChunk,
  edit: (chunk: string) => string = (chunk) => chunk,
): string {
  return shader.replace(includeOf(name), () => edit(ShaderChunk[name]))
}

/** Finds the `#include` of a chunk, by its name or a pattern of it. */
export function includeOf(name: string): RegExp {
  return new RegExp(`^[ \\t]*#include +<${name}>`, 'm')
}

/** What is thrown for a shader without a text that the patch needs. */
export function unpatchable(missing: string): FurrowError {
  return new FurrowError({
    code: 'unsupported',
    who: 'Wrinkles',
    what: `material whose shader cannot be patched in three.js r${REVISION}, it lacks`,
    value: missing,
    limit: `the built-in lit materials of three.js r${TESTED_THREE.oldest} to r${TESTED_THREE.newest}`,
    remedy: 'use one of them, or the composed mode',
  })
}

/** Where a material's fragment shader starts. */
export const MAIN = 'void main() {'
