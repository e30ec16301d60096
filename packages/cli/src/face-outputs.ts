import type { Glb, OutputFile } from 'furrow-files'
import { filesOfFace, wasRead } from 'furrow-files/node'
import { checkOutputs, checkReplaced, type ReplaceRules } from './outputs.ts'

/**
 * The files of a face that is written; see `filesOfFace`. With `force` the named output alone may replace an input: files
 * beside a `.gltf` get names of their own then.
 *
 * @throws FurrowError where one of them would replace an input, or cannot be written.
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
