import type { Glb, OutputFile } from 'furrow-files'
import { filesOfFace } from 'furrow-files/node'
import { checkOutputs, type OutputRules } from './outputs.ts'

/**
 * The files of a face that is written; see `filesOfFace`.
 *
 * @throws FurrowError where one beside a `.gltf` would replace an input, see `checkOutputs`.
 */
export async function faceFiles(
  glb: Glb,
  path: string,
  who: string,
  { inputs = [], force }: OutputRules = {},
): Promise<OutputFile[]> {
  const files = filesOfFace(glb, path)
  if (files.length === 1) return files
  const paths = files.map((file) => file.path)
  const references = [...glb.references.values()].flatMap((reference) => reference.path ?? [])
  await checkOutputs(paths, who, { extensions: [''], inputs: [...inputs, ...references], force })
  return files
}
