/**
 * Text edits of shaders, which may include three.js's chunks or contain their text. If a shader lacks an expected text, the message of the
 * thrown error is this text.
 */
import { ShaderChunk } from 'three'

/**
 * Replaces the first occurrence of a text in a shader.
 *
 * @throws Error if the shader does not contain the text.
 */
export function replace(shader: string, text: string, replacement: string): string {
  if (!shader.includes(text)) throw new Error(text)
  return shader.replace(text, () => replacement)
}

/**
 * Replaces an `#include` by its edited text. Ignores includes in comments, like three.js.
 *
 * @returns the shader, unchanged if it does not include the chunk.
 */
export function replaceChunk(
  shader: string,
  name: keyof typeof ShaderChunk,
  edit: (chunk: string) => string = (chunk) => chunk,
): string {
  return shader.replace(includeOf(name), () => edit(ShaderChunk[name]))
}

/** Matches the `#include` of a chunk, by name or pattern. */
export function includeOf(name: string): RegExp {
  return new RegExp(`^[ \\t]*#include +<${name}>`, 'm')
}

/** Start of a shader's main function. */
export const MAIN = 'void main() {'
