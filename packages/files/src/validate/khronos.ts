import { WRINKLE_MAPS } from 'furrow/internal'
import { runValidator } from '#validator'
import { normalised, unescaped } from '../base/references.ts'
import type { Glb } from '../gltf/glb.ts'
import { errorFinding, type Finding, warningFinding } from './finding.ts'

/** The Khronos validator stops after this number of issues. */
const MAX_ISSUES = 1000

/** Time limit of the Khronos validator, about ten times its usual duration. */
const SECONDS = 10
const SECONDS_PER_MB = 1

/** Code of the finding if the Khronos validator failed or took too long. */
export const VALIDATOR_FAILED = 'VALIDATOR'

/** Codes of the Khronos validator for images in a format that it does not know. */
const UNKNOWN_FORMAT = ['VALUE_NOT_IN_LIST', 'IMAGE_UNRECOGNIZED_FORMAT']

/**
 * Runs the Khronos validator. Drops its findings about FURROW_wrinkle_maps and KTX 2 images, which it does not know.
 * `checkWrinkles` checks both.
 *
 * @param glb result of `openGlb`. The validator reads `glb.bytes`, the original file.
 */
export async function runKhronosValidator({ json, bytes, references }: Glb): Promise<Finding[]> {
  const seconds = Math.ceil(SECONDS + (SECONDS_PER_MB * bytes.length) / 1e6)
  const task = { bytes: Uint8Array.from(bytes), files: filesOf(references), maxIssues: MAX_ISSUES }
  const { issues, failure } = await runValidator(task, seconds)
  if (!issues) return [errorFinding(VALIDATOR_FAILED, `the Khronos validator failed: ${failure}`)]
  return issues
    .filter(({ severity, message }) => severity < 2 && !message.includes(WRINKLE_MAPS))
    .filter(({ code, pointer = '' }) => {
      const image = json.images?.[Number(/^\/images\/(\d+)/.exec(pointer)?.[1])]
      return !(UNKNOWN_FORMAT.includes(code) && image?.mimeType === 'image/ktx2')
    })
    .map(({ code, message, severity, pointer }) => {
      return (severity === 0 ? errorFinding : warningFinding)(code, message, pointer)
    })
}

/** Returns the referenced files by normalised path. The validator requests files by normalised URI. */
function filesOf(references: Glb['references']): Map<string, Uint8Array> {
  const files = [...references].filter(([, { path }]) => path !== undefined)
  return new Map(files.map(([uri, { bytes }]) => [normalised(unescaped(uri).replaceAll('\\', '/')), bytes]))
}
