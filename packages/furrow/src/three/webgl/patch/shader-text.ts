/**
 * Functions that edit the text of shaders. A shader may `#include` chunks of three.js, or contain the text of chunks.
 */
import { ShaderChunk } from 'three'

/**
 * Replaces the first occurrence of a text in a shader.
 *
 * @throws Error if the shader does not contain the text. The error's message is the text.
 */
export function replace(shader: string, text: string, replacement: string): string {
  if (!shader.includes(text)) throw new Error(text)
  return shader.replace(text, () => replacement)
}

/**
 * Replaces the `#include` of a chunk by the edited text of the chunk. Ignores an `#include` in a comment, like three.js.
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

/** Returns a regular expression for the `#include` of a chunk. `name` may be a pattern. */
export function includeOf(name: string): RegExp {
  return new RegExp(`^[ \\t]*#include +<${name}>`, 'm')
}

/** Start of a shader's main function. */
export const MAIN = 'void main() {'
