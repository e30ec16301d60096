import { readFile } from 'node:fs/promises'
import { dirname, join } from 'node:path'
import { WRINKLE_MAPS } from 'furrow'
import { validateBytes } from 'gltf-validator'
import { createCommand } from '../command.ts'
import { type Glb, readGlbFile } from '../gltf/glb-file.ts'
import { checkWrinkles, type Finding } from '../wrinkles/rules.ts'

const WHO = 'furrow validate'

/** Limit of the Khronos validator. */
const MAX_ISSUES = 1000

/** Codes of the Khronos validator for images in a format that it does not know. */
const UNKNOWN_FORMAT = ['VALUE_NOT_IN_LIST', 'IMAGE_UNRECOGNIZED_FORMAT']

/** `furrow validate`: checks a file. */
export const validateCommand = createCommand('validate')
  .description('check a face with the Khronos validator, and its wrinkles by the rules of the extension')
  .argument('<face>', 'a face with wrinkles (.glb)')
  .option('--json', 'print the result as JSON')
  .addHelpText(
    'after',
    `
The exit code is 1 if there are errors, and 0 if there are only warnings.

Example:
  $ furrow validate wrinkled.glb`,
  )
  .action(validate)

async function validate(path: string, { json }: { json?: boolean }): Promise<void> {
  const glb = await readGlbFile(path, WHO)
  const findings = [...(await runKhronosValidator(path, glb)), ...(await checkWrinkles(glb))]
  const errors = findings.filter(({ severity }) => severity === 'error').length
  const warnings = findings.length - errors
  if (errors > 0) process.exitCode = 1
  const text = json
    ? JSON.stringify({ file: path, errors, warnings, findings })
    : [
        ...findings.map(findingText),
        `${path}: ${counted(errors, 'error')}, ${counted(warnings, 'warning')}`,
      ].join('\n')
  process.stdout.write(`${text}\n`)
}

/**
 * Errors and warnings of the Khronos validator, except those about what it does not know: the extension and KTX 2
 * images, which `checkWrinkles` checks.
 */
async function runKhronosValidator(path: string, { json }: Glb): Promise<Finding[]> {
  const bytes = new Uint8Array(await readFile(path))
  const { issues } = await validateBytes(bytes, {
    maxIssues: MAX_ISSUES,
    externalResourceFunction: async (uri) =>
      new Uint8Array(await readFile(join(dirname(path), decodeURI(uri)))),
  })
  return issues.messages
    .filter(({ severity, message }) => severity < 2 && !message.includes(WRINKLE_MAPS))
    .filter(({ code, pointer = '' }) => {
      const image = json.images?.[Number(/^\/images\/(\d+)/.exec(pointer)?.[1])]
      return !(UNKNOWN_FORMAT.includes(code) && image?.mimeType === 'image/ktx2')
    })
    .map(({ code, message, severity, pointer }) => ({
      severity: severity === 0 ? 'error' : 'warning',
      code,
      message,
      ...(pointer && { pointer }),
    }))
}

function findingText({ severity, code, message, pointer }: Finding): string {
  return `${severity}: ${pointer ? `${pointer}: ` : ''}${message} (${code})`
}

function counted(count: number, what: string): string {
  return `${count} ${what}${count === 1 ? '' : 's'}`
}
