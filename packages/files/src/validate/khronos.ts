import { WRINKLE_MAPS } from 'furrow/internal'
import { runValidator } from '#validator'
import { normalised, unescaped } from '../base/references.ts'
import type { Glb } from '../gltf/glb.ts'
import { errorFinding, type Finding, warningFinding } from './finding.ts'

/** Limit of the Khronos validator. */
const MAX_ISSUES = 1000

/** Time limit of the validator: about ten times its usual duration. */
const SECONDS = 10
const SECONDS_PER_MB = 1

/** Code of the finding that the Khronos validator did not finish. */
export const VALIDATOR_FAILED = 'VALIDATOR'

/** Codes of the Khronos validator for images in an unknown format. */
const UNKNOWN_FORMAT = ['VALUE_NOT_IN_LIST', 'IMAGE_UNRECOGNIZED_FORMAT']

/**
 * Runs the Khronos validator. Drops its findings about the extension and KTX 2 images, which it does not know; `checkWrinkles` checks
 * them.
 *
 * @param glb result of `openGlb`. The validator gets the original bytes, before external files were embedded.
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

/** Maps external files by normalised path, because the validator requests them by normalised URI. */
function filesOf(references: Glb['references']): Map<string, Uint8Array> {
  const files = [...references].filter(([, { path }]) => path !== undefined)
  return new Map(files.map(([uri, { bytes }]) => [normalised(unescaped(uri).replaceAll('\\', '/')), bytes]))
}
