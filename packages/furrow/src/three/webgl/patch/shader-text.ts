/**
 * Edits to the text of materials' shaders, which may include three.js's chunks or hold such text themselves. Where a shader lacks a text, an
 * error is thrown that has this text for its message.
 */
import { ShaderChunk } from 'three'

/**
 * Replaces the first occurrence of a text in a shader.
 *
 * @throws Error when the shader does not contain it.
 */
export function replace(shader: string, text: string, replacement: string): string {
  if (!shader.includes(text)) throw new Error(text)
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

/** Where a material's fragment shader starts. */
export const MAIN = 'void main() {'
