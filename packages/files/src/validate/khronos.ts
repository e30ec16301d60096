import { WRINKLE_MAPS } from 'furrow/internal'
import { runValidator } from '#validator'
import { normalised, unescaped } from '../base/references.ts'
import type { Glb } from '../gltf/glb.ts'
import { errorFinding, type Finding, warningFinding } from './finding.ts'

/** Limit of the Khronos validator. */
const MAX_ISSUES = 1000

/** It takes about a tenth of this. */
const SECONDS = 10
const SECONDS_PER_MB = 1

/** Code of the finding that the validator did not come to its end. */
export const GAVE_UP = 'VALIDATOR'

/** Codes of the Khronos validator for images in a format that it does not know. */
const UNKNOWN_FORMAT = ['VALUE_NOT_IN_LIST', 'IMAGE_UNRECOGNIZED_FORMAT']

/**
 * Errors and warnings of the Khronos validator, except those about what it does not know: the extension and KTX 2 images, which
 * `checkWrinkles` checks.
 *
 * @param glb as `openGlb` opens it; the file is validated as it was before its parts were joined.
 */
export async function runKhronosValidator({ json, bytes, references }: Glb): Promise<Finding[]> {
  const seconds = Math.ceil(SECONDS + (SECONDS_PER_MB * bytes.length) / 1e6)
  const task = { bytes: Uint8Array.from(bytes), files: filesOf(references), maxIssues: MAX_ISSUES }
  const { issues, failure } = await runValidator(task, seconds)
  if (!issues) return [errorFinding(GAVE_UP, `the Khronos validator gave up: ${failure}`)]
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

/** The files that a file refers to by their paths: the validator asks for them by URIs that it has normalised. */
function filesOf(references: Glb['references']): Map<string, Uint8Array> {
  const files = [...references].filter(([, { path }]) => path !== undefined)
  return new Map(files.map(([uri, { bytes }]) => [normalised(unescaped(uri).replaceAll('\\', '/')), bytes]))
}
