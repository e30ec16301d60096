import { readFile } from 'node:fs/promises'
import { dirname, join } from 'node:path'
import { Command } from 'commander'
import { WRINKLE_MAPS } from 'furrow'
import { validateBytes } from 'gltf-validator'
import { type Glb, readGlbFile } from '../wrinkles/glb-file.ts'
import { checkWrinkles, type Finding } from '../wrinkles/rules.ts'

const WHO = 'furrow validate'

/** More of them help nobody. */
const MOST_ISSUES = 1000

/** `furrow validate`: is this file sound? */
export const validateCommand = new Command('validate')
  .description('check a face: the Khronos validator, and the rules of its wrinkles')
  .argument('<face>', 'a face with wrinkles (.glb)')
  .option('--json', 'print it as JSON')
  .addHelpText(
    'after',
    `
The exit code is 1 when there are errors; warnings leave it 0.

Example:
  $ furrow validate faces/human.glb`,
  )
  .action(validate)

/** What it says of an image in a format that it does not know. */
const UNKNOWN_FORMAT = ['VALUE_NOT_IN_LIST', 'IMAGE_UNRECOGNIZED_FORMAT']

async function validate(path: string, { json }: { json?: boolean }): Promise<void> {
  const glb = await readGlbFile(path, WHO)
  const findings = [...(await askKhronos(path, glb)), ...(await checkWrinkles(glb))]
  const errors = findings.filter(({ severity }) => severity === 'error').length
  const warnings = findings.length - errors
  if (errors > 0) process.exitCode = 1
  const text = json
    ? JSON.stringify({ file: path, errors, warnings, findings })
    : [...findings.map(line), `${path}: ${counted(errors, 'error')}, ${counted(warnings, 'warning')}`].join(
        '\n',
      )
  process.stdout.write(`${text}\n`)
}

/**
 * Errors and warnings of the Khronos validator. That it knows neither the extension nor KTX 2 images is no fault of the file; those
 * are decoded by our own rules.
 */
async function askKhronos(path: string, { json }: Glb): Promise<Finding[]> {
  const bytes = new Uint8Array(await readFile(path))
  const { issues } = await validateBytes(bytes, {
    maxIssues: MOST_ISSUES,
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

function line({ severity, code, message, pointer }: Finding): string {
  return `${severity}: ${pointer ? `${pointer}: ` : ''}${message} (${code})`
}

function counted(count: number, what: string): string {
  return `${count} ${what}${count === 1 ? '' : 's'}`
}
