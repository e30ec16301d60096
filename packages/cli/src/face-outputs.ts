import type { Glb, OutputFile } from 'furrow-files'
import { filesOfFace, wasRead } from 'furrow-files/node'
import { checkOutputs, checkReplaced, type ReplaceRules } from './outputs.ts'

/**
 * Returns the files to write for a face, see `filesOfFace`. With `force`, only `path` may overwrite an input. If a
 * buffer or image of a `.gltf` would overwrite an input, it gets another name.
 *
 * @throws FurrowError if a file would overwrite an input, or cannot be written.
 */
export async function faceFiles(
  glb: Glb,
  path: string,
  who: string,
  rules: ReplaceRules = {},
): Promise<OutputFile[]> {
  const files = filesOfFace(glb, path, rules.force ? (beside) => !wasRead(beside) : undefined)
  const paths = files.map((file) => file.path)
  if (paths.length > 1) await checkOutputs(paths, who, { extensions: [''] })
  checkReplaced(paths, who, rules)
  return files
}
