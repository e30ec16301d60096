import type { Glb } from '../../../packages/cli/src/gltf/glb-file.ts'
import type { Finding } from '../../../packages/cli/src/validate/finding.ts'
import { runKhronosValidator } from '../../../packages/cli/src/validate/khronos.ts'
import { checkWrinkles } from '../../../packages/cli/src/wrinkles/rules.ts'
import { type FaceFiles, openFace } from './files.ts'

/** Checks a face as `furrow validate` does. Throws FurrowError when it is not a face that can be read. */
export async function validateFace(face: FaceFiles): Promise<Finding[]> {
  return findingsOf(await openFace(face, 'Studio'))
}

/** What is wrong with the wrinkles of a file, and with the rest of it. */
export async function findingsOf(glb: Glb): Promise<Finding[]> {
  return [...(await checkWrinkles(glb)), ...(await runKhronosValidator(glb))]
}
